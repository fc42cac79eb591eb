//! LDR-FLIP: how different two pictures look when a viewer flips between them.
//!
//! After P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
//! "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech.
//! 3(2), 2020. Written from the paper's formulas:
//!
//! 1. blur both pictures as the eye does at a distance, each opponent colour by its own amount;
//! 2. compare colours by the HyAB distance in L*a*b*, dark ones less colourful (Hunt);
//! 3. compare edges and points of the lightness, which stand out more than their colour says;
//! 4. a difference of features raises the difference of colours towards 1.
//!
//! All filters are products of one across and one down, so each is two passes. Departure: pictures
//! of 64 pixels are as small as a thumbnail at the distance that the paper assumes. No part of the
//! paper's test set is compared with: its pictures are not ours to store.

use std::f64::consts::PI;

use workbench::{Image, srgb};

/// Pixels a degree, 67: a picture of 3840 pixels on 0.7 m, seen from 0.7 m, the paper's own.
const PIXELS_A_DEGREE: f64 = 0.7 * 3840.0 / 0.7 * PI / 180.0;

/// The mean over the pixels of the difference that is seen: 0 the same, 1 as different as can be.
///
/// The pictures are those of the PNG files: 8 bits, sRGB, clamped.
///
/// # Panics
/// If the sizes differ.
#[must_use]
pub fn flip(picture: &Image, reference: &Image) -> f64 {
    let map = flip_map(picture, reference);
    map.iter().sum::<f64>() / map.len() as f64
}

/// The difference that is seen at each pixel.
///
/// # Panics
/// If the sizes differ.
#[must_use]
pub fn flip_map(picture: &Image, reference: &Image) -> Vec<f64> {
    let sizes = [picture, reference].map(|image| [image.width, image.height]);
    assert!(sizes[0] == sizes[1], "a picture of {:?} against one of {:?}", sizes[0], sizes[1]);
    let [a, b] = [picture, reference].map(Seen::of);
    let differences = a.colours.iter().zip(&b.colours).zip(a.features.iter().zip(&b.features));
    differences
        .map(|((&colour_a, &colour_b), (&feature_a, &feature_b))| {
            let colour = redistributed(hyab(colour_a, colour_b));
            libm::pow(colour, 1.0 - feature_difference(feature_a, feature_b))
        })
        .collect()
}

/// What the eye makes of a picture.
struct Seen {
    /// L*a*b* after blurring, adjusted after Hunt.
    colours: Vec<[f64; 3]>,
    /// How strong an edge, how strong a point there is.
    features: Vec<[f64; 2]>,
}

impl Seen {
    fn of(image: &Image) -> Self {
        let linear = image.to_srgb8();
        let (triples, _) = linear.as_chunks::<3>();
        let opponent: Vec<[f64; 3]> = triples
            .iter()
            .map(|bytes| opponent(xyz(bytes.map(|byte| f64::from(srgb::decode(byte))))))
            .collect();
        let channel = |c: usize| Channel {
            width: image.width as usize,
            values: opponent.iter().map(|pixel| pixel[c]).collect(),
        };
        let blurred = [0, 1, 2].map(|c| channel(c).blurred(&SENSITIVITY[c]));
        let colour = |i: usize| {
            let linear = rgb(from_opponent([0, 1, 2].map(|c| blurred[c].values[i])));
            hunt(lab(xyz(linear.map(|x| x.clamp(0.0, 1.0)))))
        };
        let colours = (0..opponent.len()).map(colour).collect();
        Self { colours, features: features(&channel(0)) }
    }
}

/// Contrast sensitivity: a sum of Gaussians, each with an amplitude and a width in degrees². The
/// table of the paper: lightness, red against green, blue against yellow.
const SENSITIVITY: [[[f64; 2]; 2]; 3] =
    [[[1.0, 0.0047], [0.0, 1e-5]], [[1.0, 0.0053], [0.0, 1e-5]], [[34.1, 0.04], [13.5, 0.025]]];
/// The widest of them; all kernels reach three of its standard deviations.
const WIDEST: f64 = 0.04;

/// One number a pixel.
struct Channel {
    width: usize,
    values: Vec<f64>,
}

