//! Lamps as distributions of directions, and the rays that ask for them.

mod cones;
mod densities;
mod directions;
mod scenes;
mod shadow_rays;
mod which_lights;
