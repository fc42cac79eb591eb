//! Two noisy pictures of the same thing.

use crate::mean::Student;
use crate::noisy::Noisy;
use crate::normal::two_sided_critical_z;
use crate::suite::{POWER_Z, TEST_ALPHA, per_test_alpha};

/// How far two pictures may differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criterion {
    /// The probability of a false alarm for the mean of the picture in one channel.
    ///
    /// The blocks share as much again, all channels together, after Šidák.
    pub alpha: f64,
    /// Width and height of a block, in pixels; blocks at the right and the lower edge are smaller.
    pub block: usize,
}

impl Criterion {
    /// The picture's mean within 3 combined standard errors in each channel (one in 370 by chance),
    /// and 16 × 16 blocks with the same rate for all of them together. For fixed seeds.
    pub const THREE_SIGMA: Self = Self { alpha: 0.002_699_796_063_260_191, block: 16 };

    /// The share of a test in the suite's rate of false alarms, as for all other tests.
    pub const SUITE: Self = Self { alpha: TEST_ALPHA / 4.0, block: 16 };
}

/// How well two pictures agree that passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The difference of the means, first less second, in combined standard errors, per channel.
    pub mean_z: [f64; 3],
    /// The relative difference of the means, per channel; 0 for two black channels.
    pub relative_difference: [f64; 3],
    /// The smallest bias of the picture's mean, relative to the second picture's, that would have
    /// been noticed with a probability of 99 %; the worst channel's.
    pub visible_bias: f64,
    /// The block that differs most.
    pub worst_block: Block,
    /// How many standard errors were allowed to a block.
    pub block_limit: f64,
}

/// One channel of one block.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Block {
    /// Column and row of its first pixel.
    pub pixel: [usize; 2],
    /// 0, 1, 2: red, green, blue.
    pub channel: usize,
    /// The difference, first less second, as the standard errors of a normal quantity with the same
    /// probability.
    pub z: f64,
    /// The mean of the first and of the second picture in the block.
    pub means: [f64; 2],
}

/// Asserts that two pictures show the same up to their noise.
///
/// # Panics
/// If [`compare_images`] fails.
#[expect(clippy::must_use_candidate, reason = "that it passed may be all that matters")]
#[track_caller]
pub fn assert_images(
    name: &str,
    size: [usize; 2],
    a: &Noisy<'_>,
    b: &Noisy<'_>,
    criterion: &Criterion,
) -> Agreement {
    compare_images(name, size, a, b, criterion).unwrap_or_else(|sentence| panic!("{sentence}"))
}

/// Whether two pictures of `size` (width, height) show the same up to their noise.
///
/// Welch's test for the mean of the whole picture and of every block, channel by channel: the
/// difference against the root of both pictures' summed variances, with the degrees of freedom that
/// the pixels' numbers of samples give. Neighbouring pixels must not share samples. Where neither
/// picture has variance (a black background, a lamp), only rounding may differ.
///
/// The second picture is the one that biases are relative to: the reference, if there is one.
///
/// A picture of few samples that misses a rare bright path is too dark *and* takes itself for too
/// exact. Take enough samples that each block has met what brightens it.
///
/// # Errors
/// If the pictures differ by more than `criterion` allows; if a mean is not finite, a variance not
/// finite or negative; if the number of pixels is not that of `size`, or is 0; or if a variance
/// comes from fewer than 2 samples.
pub fn compare_images(
    name: &str,
    size: [usize; 2],
    a: &Noisy<'_>,
    b: &Noisy<'_>,
    criterion: &Criterion,
) -> Result<Agreement, String> {
    for (which, picture) in [("first", a), ("second", b)] {
        picture.sound(size).map_err(|fault| format!("{name}, {which} picture: {fault}"))?;
    }
    let [width, height] = size;
    let whole = [[0, width], [0, height]];
    let tests = [0, 1, 2].map(|channel| compare(size, a, b, whole, channel));
    let blocks = blocks(size, criterion.block);
    let worst = blocks.iter().flat_map(|&[x, y]| {
        [0, 1, 2].map(|channel| {
            let (test, means) = compare(size, a, b, [x, y], channel);
            Block { pixel: [x[0], y[0]], channel, z: signed_z(&test), means }
        })
    });
    let worst = worst.max_by(|a, b| a.z.abs().total_cmp(&b.z.abs())).unwrap_or_default();

    let mean_limit = two_sided_critical_z(criterion.alpha);
    let comparisons = u32::try_from(3 * blocks.len()).unwrap_or(u32::MAX);
    let block_limit = two_sided_critical_z(per_test_alpha(criterion.alpha, comparisons));
    let agreement = Agreement {
        mean_z: tests.map(|(test, _)| signed_z(&test)),
        relative_difference: tests.map(|(test, means)| relative(test.difference, means[1])),
        visible_bias: tests
            .iter()
            .map(|(test, means)| {
                let bias = (mean_limit + POWER_Z) * test.standard_error + test.rounding;
                relative(bias, means[1])
            })
            .fold(0.0, f64::max),
        worst_block: worst,
        block_limit,
    };
    for (channel, (test, means)) in tests.iter().enumerate() {
        if test.p() < criterion.alpha {
            return Err(format!(
                "{name}: the means of {} differ: {:.6} and {:.6} ({:+.3} %), z = {:+.2}, at most \
                 {mean_limit:.2} are allowed",
                CHANNELS[channel],
                means[0],
                means[1],
                100.0 * agreement.relative_difference[channel],
                agreement.mean_z[channel]
            ));
        }
    }
    if worst.z.abs() > block_limit {
        let [x, y] = worst.pixel;
        return Err(format!(
            "{name}: {} differs in the block at ({x}, {y}): {:.6} and {:.6}, z = {:+.2}, at most \
             {block_limit:.2} are allowed in {} blocks",
            CHANNELS[worst.channel],
            worst.means[0],
            worst.means[1],
            worst.z,
            blocks.len()
        ));
    }
    Ok(agreement)
}

