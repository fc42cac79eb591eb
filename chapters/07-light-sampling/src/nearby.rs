//! The choice of a light for the point that asks.

use std::f32::consts::PI;

use glam::Vec3;
use ray_casting::math::gamma;

use crate::light::Light;

/// How many lights are weighed at a time: two registers full on any machine, one on a wide one.
const LANES: usize = 8;

/// Lights in proportion to a bound of the irradiance that each could cause.
#[derive(Clone, Debug)]
pub struct Nearby {
    /// All lights but the sky, in their order.
    blocks: Vec<Block>,
    /// The weight of the sky: half of π L, the irradiance under all of it; 0 without one.
    ///
    /// The other half is left to the rays that are scattered: those of a matte surface find the sky
    /// with the very density with which they would be drawn toward it.
    sky: f32,
    /// The number of the sky.
    number_of_sky: usize,
}

/// What the weights of eight lights are computed from; of an unused lane all 0.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// A ball around the light: its centre
    middle: [[f32; LANES]; 3],
    /// and radius r, rounded up.
    radius: [f32; LANES],
    /// **n**, the normal of a flat lamp; 0 of anything else.
    normal: [[f32; LANES]; 3],
    /// By how much the height above a flat lamp may be underestimated.
    lift: [f32; LANES],
    /// What is added to cos θ' to make it a bound; 1 for lights without a normal.
    base: [f32; LANES],
    /// I: the intensity straight ahead, added up over the colours, in W/sr.
    intensity: [f32; LANES],
}

/// The weights at one point, added up by blocks.
struct Sums {
    blocks: [f32; Nearby::MOST / LANES],
    total: f32,
}

impl Nearby {
    /// More lights than that are not weighed one by one.
    pub const MOST: usize = 1024;

    /// For lights of which the sky, if there is one, is the last; `None` for more than
    /// [`Nearby::MOST`], and for less than two, among which there is nothing to choose.
    #[must_use]
    pub fn new(lights: &[Light]) -> Option<Self> {
        if lights.len() < 2 || lights.len() > Self::MOST {
            return None;
        }
        let (number_of_sky, sky) = match lights {
            [local @ .., Light::Sky { radiance }] => {
                (local.len(), 0.5 * PI * radiance.element_sum())
            }
            _ => (lights.len(), 0.0),
        };
        let blocks = lights[..number_of_sky].chunks(LANES).map(Block::new).collect();
        Some(Self { blocks, sky, number_of_sky })
    }

    /// The light that `u` ∈ [0, 1) picks for a surface at `place` whose normal on the viewer's side
    /// is `facing`, and the probability of that; `None` if the weights say nothing: all are 0, or
    /// their sum is too large for a number.
    #[must_use]
    pub fn pick(&self, place: Vec3, facing: Vec3, u: f32) -> Option<(usize, f32)> {
        let sums = self.weigh(place, facing)?;
        let mut rest = u * sums.total;
        let pmf = |weight: f32| weight / sums.total;
        if rest < self.sky {
            return Some((self.number_of_sky, pmf(self.sky)));
        }
        rest -= self.sky;
        // First the block, then one of its lights.
        let block = first_beyond(&sums.blocks[..self.blocks.len()], &mut rest)?;
        let weights = self.blocks[block].weights(place, facing);
        let lane = first_beyond(&weights, &mut rest)?;
        Some((block * LANES + lane, pmf(weights[lane])))
    }

    /// The probability with which [`Nearby::pick`] picks a light there; `None` where that is `None`.
    #[must_use]
    pub fn pmf(&self, place: Vec3, facing: Vec3, number: usize) -> Option<f32> {
        let total = self.weigh(place, facing)?.total;
        let weight = if number == self.number_of_sky {
            self.sky
        } else {
            self.blocks[number / LANES].weights(place, facing)[number % LANES]
        };
        Some(weight / total)
    }

    /// The sums of the weights; `None` if they say nothing.
    #[inline]
    fn weigh(&self, place: Vec3, facing: Vec3) -> Option<Sums> {
        let mut sums = Sums { blocks: [0.0; Self::MOST / LANES], total: self.sky };
        for (sum, block) in sums.blocks.iter_mut().zip(&self.blocks) {
            let [a, b, c, d, e, f, g, h] = block.weights(place, facing);
            *sum = ((a + b) + (c + d)) + ((e + f) + (g + h));
            sums.total += *sum;
        }
        (sums.total > 0.0 && sums.total < f32::INFINITY).then_some(sums)
    }
}

