//! All the primitives of a scene, as flat arrays.

use glam::{Vec2, Vec3};

use crate::exact_point::ExactPoint;
use crate::hit::Hit;
use crate::ray::Ray;
use crate::sphere::Sphere;
use crate::triangle::{self, ShearedRay};

/// Triangles that share vertices, and spheres.
///
/// Primitive `i` is triangle `i` as long as there are that many; the spheres are counted on from
/// there.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// Corners, in scene units.
    pub vertices: Vec<Vec3>,
    /// Three indices into `vertices` for each triangle, counter-clockwise seen from its front. None
    /// is without area: three corners on a line may be hit, by the roundings of the test, and have
    /// no normal.
    pub triangles: Vec<[u32; 3]>,
    /// Analytic spheres.
    pub spheres: Vec<Sphere>,
}

impl Geometry {
    /// How many primitives there are.
    #[inline]
    #[must_use]
    pub fn primitives(&self) -> u32 {
        (self.triangles.len() + self.spheres.len()) as u32
    }

    /// The corners of a triangle.
    #[inline]
    #[must_use]
    pub fn corners(&self, triangle: u32) -> [Vec3; 3] {
        // Without `map`, which the compiler may make a call.
        let vertex = |index: u32| self.vertices[index as usize];
        let [a, b, c] = self.triangles[triangle as usize];
        [vertex(a), vertex(b), vertex(c)]
    }

    /// The sphere with this primitive index, if it is one.
    #[inline]
    #[must_use]
    pub fn sphere(&self, primitive: u32) -> Option<&Sphere> {
        self.spheres.get((primitive as usize).checked_sub(self.triangles.len())?)
    }

    /// The hit of `ray` on one primitive.
    #[inline]
    #[must_use]
    pub fn intersect_primitive(&self, ray: &ShearedRay, primitive: u32) -> Option<Hit> {
        match self.sphere(primitive) {
            None => triangle::intersect(ray, &self.corners(primitive), primitive),
            Some(sphere) => intersect_sphere(sphere, &ray.ray, primitive),
        }
    }

    /// Where `ray` has been found to hit.
    #[inline(always)]
    #[must_use]
    pub fn point(&self, ray: &Ray, hit: &Hit) -> ExactPoint {
        match self.sphere(hit.primitive) {
            None => ExactPoint::of_triangle(self.corners(hit.primitive), hit.barycentric),
            Some(sphere) => ExactPoint::of_sphere(sphere, ray, hit.t),
        }
    }
}

/// The hit of `ray` on `sphere`, under the name `primitive`.
#[inline]
#[must_use]
pub fn intersect_sphere(sphere: &Sphere, ray: &Ray, primitive: u32) -> Option<Hit> {
    let t = sphere.intersect(ray)?;
    Some(Hit { t, primitive, barycentric: Vec2::ZERO })
}
