//! Two volumes tested together give the very bits of each tested alone.

use bv_tree::{Aabb, BoundingVolume, KDop, Obb};
use glam::Vec3;
use ray_casting::{Interval, Ray};
use workbench::Sampler;

use crate::tools::{Enclosed, boxed, in_cube, magnitude, triangles};

/// Components that break careless arithmetic.
const ODD: [f32; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-30,
    -1e-42,
    f32::MIN_POSITIVE,
    1e30,
    -3e38,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

fn odd_vector(sampler: &mut Sampler) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| {
        let pick = (sampler.next_1d() * ODD.len() as f32) as usize;
        ODD[pick.min(ODD.len() - 1)]
    }))
}

/// A ray: usual, or with odd components.
fn ray(i: u64, sampler: &mut Sampler) -> Ray {
    let usual = Ray::new(3.0 * in_cube(sampler), in_cube(sampler).normalize_or(Vec3::X));
    match i % 4 {
        0 => usual,
        1 => Ray { direction: odd_vector(sampler), ..usual },
        2 => Ray { origin: odd_vector(sampler), ..usual },
        _ => {
            let mut direction = magnitude(sampler, 30.0) * usual.direction;
            direction[(i / 4 % 3) as usize] = if i.is_multiple_of(8) { 0.0 } else { -0.0 };
            Ray { direction, ..usual }
        }
    }
}

fn bits(interval: Interval) -> [u32; 2] {
    [interval.min.to_bits(), interval.max.to_bits()]
}

fn check<V: BoundingVolume>(name: &str, left: &Enclosed<V>, right: &Enclosed<V>, ray: &Ray) {
    let reach = left.bounds.union(&right.bounds).reach(ray.origin);
    let query = V::query(ray, reach);
    let together = V::clip_pair(&V::pair(&left.volume, &right.volume), &query);
    let alone = [left.volume.clip(&query), right.volume.clip(&query)];
    assert_eq!(together.map(bits), alone.map(bits), "{name}: {together:?} for {alone:?}, {ray:?}");
}

#[test]
fn a_pair_of_boxes_is_two_boxes() {
    for i in 0..200_000 {
        let mut sampler = Sampler::new(9, i, 0);
        let mut any = || {
            let (a, b) = (in_cube(&mut sampler), in_cube(&mut sampler));
            let odd = i % 3 == 0;
            // A face in a coordinate plane, so that rays run within it; or a flat box.
            let flat = if odd { a * Vec3::new(1.0, 0.0, 1.0) } else { a };
            boxed(flat.min(b), flat.max(b))
        };
        let (left, right) = (any(), any());
        check("AABB", &left, &right, &ray(i, &mut sampler));
    }
    let empty = boxed(Aabb::EMPTY.min, Aabb::EMPTY.max);
    for i in 0..10_000 {
        let mut sampler = Sampler::new(10, i, 0);
        check("∅", &empty, &boxed(Vec3::ZERO, Vec3::ONE), &ray(i, &mut sampler));
    }
}

#[test]
fn a_pair_of_oriented_boxes_or_polytopes_is_two_of_them() {
    for i in 0..10_000 {
        let mut sampler = Sampler::new(11, i, 0);
        let mut any = || triangles(&[[(); 3].map(|()| in_cube(&mut sampler))]);
        let (left, right) = (any(), any());
        let ray = ray(i, &mut sampler);
        fn both<V: BoundingVolume>(
            [left, right]: [&ray_casting::Geometry; 2],
            name: &str,
            ray: &Ray,
        ) {
            check::<V>(name, &Enclosed::all_of(left), &Enclosed::all_of(right), ray);
        }
        both::<Obb>([&left, &right], "OBB", &ray);
        both::<KDop<3>>([&left, &right], "6-DOP", &ray);
        both::<KDop<13>>([&left, &right], "26-DOP", &ray);
    }
}
