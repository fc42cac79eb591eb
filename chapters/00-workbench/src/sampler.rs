//! Uniform random numbers, the same on every machine and for any number of threads.

use rand_core::Rng;
use rand_pcg::Pcg32;

/// The uniform numbers of one camera path.
///
/// Each path has a generator of its own, keyed by seed, pixel and sample, so that no path can
/// change another's numbers, whichever thread renders it. The key is hashed, because generators
/// with neighbouring keys would otherwise start with related numbers.
#[derive(Clone, Debug)]
pub struct Sampler {
    generator: Pcg32,
}

impl Sampler {
    // ANCHOR: new
    /// The numbers of sample number `sample` of pixel number `pixel` (row by row from the top).
    #[inline]
    #[must_use]
    pub fn new(seed: u64, pixel: u64, sample: u64) -> Self {
        let state = mixed(mixed(mixed(seed) ^ pixel) ^ sample);
        Self { generator: Pcg32::new(state, mixed(state)) }
    }
    // ANCHOR_END: new

    /// The next number, uniform in [0, 1), one of 2²⁴ values.
    ///
    /// The top 24 bits are all that an f32 below 1 can hold; rounding more of them could give 1.
    #[inline]
    pub fn next_1d(&mut self) -> f32 {
        unit_float(self.generator.next_u32())
    }

    /// The next two numbers: a uniform point of [0, 1)².
    #[inline]
    pub fn next_2d(&mut self) -> [f32; 2] {
        [self.next_1d(), self.next_1d()]
    }
}

/// The top 24 bits of `bits` as a number in [0, 1).
#[inline]
fn unit_float(bits: u32) -> f32 {
    (bits >> 8) as f32 * (1.0 / 16_777_216.0)
}

// ANCHOR: mixed
/// A bijection of 64-bit numbers in which every input bit changes about half of the output bits:
/// one step of SplitMix64 (Steele, Lea and Flood 2014).
#[inline]
fn mixed(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
// ANCHOR_END: mixed

#[cfg(test)]
mod tests {
    use super::{Sampler, mixed, unit_float};

    /// accuracy.md M1: the largest output is the largest f32 below 1.
    #[test]
    fn numbers_stay_below_one() {
        assert_eq!(unit_float(u32::MAX), 1.0_f32.next_down(), "the largest number");
        assert_eq!(unit_float(0), 0.0, "the smallest number");
    }

    /// The first outputs of SplitMix64 with seed 1234567, as published with its reference code.
    #[test]
    fn the_hash_is_the_published_one() {
        let step = 0x9e37_79b9_7f4a_7c15_u64;
        let outputs = [0, 1, 2].map(|n: u64| mixed(step.wrapping_mul(n).wrapping_add(1_234_567)));
        let published =
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!(outputs, published, "the first outputs");
    }

    /// Pinned: every picture depends on these numbers. They were computed by a second
    /// implementation, in Python.
    #[test]
    fn the_numbers_are_the_pinned_ones() {
        let bits =
            |mut sampler: Sampler| [(); 4].map(|()| (sampler.next_1d() * 16_777_216.0) as u32);
        assert_eq!(
            bits(Sampler::new(0, 0, 0)),
            [2_267_191, 8_249_472, 14_107_553, 1_360_749],
            "key 0, 0, 0"
        );
        assert_eq!(
            bits(Sampler::new(7, 1234, 56)),
            [5_699_036, 8_901_476, 3_723_685, 9_919_924],
            "key 7, 1234, 56"
        );
    }

    /// accuracy.md M13, at a size for every commit: |r| ≤ 5/√n.
    #[test]
    fn neighbours_in_every_part_of_the_key_are_uncorrelated() {
        let n: u32 = 100_000;
        type Pair = fn(u64) -> [Sampler; 2];
        let neighbours: [(&str, Pair); 3] = [
            ("seed", |i| [Sampler::new(i, 0, 0), Sampler::new(i + 1, 0, 0)]),
            ("pixel", |i| [Sampler::new(0, i, 0), Sampler::new(0, i + 1, 0)]),
            ("sample", |i| [Sampler::new(0, 0, i), Sampler::new(0, 0, i + 1)]),
        ];
        for (part, pair) in neighbours {
            let products = (0..u64::from(n)).map(|i| {
                let [x, y] = pair(i).map(|mut sampler| f64::from(sampler.next_1d()) - 0.5);
                x * y
            });
            // The variance of a uniform number is 1/12.
            let correlation = 12.0 * products.sum::<f64>() / f64::from(n);
            let limit = 5.0 / f64::from(n).sqrt();
            assert!(correlation.abs() <= limit, "{part}: r = {correlation}, limit {limit}");
        }
    }

    /// What adds up seed, pixel and sample gives the second sample of a pixel the numbers of the
    /// first sample of its neighbour, which neighbours that differ in one part do not show. That two
    /// of 1000 honest keys begin with the same 48 bits happens once in 10⁸ times.
    #[test]
    fn keys_of_equal_sum_have_numbers_of_their_own() {
        let mut begun = std::collections::HashMap::new();
        for key in 0..1000 {
            let [seed, pixel, sample] = [key % 10, key / 10 % 10, key / 100];
            let numbers = Sampler::new(seed, pixel, sample).next_2d().map(f32::to_bits);
            let before = begun.insert(numbers, [seed, pixel, sample]);
            assert_eq!(before, None, "seed, pixel and sample {:?}", [seed, pixel, sample]);
        }
    }

    #[test]
    fn the_numbers_fill_the_unit_interval_evenly() {
        let mut sampler = Sampler::new(3, 5, 8);
        let mut counts = [0_u32; 16];
        for _ in 0..160_000 {
            counts[(sampler.next_1d() * 16.0) as usize] += 1;
        }
        // 10 000 are expected, with a standard deviation of 97.
        for (bin, count) in counts.into_iter().enumerate() {
            assert!(count.abs_diff(10_000) < 485, "bin {bin} has {count} of 10 000");
        }
    }
}
