//! A fractal landscape: ridged noise over a square grid.

use crate::{Mesh, Surface};

/// A square of 100 × 100 scene units around the y axis, raised by ridged noise to 0 ≤ y < 24.
///
/// ```text
/// y(u, v) = Σₖ 12 · 2⁻ᵏ (1 − |2 noiseₖ(u fₖ, v fₖ) − 1|)²,   fₖ = 4 · 2.03ᵏ,   k = 0 … 9
/// ```
///
/// Folding the noise at its middle turns every zero crossing into a crest ("ridged" noise, after
/// Musgrave), and each octave adds crests half as high and about half as wide. The number of
/// octaves does not depend on `side`: a finer grid shows the same landscape with more triangles,
/// so run times at different sizes can be compared.
#[derive(Clone, Copy, Debug)]
pub struct Terrain {
    /// Squares along an edge, at least 1; each is split into two triangles.
    pub side: u32,
    /// Another number is another landscape.
    pub seed: u32,
}

/// The mesh of [`Terrain`], with 2 · side² triangles that face upwards.
///
/// # Panics
/// If `side` is 0, which is no surface.
#[must_use]
pub fn terrain(side: u32, seed: u32) -> Mesh {
    assert!(side >= 1, "a terrain needs at least 1 square along its edge, not {side}");
    Terrain { side, seed }.mesh()
}

/// The side of the terrain whose 2 · side² triangles come nearest to `triangles`; at least 1.
#[must_use]
pub fn side_for(triangles: u64) -> u32 {
    ((triangles as f64 / 2.0).sqrt().round() as u32).max(1)
}

/// Edge of the square, in scene units.
const EXTENT: f64 = 100.0;

impl Surface for Terrain {
    fn positions(&self) -> impl Iterator<Item = [f64; 3]> {
        let (side, seed) = (self.side, self.seed);
        let at = move |i: u32| f64::from(i) / f64::from(side);
        (0..=side).flat_map(move |i| {
            (0..=side).map(move |j| {
                let (u, v) = (at(j), at(i));
                [EXTENT * (u - 0.5), height(u, v, seed), EXTENT * (v - 0.5)]
            })
        })
    }

    fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        let side = self.side;
        let id = move |i: u32, j: u32| i * (side + 1) + j;
        (0..side).flat_map(move |i| {
            (0..side).flat_map(move |j| {
                let (a, b, c, d) = (id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
                [[a, b, c], [a, c, d]]
            })
        })
    }
}

/// Height over the point (u, v) of the unit square, in scene units.
fn height(u: f64, v: f64, seed: u32) -> f64 {
    let (mut sum, mut amplitude, mut frequency) = (0.0, 12.0, 4.0);
    for octave in 0..10 {
        let ridge = 1.0 - (2.0 * noise(u * frequency, v * frequency, octave, seed) - 1.0).abs();
        sum += amplitude * ridge * ridge;
        amplitude *= 0.5;
        frequency *= 2.03; // not 2, or the lattices of all octaves would share their corners
    }
    sum
}

/// Value noise in [0, 1): a random number at each corner of the lattice, blended in between.
fn noise(x: f64, y: f64, octave: u32, seed: u32) -> f64 {
    let (column, row) = (x.floor(), y.floor());
    let corner = |dx: u32, dy: u32| uniform(column as u32 + dx, row as u32 + dy, octave, seed);
    let (s, t) = (fade(x - column), fade(y - row));
    let near = lerp(corner(0, 0), corner(1, 0), s);
    let far = lerp(corner(0, 1), corner(1, 1), s);
    lerp(near, far, t)
}

/// 6t⁵ − 15t⁴ + 10t³: from 0 to 1 with no slope and no curvature at the ends (Perlin).
fn fade(t: f64) -> f64 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// A number in [0, 1) that depends on nothing but the four integers.
fn uniform(x: u32, y: u32, octave: u32, seed: u32) -> f64 {
    let corner = u64::from(x) << 32 | u64::from(y);
    let layer = u64::from(seed) << 32 | u64::from(octave);
    let bits = mix(corner ^ mix(layer));
    (bits >> 11) as f64 * (0.5_f64 / (1_u64 << 52) as f64) // 53 bits fill the fraction of an f64
}

/// SplitMix64's finishing steps: every input bit reaches every output bit.
fn mix(mut z: u64) -> u64 {
    z = z.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
