//! Rays that are hard to answer.

use glam::Vec3;
use workbench::Sampler;

use crate::geometry::Geometry;
use crate::ray::Ray;

/// How many rays of each random kind.
const RAYS: u64 = 250;

/// How far from their targets rays start, compared to the size of the geometry.
const DISTANCES: [f32; 6] = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0];

/// Rays for `geometry`: random, along the axes, aimed at vertices and edges, and broken ones.
pub(super) fn all(geometry: &Geometry) -> Vec<Ray> {
    let mut sampler =
        Sampler::new(2, geometry.vertices.len() as u64, u64::from(geometry.primitives()));
    let targets = targets(geometry);
    let (center, size) = extent(&targets);
    let mut rays = broken();
    for _ in 0..RAYS {
        let origin = center + size * 1.5 * in_cube(&mut sampler);
        let target = pick(&targets, &mut sampler);
        let other = pick(&targets, &mut sampler);
        rays.push(Ray::new(origin, in_cube(&mut sampler).normalize_or(Vec3::Z)));
        rays.push(Ray::new(origin, (target - origin).normalize_or(Vec3::X)));
        rays.push(Ray::new(origin, (target.midpoint(other) - origin).normalize_or(Vec3::Y)));
        rays.push(Ray::new(target, (other - target).normalize_or(Vec3::Z)));
        // From far away and from close by: a direction is rounded, and so the ray passes its target
        // at a distance that grows with the way.
        for target in [target, other] {
            let away = pick(&DISTANCES, &mut sampler) * size * in_cube(&mut sampler);
            rays.push(Ray::new(target + away, (-away).normalize_or(Vec3::Z)));
        }
        for axis in Vec3::AXES {
            rays.push(Ray::new(target - axis * size, axis));
            rays.push(Ray::new(target + axis * size, -axis));
        }
    }
    rays.retain(|ray| ray.origin.is_finite() || ray.direction == Vec3::X);
    rays
}

/// Every vertex, every middle of an edge, and six points of every sphere; never empty.
fn targets(geometry: &Geometry) -> Vec<Vec3> {
    let mut targets = vec![Vec3::ZERO];
    for triangle in 0..geometry.triangles.len() as u32 {
        let [a, b, c] = geometry.corners(triangle);
        targets.extend([a, b, c, a.midpoint(b), b.midpoint(c), (a + b + c) / 3.0]);
    }
    for sphere in &geometry.spheres {
        targets.extend(Vec3::AXES.map(|axis| sphere.center + sphere.radius * axis));
        targets.extend(Vec3::AXES.map(|axis| sphere.center - sphere.radius * axis));
    }
    targets.retain(|p| p.is_finite() && p.abs().max_element() < 1e30);
    targets
}

fn extent(points: &[Vec3]) -> (Vec3, f32) {
    let min = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let max = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    (min.midpoint(max), (max - min).max_element().max(1.0))
}

fn pick<T: Copy>(choices: &[T], sampler: &mut Sampler) -> T {
    choices[(sampler.next_1d() * choices.len() as f32) as usize % choices.len()]
}

/// A point of the cube from −1 to 1.
pub(super) fn in_cube(sampler: &mut Sampler) -> Vec3 {
    2.0 * Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d()) - 1.0
}

/// Rays that no search may hit anything with, or hang on.
fn broken() -> Vec<Ray> {
    let mut rays = Vec::new();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        rays.push(Ray::new(Vec3::splat(bad), Vec3::X));
        rays.push(Ray::new(Vec3::new(0.0, bad, 0.0), Vec3::X));
        rays.push(Ray::new(Vec3::ZERO, Vec3::new(bad, 0.0, 0.0)));
        rays.push(Ray::new(Vec3::ZERO, Vec3::splat(bad)));
    }
    rays.push(Ray::new(Vec3::ZERO, Vec3::ZERO));
    rays
}