impl Channel {
    /// Filtered with the kernels of a sensitivity, all weights together being 1.
    ///
    /// ```text
    /// g(x, y) = Σᵢ aᵢ √(π/bᵢ) exp(−π² (x² + y²) / bᵢ),   x, y in degrees
    /// ```
    fn blurred(&self, sensitivity: &[[f64; 2]; 2]) -> Self {
        let reach = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * PIXELS_A_DEGREE).ceil() as i32;
        let kernels = sensitivity.map(|[amplitude, b]| {
            let at = |i: i32| f64::from(i) / PIXELS_A_DEGREE;
            let weights: Vec<f64> =
                (-reach..=reach).map(|i| libm::exp(-PI * PI * at(i) * at(i) / b)).collect();
            let sum: f64 = weights.iter().sum();
            // The weights of the kernel over the plane sum to the square of those of one line.
            let share = amplitude * (PI / b).sqrt() * sum * sum;
            (share, weights.iter().map(|weight| weight / sum).collect::<Vec<_>>())
        });
        let total: f64 = kernels.iter().map(|(share, _)| share).sum();
        let mut values = vec![0.0; self.values.len()];
        for (share, kernel) in kernels.iter().filter(|(share, _)| *share > 0.0) {
            let filtered = self.filtered(kernel, kernel);
            for (value, term) in values.iter_mut().zip(filtered.values) {
                *value += share / total * term;
            }
        }
        Self { width: self.width, values }
    }

    /// Filtered with one kernel across and one down; outside, the nearest pixel goes on.
    fn filtered(&self, across: &[f64], down: &[f64]) -> Self {
        let (width, height) = (self.width as i32, (self.values.len() / self.width) as i32);
        let pass = |values: &[f64], kernel: &[f64], [step_x, step_y]: [i32; 2]| -> Vec<f64> {
            let reach = (kernel.len() / 2) as i32;
            (0..width * height)
                .map(|i| {
                    let (x, y) = (i % width, i / width);
                    let taps = (-reach..=reach).zip(kernel).map(|(k, weight)| {
                        let x = (x + k * step_x).clamp(0, width - 1);
                        let y = (y + k * step_y).clamp(0, height - 1);
                        weight * values[(y * width + x) as usize]
                    });
                    taps.sum()
                })
                .collect()
        };
        let half = pass(&self.values, across, [1, 0]);
        Self { width: self.width, values: pass(&half, down, [0, 1]) }
    }
}

/// Width of the features that stand out most, in degrees.
const FEATURE: f64 = 0.082;

/// The strength of edges and of points: the lengths of the first and the second derivatives of the
/// lightness, under a Gaussian.
fn features(lightness: &Channel) -> Vec<[f64; 2]> {
    let values = lightness.values.iter().map(|y| (y + 16.0) / 116.0).collect();
    let lightness = Channel { width: lightness.width, values };
    let deviation = 0.5 * FEATURE * PIXELS_A_DEGREE;
    let reach = (3.0 * deviation).ceil() as i32;
    let kernel = |weight: &dyn Fn(f64) -> f64| -> Vec<f64> {
        let of = |i| {
            let x = f64::from(i) / deviation;
            weight(x) * libm::exp(-0.5 * x * x)
        };
        (-reach..=reach).map(of).collect()
    };
    let smooth = balanced(&kernel(&|_| 1.0));
    let strength = |derivative: &[f64]| -> Vec<f64> {
        let across = lightness.filtered(derivative, &smooth).values;
        let down = lightness.filtered(&smooth, derivative).values;
        across.iter().zip(&down).map(|(x, y)| (x * x + y * y).sqrt()).collect()
    };
    let edges = strength(&balanced(&kernel(&|x| -x)));
    let points = strength(&balanced(&kernel(&|x| x * x - 1.0)));
    edges.iter().zip(&points).map(|(&edge, &point)| [edge, point]).collect()
}

/// The kernel with positive weights that sum to 1, and negative ones that sum to −1.
fn balanced(kernel: &[f64]) -> Vec<f64> {
    let sum = |sign: f64| kernel.iter().map(|w| (sign * w).max(0.0)).sum::<f64>();
    let (positive, negative) = (sum(1.0), sum(-1.0));
    kernel.iter().map(|&w| if w >= 0.0 { w / positive } else { w / negative }).collect()
}

/// The larger difference of the two features, 0 to 1, small ones raised by a root.
fn feature_difference([edge_a, point_a]: [f64; 2], [edge_b, point_b]: [f64; 2]) -> f64 {
    let difference = (edge_a - edge_b).abs().max((point_a - point_b).abs());
    (difference * std::f64::consts::FRAC_1_SQRT_2).sqrt().min(1.0)
}

