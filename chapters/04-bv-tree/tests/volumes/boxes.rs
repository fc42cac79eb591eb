//! Axis-aligned boxes, case by case. They are widened on purpose, by a millionth of their reach:
//! the intervals contain the exact ones, and not much more.

use bv_tree::{Aabb, BoundingVolume, Item};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Interval, Ray, Sphere};
use workbench::Sampler;

use crate::tools::{Enclosed, boxed, exact_clip, in_cube, magnitude, toward};

/// How far an interval may reach beyond the exact one, relative to the largest number in play.
const SLACK: f32 = 3e-6;

fn clip(volume: &Enclosed<Aabb>, origin: Vec3, direction: Vec3) -> Interval {
    volume.clip(&Ray::new(origin, direction))
}

fn check(got: Interval, [enter, leave]: [f32; 2], case: &str) {
    let slack = SLACK * leave.abs().max(1.0);
    let contains = got.min <= enter && leave <= got.max;
    assert!(contains, "{case}: {got:?} does not contain {enter} to {leave}");
    let tight = got.min >= enter - slack && got.max <= leave + slack;
    assert!(tight, "{case}: {got:?} is far larger than {enter} to {leave}");
}

/// accuracy B1, B4, B14: in all eight octants, and with zeros of either sign.
#[test]
fn a_box_is_entered_and_left_where_its_corners_are() {
    for octant in 0..8 {
        let signs =
            Vec3::from_array([0, 1, 2].map(|i| if octant >> i & 1 == 1 { -1.0 } else { 1.0 }));
        let (near, far) = (signs, 2.0 * signs);
        let volume = boxed(near.min(far), near.max(far));
        for zero in [0.0, -0.0] {
            let got = clip(&volume, Vec3::splat(zero), signs);
            check(got, [1.0, 2.0], &format!("octant {octant:03b}, origin {zero:?}"));
        }
    }
}

/// accuracy B2, B4, K3: 0 · ∞ where the ray runs within a face.
#[test]
fn a_ray_within_a_face_is_inside() {
    for zero in [0.0, -0.0] {
        for x in [zero, 1.0] {
            let volume = boxed(Vec3::splat(zero), Vec3::ONE);
            let got = clip(&volume, vec3(x, 0.5, -1.0), vec3(zero, -zero, 1.0));
            check(got, [1.0, 2.0], &format!("x = {x:?}, direction ({zero:?}, {:?}, 1)", -zero));
        }
        let volume = boxed(Vec3::splat(zero), Vec3::ONE);
        for x in [-0.01, 1.01] {
            let got = clip(&volume, vec3(x, 0.5, -1.0), vec3(zero, zero, 1.0));
            assert!(got.is_empty(), "beside the box at x = {x}: {got:?}");
        }
    }
}

/// accuracy B3, B8: boxes without volume.
#[test]
fn flat_boxes_and_points_are_met() {
    let flat = boxed(vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, 1.0));
    check(clip(&flat, Vec3::Y, Vec3::NEG_Y), [1.0, 1.0], "a flat box");
    check(clip(&flat, vec3(-3.0, 0.0, 0.0), Vec3::X), [2.0, 4.0], "a flat box, edge on");
    let point = boxed(Vec3::ONE, Vec3::ONE);
    check(clip(&point, Vec3::ZERO, Vec3::ONE), [1.0, 1.0], "a point");
    let beside = clip(&point, Vec3::ZERO, vec3(1.0, 1.0, 1.001));
    assert!(beside.is_empty(), "a point, missed by a thousandth: {beside:?}");
}

/// accuracy B5: the reciprocal of a tiny component is not cut off.
#[test]
fn a_tiny_component_of_the_direction_counts() {
    let volume = boxed(vec3(0.5, -1.0, 1e8), vec3(2.0, 1.0, 1.5e8));
    for sign in [1.0, -1.0] {
        let got = clip(&volume, Vec3::ZERO, vec3(1e-8, sign * 1e-30, 1.0));
        check(got, [1e8, 1.5e8], "x = 1 at t = 10⁸");
    }
    let aside = clip(&volume, Vec3::ZERO, vec3(1e-9, 0.0, 1.0));
    let reach = 1.5e8 * SLACK;
    assert!(reach > 0.5 || aside.is_empty(), "x = 0.15 at t = 1.5 · 10⁸: {aside:?}");
}

/// accuracy B7: from within, the interval starts at 0; behind the origin there is nothing.
#[test]
fn a_box_around_the_origin_is_entered_at_once_and_one_behind_it_never() {
    let volume = boxed(Vec3::NEG_ONE, Vec3::ONE);
    check(clip(&volume, Vec3::ZERO, Vec3::X), [0.0, 1.0], "from its middle");
    check(clip(&volume, vec3(0.0, 0.5, 0.0), Vec3::NEG_Y), [0.0, 1.5], "downwards");
    let behind = clip(&volume, vec3(3.0, 0.0, 0.0), Vec3::X);
    assert!(behind.is_empty(), "behind the origin: {behind:?}");
    let leaving = clip(&volume, Vec3::X, Vec3::X);
    assert!(leaving.contains(0.0), "from its face, leaving: {leaving:?}");
}

