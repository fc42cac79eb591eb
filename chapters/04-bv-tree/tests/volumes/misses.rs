//! A primitive that reports a hit at t lies in a volume whose interval contains t.

use bv_tree::{Aabb, BoundingVolume, KDop, Obb};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Ray, ShearedRay, Sphere};
use workbench::Sampler;

use crate::tools::{Enclosed, in_cube, magnitude, toward, triangles};

/// Some triangles and spheres: round, flat, long, tiny beside their distance from the origin.
fn content(i: u64, sampler: &mut Sampler) -> Geometry {
    let center = if i.is_multiple_of(2) { 100.0 * in_cube(sampler) } else { Vec3::ZERO };
    let scale = magnitude(sampler, 3.0);
    let stretch = match i % 5 {
        0 => vec3(1.0, 1.0, 0.0),
        1 => vec3(1.0, 1e-4, 1e-4),
        2 => vec3(0.0, 1.0, 0.0),
        _ => Vec3::ONE,
    };
    let corners: Vec<[Vec3; 3]> = (0..1 + i % 4)
        .map(|_| [(); 3].map(|()| center + scale * stretch * in_cube(sampler)))
        .collect();
    let mut geometry = triangles(&corners);
    if i.is_multiple_of(3) {
        let center = center + scale * in_cube(sampler);
        geometry.spheres.push(Sphere { center, radius: scale * (0.01 + sampler.next_1d()) });
    }
    geometry
}

/// Points that are hard to hit: corners, points of edges, and points near the outline of spheres.
fn targets(geometry: &Geometry, sampler: &mut Sampler) -> Vec<Vec3> {
    let mut targets = geometry.vertices.clone();
    for triangle in 0..geometry.triangles.len() as u32 {
        let [a, b, c] = geometry.corners(triangle);
        targets.extend([a.lerp(b, sampler.next_1d()), b.lerp(c, sampler.next_1d())]);
        targets.push((a + b + c) / 3.0);
    }
    for sphere in &geometry.spheres {
        for axis in Vec3::AXES {
            targets.push(sphere.center + sphere.radius * axis);
            targets.push(sphere.center - 0.999 * sphere.radius * axis);
        }
    }
    targets
}

/// Checks `V` around `count` different contents.
fn check<V: BoundingVolume>(name: &str, count: u64) {
    let mut hits = 0;
    for i in 0..count {
        let mut sampler = Sampler::new(3, i, 0);
        let geometry = content(i, &mut sampler);
        let enclosed = Enclosed::<V>::all_of(&geometry);
        for target in targets(&geometry, &mut sampler) {
            let size = enclosed.bounds.reach(target).max(1e-6);
            let away = magnitude(&mut sampler, 2.0) * size * in_cube(&mut sampler);
            let mut along = Vec3::ZERO;
            along[(i % 3) as usize] = 2.0 * size;
            // From afar, along an axis, and from a few floats beside the target.
            let beside = target.to_array().map(|x| match (sampler.next_1d() * 3.0) as u32 {
                0 => x.next_down(),
                1 => x,
                _ => x.next_up(),
            });
            for ray in [
                toward(target + away, target),
                Ray::new(target - along, along / (2.0 * size)),
                Ray::new(Vec3::from_array(beside), in_cube(&mut sampler).normalize_or(Vec3::X)),
            ] {
                hits += compare(name, &geometry, &enclosed, &ray);
            }
        }
    }
    assert!(hits >= 20_000, "{name}: only {hits} hits");
}

/// Asserts that what is hit lies inside; how many hits that were.
fn compare<V: BoundingVolume>(name: &str, geometry: &Geometry, v: &Enclosed<V>, ray: &Ray) -> u32 {
    let (prepared, inside) = (ShearedRay::new(ray), v.clip(ray));
    let mut hits = 0;
    for primitive in 0..geometry.primitives() {
        let Some(hit) = geometry.intersect_primitive(&prepared, primitive) else { continue };
        hits += 1;
        assert!(
            inside.contains(hit.t),
            "{name}: {hit:?} outside of {inside:?}\n{ray:?}\n{geometry:?}"
        );
    }
    hits
}

/// accuracy B9, O8, K4.
#[test]
fn no_hit_lies_outside_of_a_box() {
    check::<Aabb>("AABB", 6000);
}

#[test]
fn no_hit_lies_outside_of_an_oriented_box() {
    check::<Obb>("OBB", 6000);
}

#[test]
fn no_hit_lies_outside_of_a_polytope() {
    check::<KDop<3>>("6-DOP", 3000);
    check::<KDop<7>>("14-DOP", 3000);
    check::<KDop<9>>("18-DOP", 3000);
    check::<KDop<13>>("26-DOP", 3000);
}
