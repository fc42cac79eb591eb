//! Volumes around given geometry, and rays.

use bv_tree::{Aabb, BoundingVolume, Item};
use glam::{DVec3, Vec3};
use ray_casting::{Geometry, Interval, Ray};
use workbench::Sampler;

/// A point of the cube from −1 to 1.
pub(crate) fn in_cube(sampler: &mut Sampler) -> Vec3 {
    2.0 * Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d()) - 1.0
}

/// 10 to a power between −`range` and `range`.
pub(crate) fn magnitude(sampler: &mut Sampler, range: f32) -> f32 {
    10.0_f32.powf(range * (2.0 * sampler.next_1d() - 1.0))
}

/// A ray from `origin` to `target`.
pub(crate) fn toward(origin: Vec3, target: Vec3) -> Ray {
    let direction = (target.as_dvec3() - origin.as_dvec3()).normalize();
    Ray::new(origin, direction.as_vec3())
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

/// A volume, and the box around what it encloses.
pub(crate) struct Enclosed<V> {
    pub(crate) volume: V,
    pub(crate) bounds: Aabb,
}

impl<V: BoundingVolume> Enclosed<V> {
    /// The volume around everything in `geometry`.
    pub(crate) fn all_of(geometry: &Geometry) -> Self {
        let items = Item::all(geometry);
        let bounds = items.iter().fold(Aabb::EMPTY, |all, item| all.union(&item.bounds));
        Self { volume: V::enclosing(&bounds, &items, geometry), bounds }
    }

    /// The t for which the ray is inside.
    pub(crate) fn clip(&self, ray: &Ray) -> Interval {
        self.volume.clip(&V::query(ray, self.bounds.reach(ray.origin)))
    }
}

/// The box itself as a volume.
pub(crate) fn boxed(min: Vec3, max: Vec3) -> Enclosed<Aabb> {
    let volume = Aabb { min, max };
    Enclosed { volume, bounds: volume }
}

/// The t ≥ 0 for which the ray is inside the box, in double precision; `None` if it misses.
pub(crate) fn exact_clip(volume: &Aabb, ray: &Ray) -> Option<[f64; 2]> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (min, max): (DVec3, DVec3) = (volume.min.as_dvec3(), volume.max.as_dvec3());
    let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
    for i in 0..3 {
        if d[i] == 0.0 {
            if o[i] < min[i] || o[i] > max[i] {
                return None;
            }
            continue;
        }
        let (a, b) = ((min[i] - o[i]) / d[i], (max[i] - o[i]) / d[i]);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    (enter <= leave).then_some([enter, leave])
}
