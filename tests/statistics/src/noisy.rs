//! A picture that knows its noise.

/// A picture whose pixels are estimates.
#[derive(Clone, Copy, Debug)]
pub struct Noisy<'a> {
    /// The pixels, row by row.
    pub mean: &'a [[f32; 3]],
    /// The variance of each of these means: a standard error's square.
    pub variance: &'a [[f32; 3]],
    /// From how many independent numbers a pixel's variance was estimated: its samples, or, if they
    /// were averaged in batches first, its batches. At least 2.
    pub samples: u32,
}

impl Noisy<'_> {
    /// Whether the picture can be compared.
    ///
    /// # Errors
    /// A sentence that says what is broken, and where.
    pub(crate) fn sound(&self, [width, height]: [usize; 2]) -> Result<(), String> {
        let [means, variances] = [self.mean.len(), self.variance.len()];
        if means != width * height || variances != means || means == 0 {
            return Err(format!("{means} pixels, {variances} variances for {width} × {height}"));
        }
        if self.samples < 2 {
            return Err(format!("{} samples have no variance", self.samples));
        }
        let broken = |i: &usize| {
            self.mean[*i].iter().any(|mean| !mean.is_finite())
                || self.variance[*i].iter().any(|v| !(v.is_finite() && *v >= 0.0))
        };
        match (0..means).find(broken) {
            Some(i) => Err(format!(
                "pixel ({}, {}) is {:?} with the variance {:?}",
                i % width,
                i / width,
                self.mean[i],
                self.variance[i]
            )),
            None => Ok(()),
        }
    }
}
