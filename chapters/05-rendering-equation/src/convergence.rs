//! How fast the error of Monte Carlo integration falls: a study that one can run.
//!
//! Integrals with a known value are estimated with N = 4, 16, 64, … samples, many times each, and a
//! line is laid through the errors over two logarithmic axes. Its slope is −1/2, however good or bad
//! the density, as long as the variance is finite.

mod command;
mod integrand;
mod report;
mod sampling;
mod terminal_plot;

pub use command::Command;
pub use integrand::Integrand;
pub use sampling::Sampling;

use ray_casting::math::log2_f64;
use workbench::Sampler;

use crate::monte_carlo::{Estimate, integrate};

/// What is to be estimated, and how often.
#[derive(Clone, Copy, Debug)]
pub struct Study {
    /// The function.
    pub integrand: Integrand,
    /// The largest N; the smaller ones are the powers of 4 from 4 on.
    pub samples: u64,
    /// Independent runs for each N, at least 1.
    pub runs: u64,
    /// Another seed, other runs.
    pub seed: u64,
}

/// How one density fares.
#[derive(Clone, Debug)]
pub struct Course {
    /// The density.
    pub sampling: Sampling,
    /// One row for each N.
    pub rows: Vec<Row>,
    /// The line through the typical errors for the larger N; `None` if there are none.
    pub slope: Option<Slope>,
}

/// What N samples give.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The estimate of the first run.
    pub estimate: Estimate,
    /// The error over all runs: the root of the mean of its square, or, where the variance and with
    /// it that mean is infinite, the median of its magnitude.
    pub typical_error: f64,
}

/// A power of N.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    /// d log error / d log N.
    pub exponent: f64,
    /// Its standard deviation, from how far the points lie from the line.
    pub standard_error: f64,
}

impl Study {
    /// Estimates the integral with samples of one density.
    #[must_use]
    pub fn course(&self, sampling: Sampling) -> Course {
        let numbers = (1..).map(|k| 4_u64.pow(k)).take_while(|&n| n <= self.samples);
        let rows: Vec<Row> = numbers.map(|n| self.row(sampling, n)).collect();
        let slope = self.slope(&rows);
        Course { sampling, rows, slope }
    }

    fn row(&self, sampling: Sampling, n: u64) -> Row {
        let estimate = |run| {
            // Each row has runs of its own, so that the points of the line are independent.
            let mut sampler = Sampler::new(self.seed, run, n);
            let pdf = |wi| sampling.pdf_solid_angle(wi);
            let f = |wi| self.integrand.eval(wi);
            integrate(n, &mut sampler, |sampler| sampling.sample(sampler), pdf, f)
        };
        let exact = self.integrand.integral();
        let estimates: Vec<Estimate> = (0..self.runs).map(estimate).collect();
        let mut errors: Vec<f64> = estimates.iter().map(|e| (e.mean - exact).abs()).collect();
        errors.sort_by(f64::total_cmp);
        let typical_error = if self.has_infinite_variance(sampling) {
            errors[errors.len() / 2]
        } else {
            (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt()
        };
        Row { estimate: estimates[0], typical_error }
    }

    /// Where the density imitates the function exactly, only rounding is left, which is less than
    /// this, and says nothing about a slope.
    fn rounding(&self) -> f64 {
        1e-6 * self.integrand.integral()
    }

    /// Laid through the rows from √(largest N) on: what is found rarely is not found at all with
    /// few samples, and has no slope there.
    fn slope(&self, rows: &[Row]) -> Option<Slope> {
        let large = |row: &&Row| row.estimate.samples * row.estimate.samples >= self.samples;
        let errors = rows.iter().filter(large).filter(|row| row.typical_error > self.rounding());
        let points: Vec<[f64; 2]> = errors
            .map(|row| [row.estimate.samples as f64, row.typical_error].map(log2_f64))
            .collect();
        (points.len() >= 3).then(|| line_through(&points))
    }

    /// The slope that theory predicts for the typical error when N is large enough.
    ///
    /// Let f fall as cosᵃ θ toward the horizon, and p as cosᵐ θ. The variance ∫ f²/p dω is finite if
    /// 2a − m > −1, and the slope is −1/2. Otherwise f/p exceeds w with a probability that falls as
    /// w^(−α) for α = (m + 1)/(m − a) ≤ 2, and sums of such numbers have errors that fall as
    /// N^(1/α − 1).
    #[must_use]
    pub fn expected_slope(&self, sampling: Sampling) -> f64 {
        let m = sampling.power_at_horizon();
        match self.integrand.power_at_horizon() {
            Some(a) if 2 * a - m < -1 => -f64::from(a + 1) / f64::from(m + 1),
            _ => -0.5,
        }
    }

    /// Whether ∫ f²/p dω is infinite.
    #[must_use]
    pub fn has_infinite_variance(&self, sampling: Sampling) -> bool {
        let m = sampling.power_at_horizon();
        self.integrand.power_at_horizon().is_some_and(|a| 2 * a - m <= -1)
    }
}

/// Least squares.
fn line_through(points: &[[f64; 2]]) -> Slope {
    let n = points.len() as f64;
    let [mean_x, mean_y] = [0, 1].map(|axis| points.iter().map(|p| p[axis]).sum::<f64>() / n);
    let xx: f64 = points.iter().map(|[x, _]| (x - mean_x) * (x - mean_x)).sum();
    let xy: f64 = points.iter().map(|[x, y]| (x - mean_x) * (y - mean_y)).sum();
    let exponent = xy / xx;
    let residual = |[x, y]: &[f64; 2]| y - mean_y - exponent * (x - mean_x);
    let squares: f64 = points.iter().map(|point| residual(point) * residual(point)).sum();
    Slope { exponent, standard_error: (squares / (n - 2.0) / xx).sqrt() }
}

#[cfg(test)]
mod tests {
    use super::{Integrand, Sampling, Study, line_through};

