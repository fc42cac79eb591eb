//! What the seeds of a setting say together: medians, means, and how they fall with the samples.

use statistics::{Moments, PowerLaw, student_critical_t};

use crate::experiment::{Experiment, Job, Setting};
use crate::results::Results;
use crate::row::{Measure, Row};
use crate::run::key;

/// A setting on a scene at growing numbers of samples.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The setting.
    pub setting: Setting,
    /// One for each number of samples.
    pub points: Vec<Point>,
}

/// A setting on a scene at one number of samples, over all seeds.
#[derive(Clone, Debug)]
pub struct Point {
    /// Samples a pixel.
    pub samples: u32,
    /// How many seeds.
    pub seeds: usize,
    /// Seconds of the render, see [`Row::spent`].
    pub render: Spread,
    /// Seconds of building tree and lights, by the clock, of the seed that was fastest: a build is
    /// too short for the processor's time, and what others do meanwhile only adds to it.
    pub build: f64,
    /// Rays of the first seed.
    pub rays: u64,
    /// relMSE, less the reference's own; the mean is what falls as 1/n.
    pub rel_mse: Mean,
    /// relMSE of each seed.
    pub rel_mses: Vec<f64>,
    /// Half of the seeds are better.
    pub rel_mse_median: f64,
    /// relMSE without the worst pixels.
    pub trimmed: Mean,
    /// Root of the mean squared error.
    pub rmse: Mean,
    /// LDR-FLIP.
    pub flip: Mean,
    /// Relative error of the picture's mean. Its error has the reference's in it.
    pub bias: Mean,
    /// The error of the stage's own converged picture.
    pub shading: Mean,
    /// The distance to the stage's own converged picture.
    pub sampling: Mean,
    /// The fingerprint of the picture of each seed.
    pub pictures: Vec<u64>,
}

/// A median and the quartiles around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// A quarter is below.
    pub low: f64,
    /// Half is below.
    pub median: f64,
    /// Three quarters are below.
    pub high: f64,
}

/// A mean over seeds; NaN if nothing was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
    /// Half the width of its 95 % confidence interval, by Student's t.
    pub interval: f64,
}

impl Spread {
    /// The quartiles of some numbers, by linear interpolation; NaN if there are none.
    #[must_use]
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let place = share * (values.len().max(1) - 1) as f64;
            let (below, above) = (place.floor() as usize, place.ceil() as usize);
            match (values.get(below), values.get(above)) {
                (Some(a), Some(b)) => a + (b - a) * place.fract(),
                _ => f64::NAN,
            }
        };
        Self { low: at(0.25), median: at(0.5), high: at(0.75) }
    }
}

impl Mean {
    /// The mean of some numbers, of which `shared` is an error that all have in common.
    #[must_use]
    pub fn of(values: impl IntoIterator<Item = f64>, shared: f64) -> Self {
        let moments: Moments = values.into_iter().collect();
        if moments.count() == 0 || moments.non_finite() > 0 {
            return Self { value: f64::NAN, error: f64::NAN, interval: f64::NAN };
        }
        if moments.count() == 1 {
            return Self { value: moments.mean(), error: f64::NAN, interval: f64::NAN };
        }
        let own = moments.standard_error();
        let t = student_critical_t(0.05, (moments.count() - 1) as f64);
        Self {
            value: moments.mean(),
            error: (own * own + shared * shared).sqrt(),
            interval: ((t * own).powi(2) + (1.96 * shared).powi(2)).sqrt(),
        }
    }
}

impl Curve {
    /// The curves of an experiment, in the order of its settings.
    #[must_use]
    pub fn all(experiment: &Experiment, results: &Results) -> Vec<Self> {
        let curve = |setting: &Setting| {
            let points = setting.samples.iter().filter_map(|&samples| {
                let rows = (0..experiment.seeds).filter_map(|seed| {
                    results.get(&key(&Job { experiment, setting, samples, seed }))
                });
                Point::of(samples, &rows.collect::<Vec<_>>())
            });
            Self { setting: setting.clone(), points: points.collect() }
        };
        experiment.settings.iter().map(curve).collect()
    }