const CHANNELS: [&str; 3] = ["red", "green", "blue"];

/// First column and the one after the last, first row and the one after the last.
type Region = [[usize; 2]; 2];

/// The blocks of a picture, row by row.
fn blocks([width, height]: [usize; 2], side: usize) -> Vec<Region> {
    let ranges = |length: usize| {
        (0..length).step_by(side.max(1)).map(move |start| [start, length.min(start + side.max(1))])
    };
    ranges(height).flat_map(|y| ranges(width).map(move |x| [x, y])).collect()
}

/// The test of one channel's mean over a region, and both means.
fn compare(
    [width, _]: [usize; 2],
    a: &Noisy<'_>,
    b: &Noisy<'_>,
    [x, y]: Region,
    channel: usize,
) -> (Student, [f64; 2]) {
    let count = ((x[1] - x[0]) * (y[1] - y[0])) as f64;
    let pixels = || (y[0]..y[1]).flat_map(|row| (x[0]..x[1]).map(move |x| row * width + x));
    let mean = |picture: &Noisy<'_>| {
        pixels().map(|i| f64::from(picture.mean[i][channel])).sum::<f64>() / count
    };
    let parts = [a, b].into_iter().flat_map(|picture| {
        let degrees = f64::from(picture.samples - 1);
        pixels().map(move |i| (f64::from(picture.variance[i][channel]) / (count * count), degrees))
    });
    let means = [mean(a), mean(b)];
    (Student::welch(means[0] - means[1], means[0].abs().max(means[1].abs()), parts), means)
}

/// The z that is as unlikely for a normal quantity as the test's t is for its own.
fn signed_z(test: &Student) -> f64 {
    let p = test.p();
    let z = if p < 1e-299 {
        f64::INFINITY
    } else if p >= 1.0 {
        0.0
    } else {
        two_sided_critical_z(p)
    };
    z.copysign(test.difference)
}

