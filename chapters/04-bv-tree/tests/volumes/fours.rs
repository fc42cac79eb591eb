//! Four volumes tested together give the very bits of each tested alone.

use bv_tree::{Aabb, BoundingVolume, FourIntervals, KDop, Obb};
use glam::Vec3;
use ray_casting::{Geometry, Ray};
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

fn bits(min: f32, max: f32) -> [u32; 2] {
    [min.to_bits(), max.to_bits()]
}

fn check<V: BoundingVolume>(name: &str, enclosed: &[Enclosed<V>; 4], ray: &Ray) {
    let bounds = enclosed.iter().fold(Aabb::EMPTY, |all, one| all.union(&one.bounds));
    let query = V::query(ray, bounds.reach(ray.origin));
    let volumes = enclosed.each_ref().map(|one| one.volume);
    let FourIntervals { min, max } = V::clip_four(&V::four(&volumes), &query);
    for (i, volume) in volumes.iter().enumerate() {
        let (together, alone) = ((min[i], max[i]), volume.clip(&query));
        assert_eq!(
            bits(together.0, together.1),
            bits(alone.min, alone.max),
            "{name}, place {i}: {together:?} for {alone:?}, {ray:?}"
        );
    }
}

#[test]
fn four_boxes_together_are_four_boxes() {
    for i in 0..100_000 {
        let mut sampler = Sampler::new(9, i, 0);
        let boxes = [(); 4].map(|()| {
            let (a, b) = (in_cube(&mut sampler), in_cube(&mut sampler));
            // A face in a coordinate plane, so that rays run within it; or a flat box.
            let flat = if i % 3 == 0 { a * Vec3::new(1.0, 0.0, 1.0) } else { a };
            boxed(flat.min(b), flat.max(b))
        });
        check("AABB", &boxes, &ray(i, &mut sampler));
    }
    for i in 0..10_000 {
        let mut sampler = Sampler::new(10, i, 0);
        let empty = || boxed(Aabb::EMPTY.min, Aabb::EMPTY.max);
        let full = || boxed(Vec3::ZERO, Vec3::ONE);
        check("∅", &[empty(), full(), empty(), full()], &ray(i, &mut sampler));
    }
}

#[test]
fn four_oriented_boxes_or_polytopes_together_are_four_of_them() {
    for i in 0..10_000 {
        let mut sampler = Sampler::new(11, i, 0);
        let any = [(); 4].map(|()| triangles(&[[(); 3].map(|()| in_cube(&mut sampler))]));
        let ray = ray(i, &mut sampler);
        fn all<V: BoundingVolume>(geometries: &[Geometry; 4], name: &str, ray: &Ray) {
            check::<V>(name, &geometries.each_ref().map(Enclosed::all_of), ray);
        }
        all::<Obb>(&any, "OBB", &ray);
        all::<KDop<3>>(&any, "6-DOP", &ray);
        all::<KDop<13>>(&any, "26-DOP", &ray);
    }
}

/// The places of a node that have no child hold this.
#[test]
fn no_ray_enters_an_empty_volume() {
    fn check<V: BoundingVolume>(name: &str, ray: &Ray) {
        let inside = V::EMPTY.clip(&V::query(ray, 10.0));
        assert!(inside.is_empty(), "{name}: {inside:?} for {ray:?}");
    }
    for i in 0..10_000 {
        let mut sampler = Sampler::new(12, i, 0);
        let mut ray = ray(0, &mut sampler);
        if i % 3 == 0 {
            ray.direction[(i / 3 % 3) as usize] = if i % 2 == 0 { 0.0 } else { -0.0 };
        }
        check::<Aabb>("AABB", &ray);
        check::<Obb>("OBB", &ray);
        check::<KDop<7>>("14-DOP", &ray);
    }
}
