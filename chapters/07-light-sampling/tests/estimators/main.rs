//! What the three estimators must agree on, with closed forms and with each other.

mod agreement;
mod closed_forms;
mod counts;
mod glass;
mod mistakes;
mod point_lights;
mod scenes;
