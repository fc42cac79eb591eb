//! A primitive as the builders see it.

use glam::Vec3;
use ray_casting::{Geometry, Interval};

use crate::aabb::Aabb;

/// A primitive's box and its name.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// The smallest box around it.
    pub bounds: Aabb,
    /// Its index in the geometry.
    pub primitive: u32,
}

impl Item {
    /// Every primitive that a ray could hit: those with an infinite or undefined corner are left
    /// out, since one such box would make all boxes around it useless. So are spheres that reach
    /// beyond the largest number, which [`SceneFile`](workbench::SceneFile) refuses.
    #[must_use]
    pub fn all(geometry: &Geometry) -> Vec<Self> {
        (0..geometry.primitives())
            .map(|primitive| Self { bounds: bounds(geometry, primitive), primitive })
            .filter(|item| item.bounds.min.is_finite() && item.bounds.max.is_finite())
            .collect()
    }

    /// Twice the middle of the box: halving changes no comparison.
    #[inline]
    #[must_use]
    pub fn doubled_center(&self) -> Vec3 {
        self.bounds.min + self.bounds.max
    }
}

/// The box around one primitive; a sphere's is rounded outward.
fn bounds(geometry: &Geometry, primitive: u32) -> Aabb {
    match geometry.sphere(primitive) {
        None => {
            let corners = geometry.corners(primitive);
            if corners.iter().all(|v| v.is_finite()) { Aabb::around(&corners) } else { Aabb::EMPTY }
        }
        Some(sphere) => {
            let low = (sphere.center - sphere.radius).to_array();
            let high = (sphere.center + sphere.radius).to_array();
            Aabb {
                min: Vec3::from_array(low.map(f32::next_down)),
                max: Vec3::from_array(high.map(f32::next_up)),
            }
        }
    }
}

/// How far the items reach along `direction`, relative to `origin`, rounded outward.
///
/// Double precision makes the sums nearly exact; one step outward covers the final rounding.
#[must_use]
pub(crate) fn extent_along(
    direction: Vec3,
    origin: Vec3,
    items: &[Item],
    geometry: &Geometry,
) -> Interval {
    let (n, origin) = (direction.as_dvec3(), origin.as_dvec3());
    let (mut min, mut max) = (f64::INFINITY, f64::NEG_INFINITY);
    for item in items {
        match geometry.sphere(item.primitive) {
            None => {
                for vertex in geometry.corners(item.primitive) {
                    let x = n.dot(vertex.as_dvec3() - origin);
                    (min, max) = (min.min(x), max.max(x));
                }
            }
            Some(sphere) => {
                let x = n.dot(sphere.center.as_dvec3() - origin);
                let r = f64::from(sphere.radius) * n.length();
                (min, max) = (min.min(x - r), max.max(x + r));
            }
        }
    }
    Interval::new((min as f32).next_down(), (max as f32).next_up())
}
