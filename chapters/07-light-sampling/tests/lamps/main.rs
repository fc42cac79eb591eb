//! Lamps as distributions of directions, and the rays that ask for them.

mod between;
mod choices;
mod cones;
mod densities;
mod directions;
mod scenes;
mod shadow_rays;
mod solid_angles;
mod which_lights;
