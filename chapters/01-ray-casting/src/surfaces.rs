//! The surfaces of a scene, made ready for many hits.

use glam::{Vec2, Vec3};

use crate::exact_point::ExactPoint;
use crate::hit::Hit;
use crate::ray::Ray;
use crate::scene::Scene;
use crate::surface_point::SurfacePoint;

/// A scene whose triangles have their normals computed once, for a render that hits each many times:
/// 12 bytes a triangle, for a root and a division a hit. [`Scene::surface`] is the plain way.
pub struct Surfaces<'a> {
    scene: &'a Scene,
    /// The unit normal of the front of each triangle.
    normals: Vec<Vec3>,
}

impl<'a> Surfaces<'a> {
    /// Computes the normals. They are those of the scene as it is now.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        let geometry = &scene.geometry;
        let normal = |i| ExactPoint::of_triangle(geometry.corners(i), Vec2::ZERO).normal.as_vec3();
        Self { scene, normals: (0..geometry.triangles.len() as u32).map(normal).collect() }
    }

    /// As [`Scene::surface`], to the last bit.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, ray: &Ray, hit: &Hit) -> SurfacePoint {
        let Some(&normal) = self.normals.get(hit.primitive as usize) else {
            return self.scene.surface(ray, hit);
        };
        let corners = self.scene.geometry.corners(hit.primitive);
        let ExactPoint { position, extent, .. } = ExactPoint::of_triangle(corners, hit.barycentric);
        self.scene.surface_at(position, extent, normal, ray, hit)
    }
}
