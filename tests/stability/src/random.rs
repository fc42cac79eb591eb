//! Random numbers of any magnitude, from a generator that is not the course's own.

use glam::{DVec3, Vec3};

/// SplitMix64, the generator of Steele, Lea and Flood (2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A stream of its own for each `seed` and `chunk`.
    #[must_use]
    pub fn new(seed: u64, chunk: u64) -> Self {
        let mut seeds = Self(seed);
        let seed = seeds.bits();
        Self(Self(seed ^ chunk).bits())
    }

    /// 64 random bits.
    #[inline]
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [0, 1), a multiple of 2⁻⁵³.
    #[inline]
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// A number in [0, 1) as the course's samplers take it: a multiple of 2⁻²⁴.
    #[inline]
    pub fn u(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / 16_777_216.0
    }

    /// A number from `low` to `high`.
    #[inline]
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number from 0 to `end` − 1.
    #[inline]
    pub fn below(&mut self, end: u64) -> u64 {
        self.bits() % end
    }

    /// 10 to a power from `low` to `high`.
    #[inline]
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        libm::pow(10.0, self.between(low, high))
    }

    /// A point of the cube from −1 to 1.
    #[inline]
    pub fn in_cube(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }

    /// A unit vector, every direction equally likely: points outside the ball are thrown away.
    #[inline]
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let p = self.in_cube();
            if (0.01..=1.0).contains(&p.length_squared()) {
                return p.normalize();
            }
        }
    }

    /// Any finite float, each bit pattern equally likely.
    #[inline]
    pub fn finite(&mut self) -> f32 {
        loop {
            let x = f32::from_bits(self.bits() as u32);
            if x.is_finite() {
                return x;
            }
        }
    }

    /// `x`, one float below or one above, each with the same chance.
    #[inline]
    pub fn beside(&mut self, x: f32) -> f32 {
        [x.next_down(), x, x.next_up()][self.below(3) as usize]
    }

    /// The same for each coordinate.
    #[inline]
    pub fn beside_point(&mut self, p: Vec3) -> Vec3 {
        Vec3::from_array(p.to_array().map(|x| self.beside(x)))
    }
}
