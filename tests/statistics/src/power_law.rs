//! How an error falls with the work put in.

/// y ≈ `factor` · x^`exponent`, fitted to points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// The slope in a plot with two logarithmic axes: −½ for the error of a random estimate.
    pub exponent: f64,
    /// The standard error of the exponent, from the scatter of the points around the line.
    pub standard_error: f64,
    /// The value at x = 1.
    pub factor: f64,
}

impl PowerLaw {
    /// The line of least squares through (ln x, ln y), all points having equal weight.
    ///
    /// # Errors
    /// If there are fewer than 3 points (2 have no scatter), if a coordinate is not a positive
    /// finite number, or if all x are the same.
    pub fn fit(points: &[[f64; 2]]) -> Result<Self, String> {
        if points.len() < 3 {
            return Err(format!("{} points have no scatter around a line", points.len()));
        }
        let usable = |value: f64| value > 0.0 && value.is_finite();
        if let Some([x, y]) = points.iter().find(|[x, y]| !usable(*x) || !usable(*y)) {
            return Err(format!("({x}, {y}) has no logarithm"));
        }
        let n = points.len() as f64;
        let logs: Vec<[f64; 2]> = points.iter().map(|point| point.map(libm::log)).collect();
        let mean = [0, 1].map(|axis| logs.iter().map(|point| point[axis]).sum::<f64>() / n);
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for [x, y] in logs {
            let [x, y] = [x - mean[0], y - mean[1]];
            (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
        }
        if xx == 0.0 {
            return Err(format!("all points have the same x, {}", points[0][0]));
        }
        let exponent = xy / xx;
        let residual = (yy - exponent * xy).max(0.0);
        Ok(Self {
            exponent,
            standard_error: (residual / (n - 2.0) / xx).sqrt(),
            factor: libm::exp(mean[1] - exponent * mean[0]),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::moments::Moments;
    use crate::suite::seed;
    use crate::uniform::Uniform;

    #[test]
    fn an_exact_law_is_found_exactly() {
        let points = [1.0, 4.0, 16.0, 64.0].map(|x: f64| [x, 3.0 / x.sqrt()]);
        let law = PowerLaw::fit(&points).expect("four points");
        assert!((law.exponent + 0.5).abs() < 1e-14, "{law:?}");
        assert!((law.factor - 3.0).abs() < 1e-13 && law.standard_error < 1e-7, "{law:?}");
    }

    /// Logarithms 0, 1, 2 against 0, 1, 0: slope 0, residual 2/3, standard error √(1/3).
    #[test]
    fn scatter_gives_the_standard_error_of_the_textbook() {
        let e = std::f64::consts::E;
        let law = PowerLaw::fit(&[[1.0, 1.0], [e, e], [e * e, 1.0]]).expect("three points");
        assert!(law.exponent.abs() < 1e-15, "{law:?}");
        assert!((law.standard_error - (1.0_f64 / 3.0).sqrt()).abs() < 1e-14, "{law:?}");
    }

    /// E12 of the catalogue: the error of a mean falls as 1/√N, and a bias stops it.
    #[test]
    fn the_error_of_a_mean_falls_as_one_over_root_n() {
        let mut random = Uniform(seed(7));
        let mut error = |n: u32, bias: f64| {
            let runs = (0..512).map(|_| {
                let mean = (0..n).map(|_| random.next()).collect::<Moments>().mean();
                (mean - 0.5 + bias) * (mean - 0.5 + bias)
            });
            [f64::from(n), runs.collect::<Moments>().mean().sqrt()]
        };
        let counts = [4, 16, 64, 256, 1024];
        let law = PowerLaw::fit(&counts.map(|n| error(n, 0.0))).expect("five points");
        assert!((law.exponent + 0.5).abs() < 0.03, "{law:?}");
        let biased = PowerLaw::fit(&counts.map(|n| error(n, 0.05))).expect("five points");
        assert!(biased.exponent > -0.4, "a bias is not seen: {biased:?}");
    }

    #[test]
    fn what_has_no_logarithm_is_refused() {
        for broken in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
            let found = PowerLaw::fit(&[[1.0, 1.0], [2.0, broken], [3.0, 1.0]]);
            assert!(found.is_err(), "{broken} gives {found:?}");
        }
        assert!(PowerLaw::fit(&[[1.0, 1.0], [2.0, 2.0]]).is_err(), "two points");
        assert!(PowerLaw::fit(&[[2.0, 1.0]; 3]).is_err(), "one x");
    }
}
