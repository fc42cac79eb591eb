//! Scenes from text, and what a ray finds in them.

use std::fs;

use glam::Vec3;
use ray_casting::{Intersect, LinearSearch, Ray, Scene, SurfacePoint};
use workbench::Unwatched;

const CAMERA: &str = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [4, 3]\n\
                      [materials.white]\nkd = [1, 1, 1]\n[materials.lamp]\nke = [1, 2, 4]\n";

/// The scene with a camera, the materials `white` and `lamp`, and `records`; beside it the mesh
/// `a.obj`.
pub(crate) fn scene_with_mesh(records: &str, obj: &str) -> Scene {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("a.obj"), obj).expect("the mesh is written");
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("{CAMERA}{records}")).expect("the scene is written");
    Scene::load(&path).unwrap_or_else(|error| panic!("{error}, for:\n{records}"))
}

/// The same without a mesh.
pub(crate) fn scene(records: &str) -> Scene {
    scene_with_mesh(records, "")
}

/// The surface that the ray from `origin` along `direction` meets first.
pub(crate) fn surface(scene: &Scene, origin: Vec3, direction: Vec3) -> SurfacePoint {
    let ray = Ray::new(origin, direction.normalize());
    let hit = LinearSearch::new(&scene.geometry, &Unwatched).intersect(&ray);
    scene.surface(&ray, &hit.unwrap_or_else(|| panic!("{ray:?} misses")))
}
