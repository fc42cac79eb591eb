//! Random numbers, units in the last place, and scenes without a file.

use glam::{DVec3, Vec3};
use ray_casting::{
    Attributes, Camera, Geometry, Hit, Intersect, LinearSearch, Ray, Rgb, Scene, Sphere,
    SurfacePoint,
};
use workbench::{Exposure, Sampler, Unwatched};

/// A point of the cube from −1 to 1.
pub(crate) fn in_cube(sampler: &mut Sampler) -> Vec3 {
    2.0 * Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d()) - 1.0
}

/// A unit vector, every direction equally likely: points outside the ball are thrown away.
pub(crate) fn direction(sampler: &mut Sampler) -> Vec3 {
    loop {
        let p = in_cube(sampler).as_dvec3();
        if (0.01..=1.0).contains(&p.length_squared()) {
            return p.normalize().as_vec3();
        }
    }
}

/// 10 to a power between `low` and `high`.
pub(crate) fn magnitude(sampler: &mut Sampler, low: f32, high: f32) -> f32 {
    10.0_f64.powf(f64::from(low + (high - low) * sampler.next_1d())) as f32
}

/// The distance from |`x`| to the next larger `f32`.
pub(crate) fn ulp(x: f32) -> f64 {
    f64::from(x.abs().next_up()) - f64::from(x.abs())
}

/// How many units in the last place `x` is off.
pub(crate) fn ulps(x: f32, exact: f64) -> f64 {
    (f64::from(x) - exact).abs() / ulp(exact as f32)
}

/// Triangles with vertices of their own.
pub(crate) fn triangles(corners: &[[Vec3; 3]]) -> Geometry {
    let indices = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    Geometry {
        vertices: corners.iter().flatten().copied().collect(),
        triangles: indices.collect(),
        spheres: Vec::new(),
    }
}

/// One sphere and nothing else.
pub(crate) fn sphere(center: Vec3, radius: f32) -> Geometry {
    Geometry { spheres: vec![Sphere { center, radius }], ..Geometry::default() }
}

/// A scene in which nothing but the geometry matters.
pub(crate) fn scene(geometry: Geometry) -> Scene {
    let materials = vec![0; geometry.primitives() as usize];
    Scene {
        camera: Camera {
            eye: Vec3::ZERO,
            forward: Vec3::NEG_Z,
            right: Vec3::X,
            up: Vec3::Y,
            half_height: 1.0,
        },
        focus: 1.0,
        exposure: Exposure { size: [1, 1], samples: None },
        geometry,
        attributes: Attributes { materials, ..Attributes::default() },
        materials: Vec::new(),
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::ZERO,
        background: Rgb::ZERO,
        notices: Vec::new(),
    }
}

/// The nearest hit.
pub(crate) fn nearest(geometry: &Geometry, ray: &Ray) -> Option<Hit> {
    LinearSearch::new(geometry, &Unwatched).intersect(ray)
}

/// The nearest surface point.
pub(crate) fn surface(scene: &Scene, ray: &Ray) -> Option<SurfacePoint> {
    nearest(&scene.geometry, ray).map(|hit| scene.surface(ray, &hit))
}

/// A ray from `origin` to `target`.
pub(crate) fn toward(origin: Vec3, target: Vec3) -> Ray {
    Ray::new(origin, (target - origin).normalize())
}

/// The unit normal of a triangle, in double precision.
pub(crate) fn exact_normal(corners: [Vec3; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|v| v.as_dvec3());
    (b - a).cross(c - a).normalize()
}
