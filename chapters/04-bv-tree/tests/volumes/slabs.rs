//! A slab without any padding, against double precision: its own roundings never cost a hit.

use bv_tree::SlabQuery;
use ray_casting::Interval;
use workbench::Sampler;

use crate::tools::magnitude;

/// A number of any sign and of twelve orders of magnitude.
fn number(sampler: &mut Sampler) -> f32 {
    let sign = if sampler.next_1d() < 0.5 { -1.0 } else { 1.0 };
    sign * magnitude(sampler, 6.0)
}

/// The t ≥ 0 at which a ray crosses the planes, in double precision.
fn exact(origin: f32, direction: f32, slab: Interval) -> [f64; 2] {
    let t = [slab.min, slab.max].map(|c| (f64::from(c) - f64::from(origin)) / f64::from(direction));
    [t[0].min(t[1]), t[0].max(t[1])]
}

/// accuracy B15: the ends, and the t of a hit at an end, which is rounded too.
#[test]
fn a_slab_contains_the_exact_interval_and_hardly_more() {
    for i in 0..200_000 {
        let mut sampler = Sampler::new(12, i, 0);
        let (origin, direction) = (number(&mut sampler), number(&mut sampler));
        let (a, b) = (number(&mut sampler), number(&mut sampler));
        let slab = Interval::new(a.min(b), a.max(b));
        let got = SlabQuery::new(origin, direction, 0.0).clip(slab);
        let [enter, leave] = exact(origin, direction, slab);
        if leave < 0.0 {
            continue;
        }
        let case = || format!("case {i}: o = {origin}, d = {direction}, {slab:?}: {got:?}");
        assert!(f64::from(got.max) >= leave, "{} ends before {leave}", case());
        assert!(got.max >= leave as f32, "{} ends before the hit at {}", case(), leave as f32);
        if enter >= 0.0 {
            assert!(f64::from(got.min) <= enter, "{} begins behind {enter}", case());
            assert!(
                got.min <= enter as f32,
                "{} begins behind the hit at {}",
                case(),
                enter as f32
            );
        }
        let size = f64::from(origin.abs().max(a.abs()).max(b.abs()));
        let slack = 2e-6 * size / f64::from(direction).abs();
        let tight = f64::from(got.min) >= enter - slack && f64::from(got.max) <= leave + slack;
        assert!(tight, "{} is far larger than {enter} to {leave}", case());
    }
}

/// accuracy B5: 1/d overflows, and the crossing is still at a finite t.
#[test]
fn a_direction_without_a_finite_reciprocal_is_entered_in_time() {
    for direction in [1e-39_f32, -1e-39, 1e-40, -1e-42, f32::from_bits(1)] {
        for (near, far) in [(1e-5_f32, 1e-4), (1e-9, 1e-8), (1e-30, 2e-30)] {
            let slab = if direction > 0.0 { [near, far] } else { [-far, -near] };
            let slab = Interval::new(slab[0], slab[1]);
            let got = SlabQuery::new(0.0, direction, 0.0).clip(slab);
            let [enter, leave] = exact(0.0, direction, slab);
            assert!(
                f64::from(got.min) <= enter,
                "d = {direction:e}, {slab:?}: {got:?}, not {enter:e}"
            );
            let end = leave.min(f64::from(f32::MAX));
            assert!(
                f64::from(got.max) >= end,
                "d = {direction:e}, {slab:?}: {got:?}, not {leave:e}"
            );
        }
    }
}

/// accuracy K3, B2: without a direction the ray is inside for ever, or never; on a plane it is inside.
#[test]
fn a_ray_along_a_slab_is_inside_or_not() {
    let slab = Interval::new(1.0, 2.0);
    for zero in [0.0, -0.0] {
        for (origin, inside) in [
            (1.5, true),
            (1.0, true),
            (2.0, true),
            (1.0_f32.next_down(), true),
            (2.0_f32.next_up(), true),
            (0.999, false),
            (2.001, false),
            (-5.0, false),
        ] {
            let got = SlabQuery::new(origin, zero, 0.0).clip(slab);
            // An end that is NaN constrains nothing.
            let outside = got.min > 0.0 || got.max < 1e30;
            assert_eq!(!outside, inside, "o = {origin}, d = {zero:?}: {got:?}");
        }
    }
}