/// x, or 0 where that is not above 0: of a cosine, or at a point light itself, where it is NaN.
#[inline]
fn positive(x: f32) -> f32 {
    if x > 0.0 { x } else { 0.0 }
}

/// The number of the first weight with which the sum exceeds `rest`, which is lowered by those
/// before. If rounding leaves none, the last one that is not 0.
#[inline]
fn first_beyond(weights: &[f32], rest: &mut f32) -> Option<usize> {
    let mut found = None;
    for (number, &weight) in weights.iter().enumerate() {
        if weight > 0.0 {
            found = Some(number);
            if *rest < weight {
                break;
            }
            *rest -= weight;
        }
    }
    found
}

impl Block {
    fn new(lights: &[Light]) -> Self {
        let mut block = Self::default();
        for (lane, light) in lights.iter().enumerate() {
            let (middle, radius, normal, intensity) = match light {
                Light::Flat(lamp) => (
                    lamp.middle,
                    lamp.radius,
                    Some(lamp.normal),
                    lamp.area() as f32 * lamp.radiance,
                ),
                Light::Sphere(lamp) => {
                    let radius = lamp.sphere.radius;
                    (lamp.sphere.center, radius, None, PI * radius * radius * lamp.radiance)
                }
                Light::Point { position, intensity } => (*position, 0.0, None, *intensity),
                Light::Sky { .. } => continue,
            };
            // The middle of a flat lamp is rounded, by at most u in each of its components.
            let slack = if normal.is_some() { gamma(2) * middle.abs().element_sum() } else { 0.0 };
            for axis in 0..3 {
                block.middle[axis][lane] = middle[axis];
                block.normal[axis][lane] = normal.map_or(0.0, |normal| normal[axis]);
            }
            block.radius[lane] = (radius + slack) * (1.0 + gamma(2));
            block.lift[lane] = slack;
            block.base[lane] = if normal.is_some() { gamma(8) } else { 1.0 };
            block.intensity[lane] = intensity.element_sum();
        }
        block
    }

    // ANCHOR: weights
    /// A bound of the irradiance that each light could cause at `place`, up to a factor near 1.
    ///
    /// ```text
    /// w = I cos θ' cos θ / (d² + r²)
    /// cos θ' = h / √(d² + r²),   cos θ = (c + r) / √(d² + r²),   each at least 0
    /// ```
    ///
    /// d is the distance of the light's middle and r its radius; h is the height of the place above a
    /// flat lamp's plane, which is the same for all of its points; c is the height of the light's
    /// middle above the surface's horizon, and c + r that of the highest point that the light may
    /// have. So a weight is 0 only where nothing can arrive: from a flat lamp that is seen from
    /// behind, and from what lies below the horizon as a whole. The roundings of h and c are at most
    /// γ(5) d and are granted γ(8).
    ///
    /// r² in the denominator keeps the weight finite at the lamp, where E = π L r² / (d² + r²) is
    /// indeed the irradiance on the axis of a disk.
    #[inline]
    fn weights(&self, place: Vec3, facing: Vec3) -> [f32; LANES] {
        let mut weights = [0.0; LANES];
        let [mx, my, mz] = &self.middle;
        let [nx, ny, nz] = &self.normal;
        for i in 0..LANES {
            let (x, y, z, r) = (mx[i] - place.x, my[i] - place.y, mz[i] - place.z, self.radius[i]);
            let inverse = 1.0 / (x * x + y * y + z * z + r * r).sqrt();
            let height = self.lift[i] - (nx[i] * x + ny[i] * y + nz[i] * z);
            let above = facing.x * x + facing.y * y + facing.z * z + r;
            let cos_lamp = positive(self.base[i] + height * inverse);
            let cos_surface = positive(gamma(8) + above * inverse);
            let bound = self.intensity[i] * cos_lamp * cos_surface * (inverse * inverse);
            weights[i] = positive(bound);
        }
        weights
    }
    // ANCHOR_END: weights
}
