//! What the stage draws.

use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::Scene;
use workbench::{FilmSettings, Unwatched};

use super::workload;
use crate::figures::Drawing;
use crate::picture::Picture;

fn draw(scene: &Scene, size: [u32; 2], samples: u32) -> Drawing {
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::default(), &Unwatched);
    let settings = FilmSettings { size, samples, seed: 0, threads: None };
    Picture::from(&workload::trace(scene, &tree, &settings)).into()
}

/// Sphere, mirror and teapot: the stage's own picture at a smaller size, and the project's.
pub(super) fn showpiece() -> Drawing {
    draw(&workload::scene("whitted-teapot"), [480, 300], 9)
}

/// The rods, so that a reader knows what the tables speak of.
pub(super) fn rods() -> Drawing {
    draw(&workload::rods(), [360, 240], 4)
}