    fn study(integrand: Integrand) -> Study {
        Study { integrand, samples: 4096, runs: 200, seed: 0 }
    }

    #[test]
    fn a_line_is_found_exactly() {
        let slope = line_through(&[[0.0, 1.0], [1.0, 0.5], [2.0, 0.0], [4.0, -1.0]]);
        assert!((slope.exponent + 0.5).abs() < 1e-15, "exponent {}", slope.exponent);
        assert!(slope.standard_error < 1e-15, "standard error {}", slope.standard_error);
    }

    /// Four means over 200 runs each, every one uncertain by 5 %: the slope is by about 0.016.
    #[test]
    fn errors_of_finite_variance_fall_as_the_square_root() {
        for integrand in Integrand::ALL {
            for sampling in Sampling::ALL {
                let study = study(integrand);
                let course = study.course(sampling);
                let Some(slope) = course.slope else { continue };
                if study.has_infinite_variance(sampling) {
                    continue;
                }
                // With few samples, few runs ever look at the patch.
                let tolerance = if integrand == Integrand::SkyPatch { 0.2 } else { 0.07 };
                let error = (slope.exponent + 0.5).abs();
                assert!(error < tolerance, "{integrand:?}, {sampling:?}: slope {}", slope.exponent);
            }
        }
    }

    #[test]
    fn the_peaked_density_is_as_slow_as_predicted() {
        let study = study(Integrand::Cosine);
        let course = study.course(Sampling::Peaked);
        let slope = course.slope.expect("there are errors").exponent;
        assert_eq!(study.expected_slope(Sampling::Peaked), -0.25, "α = 4/3");
        assert!((slope + 0.25).abs() < 0.1, "slope {slope}");
    }

    #[test]
    fn the_perfect_density_has_no_error_and_no_slope() {
        let course = study(Integrand::Cosine).course(Sampling::Cosine);
        let worst = course.rows.iter().map(|row| row.typical_error).fold(0.0, f64::max);
        assert!(worst < 4e-7, "an error of {worst:e}");
        assert!(course.slope.is_none(), "a slope of {:?}", course.slope);
    }

    /// The closed forms, against a midpoint rule over cos θ and, for the patch, over φ.
    #[test]
    fn the_closed_forms_are_right() {
        for integrand in Integrand::ALL {
            let n = 1500;
            let mut sum = 0.0;
            for i in 0..n {
                let z = (f64::from(i) + 0.5) / f64::from(n);
                let r = (1.0 - z * z).sqrt();
                for k in 0..n {
                    let (sin, cos) = ray_casting::math::sin_cos_f64(
                        (f64::from(k) + 0.5) / f64::from(n) * std::f64::consts::TAU,
                    );
                    sum += integrand.eval(glam::DVec3::new(r * cos, r * sin, z).as_vec3());
                }
            }
            let integral = sum * std::f64::consts::TAU / f64::from(n * n);
            let error = integral / integrand.integral() - 1.0;
            // The edge of the patch is resolved by the grid only.
            let tolerance = if integrand == Integrand::SkyPatch { 2e-3 } else { 1e-4 };
            assert!(error.abs() < tolerance, "{integrand:?}: off by {error:e}");
        }
    }
}
