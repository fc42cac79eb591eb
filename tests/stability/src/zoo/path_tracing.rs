//! Mistakes of chapter 6: where a path ends.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "path-tracing";
const RADIANCE: &str = "chapters/06-path-tracing/src/radiance.rs";

/// Every way to end paths, against one closed form.
const FURNACE: Test =
    Test::of(PACKAGE, "paths", "a_furnace_is_as_bright_however_its_paths_are_drawn_and_ended");

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "roulette does not divide by q",
        lesson: "those who survive must carry the light of those who do not",
        file: RADIANCE,
        old: "throughput /= q;",
        new: "throughput /= 1.0;",
        test: FURNACE,
    },
    Mutant {
        name: "roulette divides twice",
        lesson: "one division restores the mean, a second one makes light",
        file: RADIANCE,
        old: "throughput /= q;",
        new: "throughput /= q * q;",
        test: FURNACE,
    },
    Mutant {
        name: "roulette spares the wrong ones",
        lesson: "a path goes on with probability q, not 1 − q",
        file: RADIANCE,
        old: "if sampler.next_1d() >= q {",
        new: "if sampler.next_1d() < q {",
        test: Test::of(PACKAGE, "paths", "the_number_of_vertices_of_a_path_is_geometric"),
    },
    Mutant {
        name: "a path is one event too long",
        lesson: "depth D means D events: ρ to the power of D + 1 is lost, no more and no less",
        file: RADIANCE,
        old: "if events == self.ending.depth {",
        new: "if events == self.ending.depth.saturating_add(1) {",
        test: Test::of(
            PACKAGE,
            "paths",
            "erratum_20_a_depth_limit_loses_albedo_to_the_power_of_depth_plus_one",
        ),
    },
    Mutant {
        name: "glass ends paths",
        lesson: "light that glass squeezes is spread again: it says nothing of what a path is worth",
        file: RADIANCE,
        old: "survival(throughput / squeezed, events)",
        new: "survival(throughput / (0.0 * squeezed + 1.0), events)",
        test: Test::of(
            PACKAGE,
            "paths",
            "roulette_does_not_end_paths_because_glass_squeezes_light",
        ),
    },
    Mutant {
        name: "the sky is forgotten",
        lesson: "a ray that leaves the scene brings the background's light",
        file: RADIANCE,
        old: "radiance += throughput * self.scene.background;",
        new: "radiance += 0.0 * throughput * self.scene.background;",
        test: Test::of(PACKAGE, "paths", "a_black_ball_takes_a_quarter_of_the_sky"),
    },
];
