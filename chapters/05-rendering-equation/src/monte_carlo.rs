//! Monte Carlo integration: a sum of random values, each divided by how likely it was.

use workbench::Sampler;

// ANCHOR: estimate
/// What a number of samples says of an integral.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// N: the number of samples.
    pub samples: u64,
    /// The mean of f(X)/p(X): the estimate of the integral.
    pub mean: f64,
    /// Σ (f/p − mean)², from which the error is estimated.
    squares: f64,
}

impl Estimate {
    /// Takes one more value of f(X)/p(X) into account, without losing digits \[Welford62].
    pub fn add(&mut self, value: f64) {
        self.samples += 1;
        let before = value - self.mean;
        self.mean += before / self.samples as f64;
        self.squares += before * (value - self.mean);
    }

    /// The standard deviation of the mean: how far off it typically is. Falls as 1/√N.
    #[must_use]
    pub fn standard_error(&self) -> f64 {
        if self.samples < 2 {
            return f64::INFINITY;
        }
        let n = self.samples as f64;
        (self.squares / (n * (n - 1.0))).sqrt()
    }
}

/// Estimates ∫ f with N samples of density p.
///
/// ```text
/// ∫ f(x) dx ≈ 1/N Σₖ f(Xₖ) / p(Xₖ),   Xₖ ~ p          (equation 5)
/// ```
///
/// Right on average for any density that is positive wherever f is not zero (errata 24); how far off
/// a single estimate is depends on how well p imitates f.
pub fn integrate<X: Copy>(
    samples: u64,
    sampler: &mut Sampler,
    mut draw: impl FnMut(&mut Sampler) -> X,
    pdf: impl Fn(X) -> f64,
    f: impl Fn(X) -> f64,
) -> Estimate {
    let mut estimate = Estimate::default();
    for _ in 0..samples {
        let x = draw(sampler);
        let value = f(x);
        estimate.add(if value == 0.0 { 0.0 } else { value / pdf(x) });
    }
    estimate
}
// ANCHOR_END: estimate
