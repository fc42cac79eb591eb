//! Lamps without a room, and points that look at them.

use glam::{Vec2, Vec3};
use ray_casting::{
    Attributes, Camera, Geometry, Hit, PointLight, Rgb, Scene, Sphere, SurfacePoint,
};
use workbench::{CameraRecord, Exposure, MaterialRecord, Sampler};

/// The material of lamps in [`empty`].
pub(crate) const LAMP: u32 = 0;

/// The material of everything else.
pub(crate) const MATTE: u32 = 1;

/// Nothing in the dark.
pub(crate) fn empty() -> Scene {
    let camera = CameraRecord {
        eye: [0.0, 0.0, 5.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov: 40.0,
        size: [4, 4],
    };
    let lamp = MaterialRecord { ke: [1.0; 3], ..MaterialRecord::new("lamp") };
    let matte = MaterialRecord { kd: [0.5; 3], ..MaterialRecord::new("matte") };
    Scene {
        camera: Camera::from(&camera),
        focus: 5.0,
        exposure: Exposure { size: camera.size, samples: None },
        geometry: Geometry::default(),
        attributes: Attributes::default(),
        materials: vec![lamp, matte],
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::ZERO,
        background: Rgb::ZERO,
        notices: Vec::new(),
    }
}

/// Call before any sphere: triangles are numbered first.
pub(crate) fn add_triangle(scene: &mut Scene, vertices: [Vec3; 3], material: u32) {
    let first = scene.geometry.vertices.len() as u32;
    scene.geometry.vertices.extend(vertices);
    scene.geometry.triangles.push([first, first + 1, first + 2]);
    scene.attributes.materials.push(material);
}

/// Two triangles; call before any sphere.
pub(crate) fn add_quad(scene: &mut Scene, vertices: [Vec3; 4], material: u32) {
    let first = scene.geometry.vertices.len() as u32;
    scene.geometry.vertices.extend(vertices);
    let halves = [[0, 1, 2], [0, 2, 3]].map(|half| half.map(|vertex| first + vertex));
    scene.geometry.triangles.extend(halves);
    scene.attributes.materials.extend([material; 2]);
}

pub(crate) fn add_sphere(scene: &mut Scene, center: Vec3, radius: f32, material: u32) {
    scene.geometry.spheres.push(Sphere { center, radius });
    scene.attributes.materials.push(material);
}

pub(crate) fn add_point_light(scene: &mut Scene, position: Vec3, intensity: f32) {
    scene.lights.push(PointLight::new(position, Rgb::splat(intensity)));
}

/// A point of a surface that is nowhere in the scene, seen from its front.
pub(crate) fn viewer(position: Vec3, normal: Vec3) -> SurfacePoint {
    SurfacePoint {
        position,
        position_error: Vec3::ZERO,
        geometric_normal: normal,
        wo: normal,
        material: MATTE,
        hit: Hit { t: 1.0, primitive: u32::MAX, barycentric: Vec2::ZERO },
    }
}

/// The same for a point of the lamp `primitive`, seen along `wi`.
pub(crate) fn seen(primitive: u32, position: Vec3, normal: Vec3, wi: Vec3) -> SurfacePoint {
    let hit = Hit { t: 1.0, primitive, barycentric: Vec2::ZERO };
    SurfacePoint { wo: -wi, material: LAMP, hit, ..viewer(position, normal) }
}

/// A point of the ball of radius 1.
pub(crate) fn in_ball(sampler: &mut Sampler) -> Vec3 {
    loop {
        let [x, y] = sampler.next_2d().map(|u| 2.0 * u - 1.0);
        let point = Vec3::new(x, y, 2.0 * sampler.next_1d() - 1.0);
        if point.length_squared() <= 1.0 && point != Vec3::ZERO {
            return point;
        }
    }
}
