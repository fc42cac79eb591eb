//! Random numbers for this crate's own tests.

/// SplitMix64, the generator of Steele, Lea and Flood (2014).
pub(crate) struct Uniform(pub(crate) u64);

impl Uniform {
    /// A number in [0, 1), a multiple of 2⁻⁵³.
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// A normal number with mean 0 and variance 1, by inverting its distribution.
    pub(crate) fn normal(&mut self) -> f64 {
        crate::normal_quantile(self.next().max(1e-300))
    }
}
