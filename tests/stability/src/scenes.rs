//! Geometry without a scene file, and what a search finds in it.

use glam::{DVec3, Vec3};
use ray_casting::{
    Attributes, Camera, Geometry, Hit, Intersect, LinearSearch, Ray, Rgb, Scene, Sphere,
    SurfacePoint,
};
use workbench::{Exposure, Unwatched};

/// Triangles with vertices of their own.
#[must_use]
pub fn triangles(corners: &[[Vec3; 3]]) -> Geometry {
    let indices = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    Geometry {
        vertices: corners.iter().flatten().copied().collect(),
        triangles: indices.collect(),
        spheres: Vec::new(),
    }
}

/// Spheres and nothing else.
#[must_use]
pub fn spheres(spheres: &[Sphere]) -> Geometry {
    Geometry { spheres: spheres.to_vec(), ..Geometry::default() }
}

/// A scene in which nothing but the geometry matters.
#[must_use]
pub fn scene(geometry: Geometry) -> Scene {
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

/// The nearest hit, by looking at every primitive.
#[must_use]
pub fn nearest(geometry: &Geometry, ray: &Ray) -> Option<Hit> {
    LinearSearch::new(geometry, &Unwatched).intersect(ray)
}

/// The nearest surface point, likewise.
#[must_use]
pub fn surface(scene: &Scene, ray: &Ray) -> Option<SurfacePoint> {
    nearest(&scene.geometry, ray).map(|hit| scene.surface(ray, &hit))
}

/// A ray of unit direction from `origin` to `target`; `None` if they are the same point.
#[must_use]
pub fn toward(origin: Vec3, target: Vec3) -> Option<Ray> {
    let direction = (target.as_dvec3() - origin.as_dvec3()).normalize_or(DVec3::ZERO).as_vec3();
    (direction != Vec3::ZERO).then(|| Ray::new(origin, direction))
}