/// Small distances by the 0.7th power; those above 0.4 of the largest share what lies above 0.95.
fn redistributed(distance: f64) -> f64 {
    const EXPONENT: f64 = 0.7;
    const FRACTION: f64 = 0.4;
    const VALUE: f64 = 0.95;
    let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|colour| hunt(lab(xyz(colour))));
    let largest = libm::pow(hyab(green, blue), EXPONENT);
    let (distance, bend) = (libm::pow(distance, EXPONENT), FRACTION * largest);
    if distance < bend {
        VALUE / bend * distance
    } else {
        VALUE + (distance - bend) / (largest - bend) * (1.0 - VALUE)
    }
}

/// The distance of lightness plus that of colour: |ΔL| + √(Δa² + Δb²).
fn hyab(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [l, x, y] = std::array::from_fn(|i| a[i] - b[i]);
    let (l, x, y): (f64, f64, f64) = (l, x, y);
    l.abs() + (x * x + y * y).sqrt()
}

/// The darker, the less colourful.
fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// Linear Rec. 709 to CIE XYZ, white having Y = 1 and the colour of D65.
const TO_XYZ: [[f64; 3]; 3] = [
    [0.412_386_56, 0.357_591_49, 0.180_450_49],
    [0.212_636_82, 0.715_182_98, 0.072_180_20],
    [0.019_330_62, 0.119_197_16, 0.950_372_59],
];

/// What XYZ is divided by: white.
const WHITE: [f64; 3] = [
    TO_XYZ[0][0] + TO_XYZ[0][1] + TO_XYZ[0][2],
    TO_XYZ[1][0] + TO_XYZ[1][1] + TO_XYZ[1][2],
    TO_XYZ[2][0] + TO_XYZ[2][1] + TO_XYZ[2][2],
];

/// XYZ of a linear colour, relative to white.
fn xyz(rgb: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|c| TO_XYZ[i][c] * rgb[c]).sum::<f64>() / WHITE[i])
}

/// The inverse of [`xyz`], by Cramer's rule.
fn rgb(relative: [f64; 3]) -> [f64; 3] {
    let xyz: [f64; 3] = std::array::from_fn(|i| relative[i] * WHITE[i]);
    let whole = determinant(TO_XYZ);
    std::array::from_fn(|c| {
        let mut matrix = TO_XYZ;
        for i in 0..3 {
            matrix[i][c] = xyz[i];
        }
        determinant(matrix) / whole
    })
}

fn determinant(m: [[f64; 3]; 3]) -> f64 {
    let minor = |a: usize, b: usize| m[1][a] * m[2][b] - m[1][b] * m[2][a];
    m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1)
}

