//! How much longer one setting takes than another for the same error.

use statistics::student_critical_t;

use crate::curve::{Curve, Mean, Point};

/// A ratio with its interval of confidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratio {
    /// The ratio.
    pub value: f64,
    /// It is above this …
    pub low: f64,
    /// … and below this, in 95 of 100 measurements.
    pub high: f64,
}

impl Ratio {
    /// The time that `slow` takes for the error of `fast`, in terms of the latter's.
    ///
    /// ```text
    /// (relMSE · seconds) of slow / (relMSE · seconds) of fast
    /// ```
    ///
    /// Each at its most samples. That is the ratio of times at equal error if both fall as 1/n. The
    /// interval is that of the two means of relMSE, by Student's t with the degrees of freedom of
    /// one of them; what the clock adds is not in it.
    #[must_use]
    pub fn of_times(slow: &Point, fast: &Point) -> Self {
        let value = fast.efficiency() / slow.efficiency();
        Self::of_means(value, [slow.rel_mse, fast.rel_mse], slow.seeds.min(fast.seeds))
    }

    /// A ratio to which two means over so many seeds contribute a factor each, or one over it.
    #[must_use]
    pub fn of_means(value: f64, means: [Mean; 2], seeds: usize) -> Self {
        let [a, b] = means.map(|mean| mean.error / mean.value);
        let error = a.hypot(b);
        let t = if seeds < 2 { f64::NAN } else { student_critical_t(0.05, (seeds - 1) as f64) };
        let factor = libm::exp(t * error);
        Self { value, low: value / factor, high: value * factor }
    }

    /// Whether the interval does not say which is better.
    #[must_use]
    pub fn is_open(self) -> bool {
        !(self.low > 1.0 || self.high < 1.0)
    }
}

/// The curve that needs least time for an error, by its point with the most samples.
#[must_use]
pub fn best(curves: &[Curve]) -> Option<&Curve> {
    let efficiency = |curve: &Curve| curve.last().map_or(f64::NAN, Point::efficiency);
    curves
        .iter()
        .filter(|curve| efficiency(curve) > 0.0)
        .max_by(|a, b| efficiency(a).total_cmp(&efficiency(b)))
}

#[cfg(test)]
mod tests {
    use super::{Ratio, best};
    use crate::curve::Curve;
    use crate::experiment::{Experiment, Setting};
    use crate::results::Results;
    use crate::row::Measure;
    use crate::row::tests::example;
    use crate::scene::{Answer, Scene};

    /// Two settings, the second with three times the error in twice the time.
    fn curves() -> Vec<Curve> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let mut results = Results::open(&folder.path().join("r.csv")).expect("a new file");
        for seed in 0..8 {
            let mut good = example("cosine", 4, seed);
            good.errors[Measure::RelMse as usize] = Some(0.1 + 0.001 * seed as f64);
            let mut bad = example("uniform", 4, seed);
            bad.errors[Measure::RelMse as usize] = Some(0.3 + 0.003 * seed as f64);
            bad.seconds[2] *= 2.0;
            for row in [good, bad] {
                results.add(row).expect("the row is written");
            }
        }
        let settings = ["cosine", "uniform"].map(|name| Setting {
            name: name.into(),
            stage: "rendering-equation",
            options: example(name, 4, 0).key.options,
            samples: vec![4],
            price: 1.0,
        });
        let scene = Scene::stored("cornell-box", [64, 64], Answer::None);
        let settings = settings.to_vec();
        let experiment = Experiment { question: "density", scene, settings, seeds: 8 };
        Curve::all(&experiment, &results)
    }

    #[test]
    fn three_times_the_error_in_twice_the_time_is_six() {
        let curves = curves();
        let [good, bad] = [0, 1].map(|i| curves[i].last().expect("a point"));
        let ratio = Ratio::of_times(bad, good);
        assert!((ratio.value - 6.0).abs() < 1e-9, "{ratio:?}");
        assert!(ratio.low < 6.0 && ratio.low > 5.5 && ratio.high < 6.5, "{ratio:?}");
        assert!(!ratio.is_open() && Ratio::of_times(good, good).is_open(), "{ratio:?}");
        assert_eq!(best(&curves).map(|c| c.setting.name.as_str()), Some("cosine"), "the best");
    }
}
