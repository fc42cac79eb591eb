//! What the recursion must get right, scene by scene.

mod closed_forms;
mod media;
mod scenes;