/// YCxCz, in which blurring is linear: L*a*b* without its roots.
fn opponent([x, y, z]: [f64; 3]) -> [f64; 3] {
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn from_opponent([y, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (y + 16.0) / 116.0;
    [y + cx / 500.0, y, y - cz / 200.0]
}

/// CIE L*a*b* of 1976.
fn lab(relative: [f64; 3]) -> [f64; 3] {
    const DELTA: f64 = 6.0 / 29.0;
    let root = |t: f64| {
        if t > DELTA * DELTA * DELTA {
            libm::cbrt(t)
        } else {
            t / (3.0 * DELTA * DELTA) + 4.0 / 29.0
        }
    };
    let [x, y, z] = relative.map(root);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

#[cfg(test)]
mod tests {
    use super::{Seen, flip, flip_map, from_opponent, lab, opponent, redistributed, rgb, xyz};
    use workbench::Image;

    fn flat(rgb: [f32; 3]) -> Image {
        Image { width: 24, height: 20, pixels: vec![rgb; 480] }
    }

    /// Noise from whole numbers: any picture will do.
    fn noise(seed: u32) -> Image {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 16_777_216.0
        };
        let pixels = (0..480).map(|_| [next(), next(), next()]).collect();
        Image { pixels, ..flat([0.0; 3]) }
    }

    #[test]
    fn a_picture_is_no_different_from_itself() {
        for image in [flat([0.2, 0.4, 0.6]), noise(1)] {
            assert_eq!(flip(&image, &image), 0.0, "against itself");
        }
    }

    #[test]
    fn the_order_does_not_matter_and_no_difference_exceeds_one() {
        let (a, b) = (noise(1), noise(2));
        assert_eq!(flip_map(&a, &b), flip_map(&b, &a), "both ways");
        let inside = flip_map(&a, &b).iter().all(|d| (0.0..=1.0).contains(d));
        assert!(inside, "{:?}", flip_map(&a, &b));
        let mean = flip(&a, &b);
        assert!(mean > 0.05 && mean < 0.95, "two kinds of noise differ by {mean}");
    }

    /// The scale ends at green against blue, the farthest of all colours; without features nothing
    /// is raised.
    #[test]
    fn green_against_blue_is_one() {
        let difference = flip(&flat([0.0, 1.0, 0.0]), &flat([0.0, 0.0, 1.0]));
        assert!((difference - 1.0).abs() < 1e-9, "{difference}");
    }

    /// ΔL = 100, no colour: 100^0.7 = 25.119. Green (87.73, −86.2, 83.2) and blue (32.3, 79.2,
    /// −107.9) are, after Hunt, 203.4 apart, 41.28 by the power, of which 0.4 is 16.51:
    /// 0.95 + 0.05 (25.119 − 16.51)/24.77.
    #[test]
    fn black_against_white_is_the_value_by_hand() {
        let difference = flip(&flat([0.0; 3]), &flat([1.0; 3]));
        assert!((difference - 0.967_4).abs() < 2e-4, "{difference}");
    }

    /// Two greys, by hand: the bytes 128 and 138 are Y = 0.21586 and 0.25415, L* = 53.585 and
    /// 57.482, so ΔL = 3.897. 3.897^0.7 = 2.591, times 0.95/16.51.
    #[test]
    fn two_greys_differ_by_the_value_by_hand() {
        let grey = |byte: u8| Image::from_srgb8(24, 20, &[byte; 3 * 480]);
        let difference = flip(&grey(128), &grey(138));
        let expected = 2.591 * 0.95 / 16.51;
        assert!((difference / expected - 1.0).abs() < 5e-3, "{difference}, by hand {expected}");
    }

    #[test]
    fn colours_of_the_tables_are_met() {
        for (colour, expected) in [
            ([1.0; 3], [100.0, 0.0, 0.0]),
            ([1.0, 0.0, 0.0], [53.24, 80.09, 67.20]),
            ([0.0, 1.0, 0.0], [87.73, -86.18, 83.18]),
            ([0.0, 0.0, 1.0], [32.30, 79.19, -107.86]),
        ] {
            let found = lab(xyz(colour));
            let far = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f64::max);
            assert!(far < 0.05, "{colour:?}: {found:?}, in tables {expected:?}");
            let back = rgb(from_opponent(opponent(xyz(colour))));
            let far = (0..3).map(|i| (back[i] - colour[i]).abs()).fold(0.0, f64::max);
            assert!(far < 1e-9, "{colour:?} comes back as {back:?}");
        }
    }

    /// A flat picture has no features, and one white pixel has both, more the nearer.
    #[test]
    fn features_are_where_something_is() {
        let seen = Seen::of(&flat([0.3; 3]));
        let strongest = seen.features.iter().flatten().fold(0.0_f64, |a, &b| a.max(b));
        assert!(strongest < 1e-12, "{strongest} in a flat picture");
        let mut dot = flat([0.0; 3]);
        dot.pixels[10 * 24 + 12] = [1.0; 3];
        let map = flip_map(&dot, &flat([0.0; 3]));
        let [near, far] = [map[10 * 24 + 12], map[0]];
        assert!(near > 0.1 && far < 1e-3, "{near} at the dot, {far} in the corner");
    }

    /// An edge between black and white is as strong an edge as there is: the positive weights,
    /// which sum to 1, lie on white.
    #[test]
    fn an_edge_from_black_to_white_has_the_strength_of_one() {
        let mut image = Image::new(41, 9);
        for (i, pixel) in image.pixels.iter_mut().enumerate() {
            *pixel = [if i % 41 < 20 { 0.0 } else { 1.0 }; 3];
        }
        let features = Seen::of(&image).features;
        let strongest = features.iter().map(|[edge, _]| *edge).fold(0.0, f64::max);
        assert!((strongest - 1.0).abs() < 1e-9, "{strongest}");
    }

    #[test]
    fn the_scale_is_monotonous_from_0_to_1() {
        let values: Vec<f64> = (0..=203).map(|d| redistributed(f64::from(d))).collect();
        assert_eq!(values[0], 0.0, "no distance");
        assert!(values.windows(2).all(|w| w[0] < w[1]), "{values:?}");
        assert!(values[203] > 0.99 && values[203] <= 1.0, "{}", values[203]);
    }
}