    /// relMSE against samples: the exponent is −1 for independent samples without bias.
    ///
    /// Its standard error is that of the jackknife: the fit is made again without each seed. The
    /// scatter around the line says too little, because the picture of four samples contains
    /// that of one, with the same seed: the points err together.
    ///
    /// # Errors
    /// With the reason, if fewer than three points have a positive error.
    pub fn law(&self) -> Result<PowerLaw, String> {
        let law = self.law_without(None)?;
        let seeds = self.points.iter().map(|point| point.rel_mses.len()).min().unwrap_or(0);
        let others = (0..seeds).map(|seed| Ok(self.law_without(Some(seed))?.exponent));
        let spread: Moments = others.collect::<Result<Vec<f64>, String>>()?.into_iter().collect();
        let n = seeds as f64;
        // √((n − 1)/n · Σ (sᵢ − s̄)²), of which Σ (…)² is n − 1 times the variance.
        let standard_error =
            if seeds < 2 { f64::NAN } else { (n - 1.0) * (spread.variance() / n).sqrt() };
        Ok(PowerLaw { standard_error, ..law })
    }

    /// The fit to the means over all seeds but one.
    fn law_without(&self, left_out: Option<usize>) -> Result<PowerLaw, String> {
        let point = |point: &Point| {
            let all = point.rel_mses.iter().enumerate();
            let kept = all.filter(|(seed, _)| Some(*seed) != left_out).map(|(_, &error)| error);
            [f64::from(point.samples), Mean::of(kept, 0.0).value]
        };
        let points = self.points.iter().map(point).filter(|[_, error]| *error > 0.0);
        PowerLaw::fit(&points.collect::<Vec<_>>())
    }

    /// The point with the most samples.
    #[must_use]
    pub fn last(&self) -> Option<&Point> {
        self.points.last()
    }

    /// Seconds a sample, where there are most of them.
    ///
    /// The time of a render is in proportion to its samples, so the longest renders say best what
    /// one costs.
    #[must_use]
    pub fn seconds_a_sample(&self) -> f64 {
        self.last().map_or(f64::NAN, |point| point.render.median / f64::from(point.samples))
    }
}

impl Point {
    fn of(samples: u32, rows: &[&Row]) -> Option<Self> {
        let first = rows.first()?;
        let measured = |measure| rows.iter().filter_map(move |row| row.error(measure));
        let shared = first.error(Measure::BiasOfReference).unwrap_or(0.0);
        let mean = |measure| Mean::of(measured(measure), 0.0);
        Some(Self {
            samples,
            seeds: rows.len(),
            render: Spread::of(rows.iter().map(|row| row.spent()[2])),
            build: rows.iter().map(|row| row.seconds[1]).fold(f64::INFINITY, f64::min),
            rays: first.rays,
            rel_mse: mean(Measure::RelMse),
            rel_mses: measured(Measure::RelMse).collect(),
            rel_mse_median: Spread::of(measured(Measure::RelMse)).median,
            trimmed: mean(Measure::Trimmed),
            rmse: mean(Measure::Rmse),
            flip: mean(Measure::Flip),
            bias: Mean::of(measured(Measure::Bias), shared),
            shading: mean(Measure::Shading),
            sampling: mean(Measure::Sampling),
            pictures: rows.iter().map(|row| row.picture).collect(),
        })
    }

    /// 1 / (relMSE · seconds): independent of the number of samples, if relMSE falls as 1/n.
    #[must_use]
    pub fn efficiency(&self) -> f64 {
        1.0 / (self.rel_mse.value * self.render.median)
    }
}

#[cfg(test)]
mod tests {
    use super::{Curve, Mean, Point, Spread};
    use crate::experiment::Setting;
    use crate::row::tests::example;
    use crate::row::{Measure, Row};

