//! Scenes without a file, most of which have a known answer.

use glam::{Vec3, vec3};
use ray_casting::{Attributes, Camera, Geometry, Ray, Rgb, Scene, Sphere};
use workbench::{CameraRecord, Exposure, MaterialRecord};

/// A scene without anything in it, seen from `eye`.
pub(super) fn empty(eye: Vec3, target: Vec3, fov: f32, size: [u32; 2], sky: f32) -> Scene {
    let up = if (target - eye).cross(Vec3::Y) == Vec3::ZERO { Vec3::Z } else { Vec3::Y };
    let camera = CameraRecord {
        eye: eye.to_array(),
        target: target.to_array(),
        up: up.to_array(),
        fov,
        size,
    };
    Scene {
        camera: Camera::from(&camera),
        focus: eye.distance(target),
        exposure: Exposure { size, samples: None },
        geometry: Geometry::default(),
        attributes: Attributes::default(),
        materials: Vec::new(),
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::ZERO,
        background: Rgb::splat(sky),
        notices: Vec::new(),
    }
}

/// A surface that reflects `kd` and shines with `ke`.
pub(super) fn matte(kd: f32, ke: f32) -> MaterialRecord {
    MaterialRecord { kd: [kd; 3], ke: [ke; 3], ..MaterialRecord::new("matte") }
}

/// Adds a sphere of its own material.
pub(super) fn add_sphere(scene: &mut Scene, center: Vec3, radius: f32, material: MaterialRecord) {
    scene.geometry.spheres.push(Sphere { center, radius });
    scene.attributes.materials.push(scene.materials.len() as u32);
    scene.materials.push(material);
}

/// A wide floor at height 0. Call before any sphere: triangles are numbered first.
pub(super) fn add_floor(scene: &mut Scene, material: MaterialRecord) {
    let x = 1.0e3;
    scene
        .geometry
        .vertices
        .extend([[-x, x], [x, x], [x, -x], [-x, -x]].map(|[x, z]| vec3(x, 0.0, z)));
    scene.geometry.triangles.extend([[0, 1, 2], [0, 2, 3]]);
    scene.attributes.materials.extend([scene.materials.len() as u32; 2]);
    scene.materials.push(material);
}

/// A hollow sphere: a room that no ray leaves.
pub(super) fn hollow(albedo: f32) -> Scene {
    let mut scene = empty(Vec3::ZERO, Vec3::NEG_Z, 40.0, [1, 1], 0.0);
    add_sphere(&mut scene, Vec3::ZERO, 1.0, matte(albedo, 1.0));
    scene
}

/// A black lamp of radius 1 in a hollow sphere of radius 2. From everywhere on the wall the lamp
/// fills the same solid angle, 2π (1 − √¾), and the rest of the hemisphere is wall.
pub(super) fn lamp_in_hollow(albedo: f32) -> Scene {
    let mut scene = empty(vec3(0.0, 0.0, 1.5), vec3(0.45, 0.6, 2.7), 40.0, [1, 1], 0.0);
    add_sphere(&mut scene, Vec3::ZERO, 1.0, matte(0.0, 1.0));
    add_sphere(&mut scene, Vec3::ZERO, 2.0, matte(albedo, 0.0));
    scene
}

/// A black ball of radius 1 whose centre is 2 above a floor of this albedo, under a sky of 1: at
/// the point below, the ball hides the sky up to 30° from the zenith, a quarter of its light.
pub(super) fn eclipse(albedo: f32) -> Scene {
    let mut scene = empty(vec3(0.0, 0.5, 0.0), Vec3::ZERO, 40.0, [1, 1], 1.0);
    add_floor(&mut scene, matte(albedo, 0.0));
    add_sphere(&mut scene, vec3(0.0, 2.0, 0.0), 1.0, matte(0.0, 0.0));
    scene
}

/// The ray from the eye through the middle of the picture.
pub(super) fn ahead(scene: &Scene) -> Ray {
    scene.camera.ray(workbench::FilmPoint { x: 0.5, y: 0.5, size: [1, 1] })
}