/// accuracy B10.
#[test]
fn very_small_and_very_large_boxes_are_met() {
    for scale in [1e-40, 1e-38, 1e-30, 1e30, 1e38] {
        let volume = boxed(Vec3::splat(-scale), Vec3::splat(scale));
        for direction in [Vec3::X, Vec3::Z, Vec3::ONE.normalize(), vec3(0.6, 0.8, 0.0)] {
            for origin in
                [Vec3::ZERO, vec3(-2.0 * scale, 0.0, -2.0 * scale), -2.0 * scale * direction]
            {
                let ray = Ray::new(origin, direction);
                let got = volume.clip(&ray);
                let Some([enter, leave]) = exact_clip(&volume.bounds, &ray) else { continue };
                let contains = f64::from(got.min) <= enter && leave <= f64::from(got.max);
                assert!(contains, "scale {scale:e}, {ray:?}: {got:?}, not {enter:e} to {leave:e}");
            }
        }
    }
}

/// accuracy V6: a flat box from one end of the numbers to the other has an area, and one of ∞, not of
/// 0 · ∞.
#[test]
fn the_area_of_the_largest_boxes_is_a_number() {
    let area = |max: Vec3| Aabb { min: -max, max }.surface_area();
    for (max, expected) in [
        (vec3(0.0, f32::MAX, f32::MAX), f32::INFINITY),
        (vec3(f32::MAX, 0.0, 0.0), 0.0),
        (vec3(f32::MAX, 0.0, f32::MIN_POSITIVE), 8.0 * (f32::MAX * f32::MIN_POSITIVE)),
        (Vec3::ONE, 24.0),
    ] {
        assert_eq!(area(max), expected, "a box to ±{max}");
    }
    assert_eq!(Aabb::EMPTY.surface_area(), 0.0, "the area of nothing");
}

/// accuracy B9, B15: rays aimed at points of boxes, over twelve orders of magnitude.
#[test]
fn no_box_is_missed_and_few_are_met_in_vain() {
    let mut vain = 0;
    for i in 0..100_000 {
        let mut sampler = Sampler::new(1, i, 0);
        let mut point = || magnitude(&mut sampler, 6.0) * in_cube(&mut sampler);
        let (a, b, origin) = (point(), point(), point());
        let volume = boxed(a.min(b), a.max(b));
        let u = Vec3::from_array([(); 3].map(|()| sampler.next_1d()));
        let target = (a + u * (b - a)).clamp(a.min(b), a.max(b));
        for target in [target, Vec3::select(u.cmplt(Vec3::splat(0.5)), a, b)] {
            let ray = toward(origin, target);
            if !ray.direction.is_finite() {
                continue;
            }
            let got = volume.clip(&ray);
            match exact_clip(&volume.bounds, &ray) {
                None => vain += usize::from(!got.is_empty()),
                Some([enter, leave]) => {
                    let contains = f64::from(got.min) <= enter && leave <= f64::from(got.max);
                    assert!(contains, "case {i}, {ray:?}: {got:?} is not {enter} to {leave}");
                }
            }
        }
    }
    // Half of the rays to corners pass just outside of the box, by roundings of the direction.
    assert!(vain < 100_000, "{vain} rays meet a box that they miss");
}

/// Rays that pass a box at a distance are kept out, or a tree would be useless.
#[test]
fn random_rays_meet_hardly_more_boxes_than_they_should() {
    let (mut hits, mut vain) = (0, 0);
    for i in 0..100_000 {
        let mut sampler = Sampler::new(2, i, 0);
        let (a, b) = (in_cube(&mut sampler), in_cube(&mut sampler));
        let volume = boxed(a.min(b), a.max(b));
        let ray = toward(3.0 * in_cube(&mut sampler), in_cube(&mut sampler));
        let exact = exact_clip(&volume.bounds, &ray).is_some();
        let met = !volume.clip(&ray).is_empty();
        assert!(met || !exact, "{ray:?} misses {:?}", volume.bounds);
        hits += usize::from(exact);
        vain += usize::from(met && !exact);
    }
    assert!(hits > 10_000, "only {hits} rays hit: the test is one-sided");
    assert!(vain <= 3, "{vain} rays of 100000 meet a box that they miss");
}

/// accuracy B11: nothing is asserted of the answer but that it is an interval.
#[test]
fn a_ray_that_is_not_finite_gives_no_nan() {
    let volume = boxed(Vec3::NEG_ONE, Vec3::ONE);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for (origin, direction) in [
            (Vec3::splat(bad), Vec3::X),
            (Vec3::ZERO, Vec3::splat(bad)),
            (vec3(0.0, bad, 0.0), vec3(bad, 0.0, 1.0)),
        ] {
            let got = clip(&volume, origin, direction);
            assert!(!got.min.is_nan() && !got.max.is_nan(), "{origin}, {direction}: {got:?}");
        }
    }
}

/// The box of a sphere is rounded outward: the sphere's ends, computed in double precision, lie
/// within. It is larger by two floats on each side at most.
#[test]
fn a_sphere_lies_within_its_box() {
    for i in 0..20_000 {
        let mut sampler = Sampler::new(31, i, 0);
        let center = magnitude(&mut sampler, 3.0) * in_cube(&mut sampler);
        let radius = magnitude(&mut sampler, 3.0);
        let geometry = Geometry { spheres: vec![Sphere { center, radius }], ..Geometry::default() };
        let Aabb { min, max } = Item::all(&geometry)[0].bounds;
        let [min, max, c] = [min, max, center].map(|v| v.as_dvec3());
        let r = f64::from(radius);
        let within = min.cmple(c - r).all() && max.cmpge(c + r).all();
        assert!(within, "{min} to {max} does not hold the sphere of {radius} around {center}");
        let excess = (max - min - 2.0 * r).max_element();
        let size = r + c.abs().max_element();
        assert!(excess <= 4.0 * f64::from(f32::EPSILON) * size, "{excess:e} of {size} in vain");
    }
}
