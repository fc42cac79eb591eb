//! What triangles carry besides their shape: materials, normals, texture coordinates.

use glam::{Vec2, Vec3};

/// Looked up for the nearest hit only, and only when the shading asks.
#[derive(Clone, Debug, Default)]
pub struct Attributes {
    /// Material of each primitive: an index into [`Scene::materials`](crate::Scene::materials).
    pub materials: Vec<u32>,
    /// Unit normal at each vertex; zero, or past the end of the list, where the file gives none.
    pub normals: Vec<Vec3>,
    /// Texture coordinates at each vertex; past the end of the list where the file gives none.
    pub texture_coordinates: Vec<Vec2>,
}

impl Attributes {
    /// The interpolated normal (not normalised), zero where there is none.
    #[must_use]
    pub fn normal(&self, corners: [u32; 3], barycentric: Vec2) -> Vec3 {
        interpolate(&self.normals, corners, barycentric)
    }

    /// The interpolated texture coordinates, zero where there are none.
    #[must_use]
    pub fn texture_coordinates(&self, corners: [u32; 3], barycentric: Vec2) -> Vec2 {
        interpolate(&self.texture_coordinates, corners, barycentric)
    }
}

/// (1 − b₁ − b₂) v₀ + b₁ v₁ + b₂ v₂
fn interpolate<T>(values: &[T], corners: [u32; 3], barycentric: Vec2) -> T
where
    T: Copy + Default + std::ops::Mul<f32, Output = T> + std::ops::Add<Output = T>,
{
    let [v0, v1, v2] = corners.map(|i| values.get(i as usize).copied().unwrap_or_default());
    v0 * (1.0 - barycentric.x - barycentric.y) + v1 * barycentric.x + v2 * barycentric.y
}