fn relative(difference: f64, to: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference / to.abs() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::seed;
    use crate::uniform::Uniform;

    const SIZE: [usize; 2] = [100, 70];

    /// A picture with a black sky, a lamp without noise, and a noisy ground.
    struct Picture {
        mean: Vec<[f32; 3]>,
        variance: Vec<[f32; 3]>,
    }

    impl Picture {
        /// Pixels of `samples` uniform numbers each, times a colour of the place, plus a bias.
        fn render(number: u64, samples: u32, bias: impl Fn(usize, usize) -> f64) -> Self {
            let mut random = Uniform(seed(number));
            let (mut mean, mut variance) = (Vec::new(), Vec::new());
            for (y, x) in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (y, x))) {
                let moments: crate::Moments = (0..samples).map(|_| random.next()).collect();
                let (value, spread) = match y {
                    0..20 => (0.0, 0.0),
                    20..22 => (17.0, 0.0),
                    _ => (moments.mean(), moments.variance_of_mean()),
                };
                let colour = [1.0, 0.3 + 0.002 * x as f64, 0.1];
                mean.push(colour.map(|c| (c * value * (1.0 + bias(x, y))) as f32));
                variance.push(colour.map(|c| (c * c * spread) as f32));
            }
            Self { mean, variance }
        }

        fn noisy(&self, samples: u32) -> Noisy<'_> {
            Noisy { mean: &self.mean, variance: &self.variance, samples }
        }
    }

    fn right(number: u64, samples: u32) -> Picture {
        Picture::render(number, samples, |_, _| 0.0)
    }

    /// With the suite's rate of alarms: these tests must pass for fresh seeds, too.
    fn compared(first: &Picture, second: &Picture) -> Result<Agreement, String> {
        compare_images("pictures", SIZE, &first.noisy(64), &second.noisy(96), &Criterion::SUITE)
    }

    #[test]
    fn two_renders_of_the_same_agree_and_tell_what_they_would_have_seen() {
        let agreement = compared(&right(21, 64), &right(22, 96)).expect("both show the same");
        assert!(agreement.visible_bias < 0.01, "{agreement:?}");
        assert!(agreement.worst_block.z.abs() < agreement.block_limit, "{agreement:?}");
    }

    #[test]
    fn a_ground_that_is_one_percent_brighter_is_found() {
        let ground = |_, y| if y < 22 { 0.0 } else { 0.01 };
        let sentence = compared(&Picture::render(21, 64, ground), &right(22, 96))
            .expect_err("one percent is more than seven standard errors");
        assert!(sentence.contains("the means of red"), "{sentence}");
    }

    /// One block is brighter, another nearly as much darker: the mean of the picture is right.
    #[test]
    fn a_fault_in_one_block_is_found_where_it_is() {
        let fault = |x: usize, y: usize| match (x, y) {
            (48..64, 32..48) => 0.08,
            (16..32, 48..64) => -0.05,
            _ => 0.0,
        };
        let sentence = compared(&Picture::render(21, 64, fault), &right(22, 96))
            .expect_err("eight percent are more than ten standard errors of a block");
        assert!(sentence.contains("block at (48, 32)"), "{sentence}");
    }

    #[test]
    fn rare_alarms_are_as_rare_as_stated() {
        let alarms = (0..100).filter(|i| {
            let a = right(1000 + 2 * i, 8);
            let b = right(1001 + 2 * i, 8);
            compare_images("same", SIZE, &a.noisy(8), &b.noisy(8), &Criterion::THREE_SIGMA).is_err()
        });
        // At most 4 × 0.27 % are expected; the channels share their samples, so fewer.
        let alarms = alarms.count();
        assert!(alarms <= 9, "{alarms} alarms in 100 comparisons");
    }

    #[test]
    fn what_has_no_noise_must_be_equal_up_to_rounding() {
        let a = right(21, 16);
        for (pixel, value, passes) in [
            (2105, [17.000_002, 17.0 * 0.31, 1.7], true),
            (2105, [17.01, 17.0 * 0.31, 1.7], false),
            (100, [1e-6, 0.0, 0.0], false),
        ] {
            let mut b = right(21, 16);
            b.mean[pixel] = value;
            let found = compared(&b, &a);
            // The lamp at 2105 lies in a noisy block: it is looked at by itself.
            let lamp = |picture: &Picture| Picture {
                mean: picture.mean[pixel..=pixel].to_vec(),
                variance: picture.variance[pixel..=pixel].to_vec(),
            };
            let (b, a) = (lamp(&b), lamp(&a));
            let single = compare_images(
                "pixel",
                [1, 1],
                &b.noisy(16),
                &a.noisy(16),
                &Criterion::THREE_SIGMA,
            );
            assert_eq!(single.is_ok(), passes, "{value:?}: {single:?}");
            assert!(passes || pixel != 100 || found.is_err(), "a lit sky passes: {found:?}");
        }
    }

    #[test]
    fn what_is_not_finite_or_not_there_never_passes() {
        let good = right(21, 16);
        for broken in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let mut mean = right(21, 16);
            mean.mean[3000][1] = broken;
            let mut variance = right(21, 16);
            variance.variance[3000][1] = broken;
            for picture in [&mean, &variance] {
                assert!(compared(picture, &good).is_err(), "{broken} passes in the first");
                assert!(compared(&good, picture).is_err(), "{broken} passes in the second");
            }
        }
        let mut negative = right(21, 16);
        negative.variance[3000][1] = -1.0;
        assert!(compared(&negative, &good).is_err(), "a negative variance passes");

        let none = Noisy { mean: &[], variance: &[], samples: 16 };
        let empty = compare_images("none", [0, 0], &none, &none, &Criterion::SUITE);
        assert!(empty.is_err(), "no pixels pass");
        let small =
            compare_images("size", [10, 10], &good.noisy(16), &good.noisy(16), &Criterion::SUITE);
        assert!(small.is_err(), "another size passes");
        let single =
            compare_images("one", SIZE, &good.noisy(1), &good.noisy(16), &Criterion::SUITE);
        assert!(single.is_err(), "a variance of one sample passes");
    }

    #[test]
    fn the_blocks_cover_every_pixel_once() {
        let mut covered = vec![0; SIZE[0] * SIZE[1]];
        for [x, y] in blocks(SIZE, 16) {
            for i in (y[0]..y[1]).flat_map(|y| (x[0]..x[1]).map(move |x| y * SIZE[0] + x)) {
                covered[i] += 1;
            }
        }
        assert!(covered.iter().all(|&count| count == 1), "a pixel is covered twice or never");
    }

    #[test]
    fn the_constants_are_what_they_say() {
        let alpha = 2.0 * crate::normal_upper_tail(3.0);
        assert!((Criterion::THREE_SIGMA.alpha / alpha - 1.0).abs() < 1e-12, "α = {alpha}");
    }
}
