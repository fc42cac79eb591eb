//! Mistakes of chapter 0: random numbers, pixels, bytes.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "workbench";
const SAMPLER: &str = "chapters/00-workbench/src/sampler.rs";
const SUM: &str = "chapters/00-workbench/src/pixel_sum.rs";

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "a random number may be 1",
        lesson: "all 32 bits round up to 1 once in 33 million draws, 24 bits never",
        file: SAMPLER,
        old: "(bits >> 8) as f32 * (1.0 / 16_777_216.0)",
        new: "bits as f32 * (1.0 / 4_294_967_296.0)",
        test: Test::lib(PACKAGE, "numbers_stay_below_one"),
    },
    Mutant {
        name: "neighbouring pixels share a seed",
        lesson: "shared numbers make patterns that no average removes",
        file: SAMPLER,
        old: "mixed(mixed(seed) ^ pixel) ^ sample",
        new: "mixed(mixed(seed) ^ (pixel / 2)) ^ sample",
        test: Test::lib(PACKAGE, "neighbours_in_every_part_of_the_key_are_uncorrelated"),
    },
    Mutant {
        name: "seed, pixel and sample are added up",
        lesson: "the second sample of a pixel is then the first of its neighbour",
        file: SAMPLER,
        old: "mixed(mixed(mixed(seed) ^ pixel) ^ sample)",
        new: "mixed(seed.wrapping_add(pixel).wrapping_add(sample))",
        test: Test::lib(PACKAGE, "keys_of_equal_sum_have_numbers_of_their_own"),
    },
    Mutant {
        name: "each thread has a generator of its own",
        lesson: "which thread takes which tile is chance, so no two pictures are the same",
        file: "chapters/00-workbench/src/film.rs",
        old: "Sampler::new(seed, index, u64::from(sample))",
        new: "Sampler::new(rayon::current_thread_index().unwrap_or(0) as u64, index, sample.into())",
        test: Test::lib(PACKAGE, "the_picture_does_not_depend_on_threads"),
    },
    Mutant {
        name: "one NaN spoils its pixel",
        lesson: "a single sample that is not finite outweighs any number of good ones",
        file: SUM,
        old: "(radiance[0] + radiance[1] + radiance[2]).is_finite()",
        new: "true",
        test: Test::lib(PACKAGE, "samples_that_are_not_finite_are_counted_and_left_out"),
    },
    Mutant {
        name: "samples that are not finite are dropped in silence",
        lesson: "a NaN that counts as black hides the fault and darkens the pixel",
        file: SUM,
        old: "if is_finite {\n            self.finite += 1;",
        new: "self.finite += 1;\n        if is_finite {",
        test: Test::lib(PACKAGE, "samples_that_are_not_finite_are_counted_and_left_out"),
    },
    Mutant {
        name: "samples are added up in single precision",
        lesson: "a bright sample swallows the faint ones that follow it",
        file: SUM,
        old: "*sum += value;",
        new: "*sum = f64::from((*sum + value) as f32);",
        test: Test::lib(PACKAGE, "a_pixel_is_the_mean_of_its_samples"),
    },
    Mutant {
        name: "the film point is half a pixel off",
        lesson: "centres and corners of pixels are confused: the picture moves by half a pixel",
        file: "chapters/00-workbench/src/film_point.rs",
        old: "(pixel as f32 + u)",
        new: "(pixel as f32 + u - 0.5)",
        test: Test::lib(PACKAGE, "a_point_stays_in_its_pixel"),
    },
    Mutant {
        name: "a pixel decides its own number of samples",
        lesson: "it stops while its rare bright samples are missing, and is too dark",
        file: "chapters/00-workbench/src/need.rs",
        old: "if j != i && !variances[j].is_nan()",
        new: "if !variances[j].is_nan()",
        test: Test::lib(PACKAGE, "a_pixel_has_no_say_in_its_own_number"),
    },
    Mutant {
        name: "samples in proportion to the variance",
        lesson: "its root is best: beyond, samples go where they do less good than elsewhere",
        file: "chapters/00-workbench/src/need.rs",
        old: "median.sqrt()",
        new: "*median",
        test: Test::lib(PACKAGE, "the_need_is_the_root_of_the_median_of_the_neighbours"),
    },
    Mutant {
        name: "a power of 2.2 instead of the sRGB curve",
        lesson: "the two differ by up to six bytes, most of all in the dark",
        file: "chapters/00-workbench/src/srgb.rs",
        old: "if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }",
        new: "libm::pow(c, 2.2)",
        test: Test::lib(PACKAGE, "known_values_have_their_bytes"),
    },
];
