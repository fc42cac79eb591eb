//! The ray-triangle test of Möller and Trumbore, the review's \[11], kept to be compared.
//!
//! It computes the two weights of the hit from the triangle's own edges. Each triangle rounds in
//! its own way, so of two neighbours each may deny a ray that passes through their common edge: a
//! tenth of the rays aimed at edges slip through a closed mesh. Chapter 1 shows the seams; the
//! course renders with [`triangle`](crate::triangle) instead.

use glam::{Vec2, Vec3};

use crate::hit::Hit;
use crate::ray::Ray;

// ANCHOR: intersect
/// The hit of `ray` on the triangle with these vertices, if `ray.extent` admits it.
///
/// Cramer's rule for **o** + t **d** = (1 − u − v) **v**₀ + u **v**₁ + v **v**₂, with
/// **e**₁ = **v**₁ − **v**₀, **e**₂ = **v**₂ − **v**₀ and **s** = **o** − **v**₀
/// \[MollerTrumbore97]:
///
/// ```text
/// p = d × e₂,  q = s × e₁,  det = e₁·p,   u = s·p / det,  v = d·q / det,  t = e₂·q / det
/// ```
#[must_use]
pub fn intersect(ray: &Ray, vertices: [Vec3; 3], primitive: u32) -> Option<Hit> {
    let [v0, v1, v2] = vertices;
    let (e1, e2) = (v1 - v0, v2 - v0);
    let p = ray.direction.cross(e2);
    let det = e1.dot(p);
    if det == 0.0 {
        return None;
    }
    let s = ray.origin - v0;
    let q = s.cross(e1);
    let (u, v) = (s.dot(p) / det, ray.direction.dot(q) / det);
    let t = e2.dot(q) / det;
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    (inside && ray.admits(t)).then_some(Hit { t, primitive, barycentric: Vec2::new(u, v) })
}
// ANCHOR_END: intersect
