//! Scenes without a file, for which the right answer is known.

use glam::{Vec3, vec3};
use ray_casting::{Attributes, Camera, Geometry, Ray, Rgb, Scene};
use workbench::{CameraRecord, Exposure, MaterialRecord};

use super::stage::scene;

/// Adds a quad. Call before any sphere: triangles are numbered first.
fn add_quad(scene: &mut Scene, vertices: [Vec3; 4], material: u32) {
    let first = scene.geometry.vertices.len() as u32;
    scene.geometry.vertices.extend(vertices);
    scene.geometry.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| first + i)));
    scene.attributes.materials.extend([material; 2]);
}

/// Two wide plates that face each other: as good as a closed room. They shine with 1.
pub(super) fn furnace(albedo: f32) -> Scene {
    let camera = CameraRecord {
        eye: [0.0; 3],
        target: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        fov: 40.0,
        size: [1, 1],
    };
    let all = MaterialRecord { kd: [albedo; 3], ke: [1.0; 3], ..MaterialRecord::new("all") };
    let mut scene = Scene {
        camera: Camera::from(&camera),
        focus: 1.0,
        exposure: Exposure { size: camera.size, samples: None },
        geometry: Geometry::default(),
        attributes: Attributes::default(),
        materials: vec![all],
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::ZERO,
        background: Rgb::ZERO,
        notices: Vec::new(),
    };
    for z in [1.0_f32, -1.0] {
        let (x, y) = (1.0e4, -1.0e4 * z);
        let corners = [vec3(-x, -y, z), vec3(x, -y, z), vec3(x, y, z), vec3(-x, y, z)];
        add_quad(&mut scene, corners, 0);
    }
    scene
}

/// The camera's ray in [`furnace`].
pub(super) fn down() -> Ray {
    Ray::new(Vec3::ZERO, Vec3::NEG_Z)
}

/// The Cornell box, closed by a white front wall before which the eye stands, with a lamp that
/// fills most of the ceiling, so that a path finds it soon, and that is no brighter than white.
pub(crate) fn closed_box() -> Scene {
    let mut scene = scene("cornell-box");
    let shines = |scene: &Scene, m: u32| scene.materials[m as usize].ke != [0.0; 3];
    let lamp = scene.attributes.materials.iter().position(|&m| shines(&scene, m));
    let lamp = lamp.expect("the box has a lamp");
    let mut corners = [scene.geometry.triangles[lamp], scene.geometry.triangles[lamp + 1]].concat();
    corners.sort_unstable();
    corners.dedup();
    for corner in corners {
        let v = &mut scene.geometry.vertices[corner as usize];
        v.x = if v.x > 2.78 { 4.8 } else { 0.76 };
        v.z = if v.z > 2.78 { 4.8 } else { 0.76 };
    }
    scene.materials[scene.attributes.materials[lamp] as usize].ke = [0.9, 0.75, 0.5];
    let white = scene.attributes.materials[0];
    let wall =
        [vec3(0.0, 0.0, 0.0), vec3(5.56, 0.0, 0.0), vec3(5.56, 5.488, 0.0), vec3(0.0, 5.488, 0.0)];
    add_quad(&mut scene, wall, white);
    let camera = CameraRecord {
        eye: [2.78, 2.73, 0.05],
        target: [2.78, 2.5, 3.0],
        up: [0.0, 1.0, 0.0],
        fov: 80.0,
        size: [96, 96],
    };
    scene.camera = Camera::from(&camera);
    scene
}
