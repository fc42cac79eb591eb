//! What a search for the nearest surface has to remember.

use glam::Vec2;

// ANCHOR: hit
/// Where a ray met a primitive.
///
/// Only what the search itself knows: normal, texture coordinates and material are looked up once,
/// for the nearest hit, by [`Scene`](crate::Scene).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Ray parameter: the distance in scene units when the ray's direction has unit length.
    pub t: f32,
    /// Index of the primitive: triangles first, then spheres, as [`Geometry`](crate::Geometry)
    /// counts them.
    pub primitive: u32,
    /// Weights of a triangle's vertices 1 and 2 (vertex 0 has the rest); zero on a sphere.
    pub barycentric: Vec2,
}
// ANCHOR_END: hit