    #[test]
    fn quartiles_are_between_neighbours() {
        let spread = Spread::of([4.0, 1.0, 3.0, 2.0, 5.0]);
        assert_eq!(spread, Spread { low: 2.0, median: 3.0, high: 4.0 }, "of five");
        assert_eq!(Spread::of([1.0, 2.0]).median, 1.5, "of two");
        assert!(Spread::of([]).median.is_nan(), "of none");
    }

    /// t₀.₉₇₅ with 3 degrees of freedom is 3.182; the standard error of 1, 2, 3, 4 is √(5/12).
    #[test]
    fn the_interval_is_students() {
        let mean = Mean::of([1.0, 2.0, 3.0, 4.0], 0.0);
        let error = (5.0_f64 / 12.0).sqrt();
        assert!((mean.value - 2.5).abs() < 1e-12 && (mean.error - error).abs() < 1e-12, "{mean:?}");
        assert!((mean.interval / error - 3.182_446).abs() < 1e-4, "{mean:?}");
        let shared = Mean::of([1.0, 1.0], 0.5);
        assert!((shared.error - 0.5).abs() < 1e-12, "an error in common stays: {shared:?}");
        assert!((shared.interval - 0.98).abs() < 1e-12, "{shared:?}");
        assert!(Mean::of([1.0, f64::INFINITY], 0.0).value.is_nan(), "not finite");
        assert!(Mean::of([], 0.0).value.is_nan(), "nothing");
    }

    /// The examples' relMSE is 2/n and takes n/2 seconds.
    #[test]
    fn an_error_that_falls_as_one_over_n_has_slope_minus_one() {
        let points = [1, 4, 16, 64].map(|n| {
            let rows = [0, 1].map(|seed| example("cosine", n, seed));
            Point::of(n, &rows.each_ref()).expect("two rows")
        });
        let setting = Setting {
            name: "cosine".into(),
            stage: "rendering-equation",
            options: String::new(),
            samples: vec![1, 4, 16, 64],
            price: 1.0,
        };
        let curve = Curve { setting, points: points.to_vec() };
        let law = curve.law().expect("four points");
        assert!((law.exponent + 1.0).abs() < 1e-9, "{law:?}");
        assert!((law.factor - 2.0).abs() < 1e-9 && law.standard_error < 1e-9, "{law:?}");
        assert!((curve.seconds_a_sample() - 0.5).abs() < 1e-12, "{curve:?}");
        for point in &curve.points {
            assert!((point.efficiency() - 1.0).abs() < 1e-9, "{point:?}");
        }
    }

    /// A seed whose errors are all 2^a times larger, with the same slope, tells nothing about the
    /// slope; seeds with slopes of their own scatter it by as much as their mean does.
    #[test]
    fn the_error_of_the_slope_is_that_of_the_seeds() {
        let slopes = [-1.1, -0.9, -1.1, -0.9];
        let points = [1, 4, 16].map(|n| {
            let rows: Vec<Row> = slopes
                .iter()
                .enumerate()
                .map(|(seed, &slope)| {
                    let mut row = example("cosine", n, seed as u64);
                    let error = libm::pow(f64::from(n) / 4.0, slope);
                    row.errors[Measure::RelMse as usize] = Some(error);
                    row
                })
                .collect();
            Point::of(n, &rows.iter().collect::<Vec<_>>()).expect("four rows")
        });
        let setting = Setting {
            name: "cosine".into(),
            stage: "rendering-equation",
            options: String::new(),
            samples: vec![1, 4, 16],
            price: 1.0,
        };
        let law = Curve { setting, points: points.to_vec() }.law().expect("three points");
        // The standard error of the mean of the four slopes is 0.2/√3/2 = 0.0577.
        assert!((law.exponent + 1.0).abs() < 0.01, "{law:?}");
        assert!((law.standard_error - 0.0577).abs() < 0.003, "{law:?}");
    }
}
