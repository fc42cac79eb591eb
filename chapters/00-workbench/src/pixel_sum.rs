//! What the samples of one pixel add up to.

/// What one pixel has collected.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PixelSum {
    /// The sum of the finite samples, in the order of their numbers.
    pub(crate) sum: [f64; 3],
    /// How many samples are in the sum.
    pub(crate) finite: u32,
    /// How many were taken.
    pub(crate) taken: u32,
}

impl PixelSum {
    // ANCHOR: add
    /// Adds a sample if it is finite; returns whether it is.
    #[inline]
    pub(crate) fn add(&mut self, radiance: [f32; 3]) -> bool {
        let radiance = radiance.map(f64::from);
        self.taken += 1;
        // In f64, finite f32s cannot add up to infinity.
        let is_finite = (radiance[0] + radiance[1] + radiance[2]).is_finite();
        if is_finite {
            self.finite += 1;
            for (sum, value) in self.sum.iter_mut().zip(radiance) {
                *sum += value;
            }
        }
        is_finite
    }
    // ANCHOR_END: add

    /// The mean of the finite samples: black before the first sample, NaN when none was finite.
    pub(crate) fn mean(&self) -> [f32; 3] {
        if self.taken == 0 {
            return [0.0; 3];
        }
        self.sum.map(|sum| (sum / f64::from(self.finite)) as f32)
    }

    /// `value`, or NaN if a sample was not finite.
    pub(crate) fn strict(&self, value: [f32; 3]) -> [f32; 3] {
        if self.finite == self.taken { value } else { [f32::NAN; 3] }
    }
}
