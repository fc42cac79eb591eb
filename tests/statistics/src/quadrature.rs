//! Integrals over rectangles, for densities with kinks and steps.

/// Halvings of a rectangle before its integral is taken as it is.
const DEEPEST: u32 = 7;

/// ∫∫ f(x, y) dy dx over `x` × `y`, by adaptive quadrature of Gauss with 3 × 3 points.
///
/// A rectangle whose four quarters agree with it to `tolerance` is done; otherwise each quarter is
/// treated likewise with half the tolerance, up to 7 times. A smooth function is integrated to far
/// less than `tolerance`: halving divides the error by 64. Along a step, such as a horizon that
/// cuts through the rectangle, the remaining strips are 1/128 of it wide, and their errors have
/// random signs: together a few thousandths of the rectangle's area. A step that lies on an edge
/// costs nothing, because no point does; one that cuts off a corner of a twentieth may be
/// overlooked.
pub fn integrate_rectangle(
    f: &mut impl FnMut(f64, f64) -> f64,
    x: [f64; 2],
    y: [f64; 2],
    tolerance: f64,
) -> f64 {
    let whole = gauss(f, x, y);
    refine(f, x, y, whole, tolerance, DEEPEST)
}

fn refine(
    f: &mut impl FnMut(f64, f64) -> f64,
    x: [f64; 2],
    y: [f64; 2],
    whole: f64,
    tolerance: f64,
    halvings: u32,
) -> f64 {
    let halves = |[start, end]: [f64; 2]| {
        let middle = 0.5 * (start + end);
        [[start, middle], [middle, end]]
    };
    let quarters = halves(x).map(|x| halves(y).map(|y| (x, y, gauss(f, x, y))));
    let quarters = quarters.as_flattened();
    let sum: f64 = quarters.iter().map(|quarter| quarter.2).sum();
    // A NaN is greater than nothing: it ends here, and reaches the caller.
    if halvings > 1 && (sum - whole).abs() > tolerance {
        let finer = |&(x, y, part)| refine(f, x, y, part, 0.5 * tolerance, halvings - 1);
        return quarters.iter().map(finer).sum();
    }
    sum
}

/// The rule of Gauss with three points in both directions, exact up to the fifth power of each.
///
/// Points −√(3/5), 0, √(3/5) on an interval from −1 to 1, with the weights 5/18, 8/18, 5/18.
fn gauss(f: &mut impl FnMut(f64, f64) -> f64, x: [f64; 2], y: [f64; 2]) -> f64 {
    let points = |[start, end]: [f64; 2]| {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let offset = half * 0.6_f64.sqrt();
        [(middle - offset, 5.0), (middle, 8.0), (middle + offset, 5.0)]
    };
    let mut sum = 0.0;
    for (x, weight_x) in points(x) {
        for (y, weight_y) in points(y) {
            sum += weight_x * weight_y * f(x, y);
        }
    }
    sum * (x[1] - x[0]) * (y[1] - y[0]) / 324.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_function_is_integrated_to_the_tolerance() {
        let integral = integrate_rectangle(
            &mut |x, y| libm::exp(x) * libm::cos(y),
            [0.0, 1.0],
            [0.0, 1.0],
            1e-9,
        );
        let expected = libm::expm1(1.0) * libm::sin(1.0);
        assert!((integral - expected).abs() < 1e-9, "{integral}, not {expected}");
    }

    #[test]
    fn fifth_powers_are_exact() {
        let mut f = |x: f64, y: f64| x * x * x * x * x * y * y * y * y * y;
        let integral = gauss(&mut f, [0.0, 2.0], [0.0, 3.0]);
        assert!((integral / (64.0 / 6.0 * 729.0 / 6.0) - 1.0).abs() < 1e-14, "{integral}");
    }

    #[test]
    fn a_step_on_the_edge_costs_nothing() {
        let mut step = |x: f64, _| if x > 0.0 && x < 1.0 { 1.0 } else { 0.0 };
        let integral = integrate_rectangle(&mut step, [0.0, 1.0], [0.0, 1.0], 1e-9);
        assert!((integral - 1.0).abs() < 1e-15, "{integral}");
    }

    #[test]
    fn a_step_across_the_rectangle_is_integrated_to_a_few_thousandths() {
        for tenth in 0..10 {
            let slope = f64::from(tenth) / 10.0 + 0.137;
            let mut step = |x: f64, y: f64| if y < slope * x { 1.0 } else { 0.0 };
            let integral = integrate_rectangle(&mut step, [0.0, 1.0], [0.0, 1.0], 1e-9);
            let error = integral - 0.5 * slope;
            assert!(error.abs() < 3e-3, "slope {slope}: error {error}");
        }
    }

    #[test]
    fn nan_reaches_the_caller() {
        let integral = integrate_rectangle(&mut |_, _| f64::NAN, [0.0, 1.0], [0.0, 1.0], 1e-9);
        assert!(integral.is_nan(), "{integral}");
    }
}
