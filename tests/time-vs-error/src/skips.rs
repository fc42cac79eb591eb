//! What the skips are worth: each with and without, side by side.

use statistics::grouped;

use crate::counts::{Counts, render};
use crate::curve::Spread;
use crate::error::Result;
use crate::markdown::{factor, scientific, table};
use crate::row::spent;
use crate::stages::{Rendered, Stages};

/// A skip that an option switches off.
#[derive(Clone, Copy, Debug)]
pub struct Skip {
    /// The scene.
    pub scene: &'static str,
    /// The stage.
    pub stage: &'static str,
    /// Options with which it is skipped, and samples that take long enough for a clock.
    pub with: (&'static str, u32),
    /// Options without which it is not, and samples likewise.
    pub without: (&'static str, u32),
    /// What becomes faster.
    pub part: Part,
}

/// A part of a render that takes time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Until the scene and its pictures are there.
    Loading,
    /// From then on, for each sample of a pixel.
    Sample,
}

impl Skip {
    /// What is skipped.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self.without.0 {
            "--volume none" => "what volumes enclose",
            "--no-skip shadow_rays_facing_away" => "shadow rays from which no light could come",
            "--no-skip shadow_rays_nothing_to_reflect" => "shadow rays with nothing to reflect",
            "--no-skip shadow_rays_delta" => "shadow rays at mirrors and glass",
            "--no-skip any_hit_exits" => "the search after the first hit of a shadow ray",
            "--no-skip paths_ended_by_black" => "paths from black surfaces",
            "--no-skip fresnel_splits" => "splits between equal indices",
            "--no-skip surface_points" => "points and normals of other hits",
            "--no-skip own_triangles" => "the triangles that a ray starts and ends on",
            "--no-skip walls_left_out" => "walls and the only lamp, by shadow rays",
            "--no-skip texture_coordinates" => "texture coordinates without a picture",
            "--no-skip trees_not_built" => "trees over few primitives",
            "--for-any-scene" => "code for what is not there",
            "--no-skip textures_not_loaded" => "pictures that are not needed",
            "--cutoff 0" => "branches below the cutoff",
            "--depth 16 --roulette off" => "paths, by roulette",
            options => options,
        }
    }

    /// Under which key of `skipped` it is counted, if it is.
    #[must_use]
    pub fn key(&self) -> Option<&'static str> {
        match self.without.0 {
            "--cutoff 0" => Some("branches_below_threshold"),
            "--depth 16 --roulette off" => Some("paths_ended_by_roulette"),
            options => options.strip_prefix("--no-skip "),
        }
    }
}

/// Every skip that can be switched off, on scenes in which it has something to do.
pub const SKIPS: [Skip; 33] = [
    volumes("teapot", 2),
    volumes("whitted-teapot", 1),
    volumes("many-lights", 4),
    skip("many-lights", "bv-tree", 16, "--no-skip shadow_rays_facing_away"),
    skip("cornell-box", "light-sampling", 64, "--no-skip shadow_rays_facing_away"),
    skip("veach-plates", "bv-tree", 64, "--no-skip shadow_rays_nothing_to_reflect"),
    skip("many-lights", "bv-tree", 16, "--no-skip shadow_rays_nothing_to_reflect"),
    skip("sphereflake", "light-sampling", 64, "--no-skip shadow_rays_delta"),
    skip("sphereflake", "mirror-refraction", 4, "--no-skip any_hit_exits"),
    skip("sphereflake", "bv-tree", 64, "--no-skip any_hit_exits"),
    skip("cornell-box", "light-sampling", 64, "--no-skip any_hit_exits"),
    skip("veach-plates", "path-tracing", 64, "--no-skip paths_ended_by_black"),
    skip("touching-glass", "mirror-refraction", 64, "--no-skip fresnel_splits"),
    skip("nested-glass", "mirror-refraction", 64, "--no-skip surface_points"),
    skip("cornell-box", "light-sampling", 64, "--no-skip surface_points"),
    skip("teapot", "path-tracing", 64, "--no-skip own_triangles"),
    skip("cornell-box", "light-sampling", 64, "--no-skip own_triangles"),
    skip("cornell-box", "light-sampling", 64, "--no-skip walls_left_out"),
    skip("cornell-spheres", "light-sampling", 64, "--no-skip walls_left_out"),
    skip("sphereflake", "bv-tree", 64, "--no-skip texture_coordinates"),
    skip("cornell-box", "light-sampling", 64, "--no-skip texture_coordinates"),
    pictures("whitted", "ray-casting"),
    skip("nested-glass", "bv-tree", 64, "--no-skip trees_not_built"),
    skip("whitted", "light-sampling", 64, "--no-skip trees_not_built"),
    skip("whitted", "mirror-refraction", 128, "--cutoff 0"),
    skip("nested-glass", "mirror-refraction", 128, "--cutoff 0"),
    skip("whitted-teapot", "bv-tree", 128, "--cutoff 0"),
    paths("cornell-box", "path-tracing"),
    paths("cornell-box", "light-sampling"),
    paths("many-lights", "light-sampling"),
    skip("cornell-box", "rendering-equation", 16, "--for-any-scene"),
    skip("cornell-box", "path-tracing", 64, "--for-any-scene"),
    skip("cornell-box", "light-sampling", 64, "--for-any-scene"),
];

/// One that the stage makes without options.
const fn skip(
    scene: &'static str,
    stage: &'static str,
    samples: u32,
    without: &'static str,
) -> Skip {
    Skip { scene, stage, with: ("", samples), without: (without, samples), part: Part::Sample }
}

/// Without volumes, a few samples take long enough.
const fn volumes(scene: &'static str, samples: u32) -> Skip {
    Skip { without: ("--volume none", samples), ..skip(scene, "bv-tree", 64, "") }
}

const fn pictures(scene: &'static str, stage: &'static str) -> Skip {
    Skip { part: Part::Loading, ..skip(scene, stage, 1, "--no-skip textures_not_loaded") }
}

/// Without roulette, something else has to end a path.
const fn paths(scene: &'static str, stage: &'static str) -> Skip {
    let without = "--depth 16 --roulette off";
    Skip { with: ("--depth 16", 64), ..skip(scene, stage, 64, without) }
}

/// A skip with what it is worth.
#[derive(Clone, Debug)]
pub struct Worth {
    /// The skip.
    pub skip: Skip,
    /// Counts with the skip, and without.
    pub counts: [Counts; 2],
    /// Median of the ratios of the time, with / without, of the part that becomes faster.
    pub time: f64,
    /// How far apart the pictures are: relMSE of the one with the skip against the other, and the
    /// largest difference of a byte. `None` if they are the same floats.
    pub difference: Option<(f64, u8)>,
}

impl Worth {
    /// How often something was skipped, if that is counted.
    #[must_use]
    pub fn times(&self) -> Option<u64> {
        Some(self.counts[0].skipped[self.skip.key()?])
    }
}

/// Counts with and without each skip, one sample a pixel, and takes the times, in turn.
///
/// # Errors
/// If a stage fails.
pub fn weigh_all(stages: &Stages, size: [u32; 2], rounds: u32) -> Result<Vec<Worth>> {
    SKIPS.into_iter().map(|skip| weigh(stages, skip, size, rounds)).collect()
}

fn weigh(stages: &Stages, skip: Skip, [width, height]: [u32; 2], rounds: u32) -> Result<Worth> {
    let one = |(options, samples): (&str, u32)| {
        let arguments = format!("{options} --size {width}x{height} --samples {samples}");
        render(stages, skip.scene, skip.stage, &arguments)
    };
    let counted = |(options, _)| one((options, 1));
    let (with, without) = (counted(skip.with)?, counted(skip.without)?);
    let time = |(options, samples)| -> Result<f64> {
        let rendered = one((options, samples))?;
        let [load, _, render] = spent(rendered.seconds(), rendered.cpu);
        Ok(match skip.part {
            Part::Loading => load,
            Part::Sample => render / f64::from(samples),
        })
    };
    let mut ratios = Vec::new();
    for _ in 0..rounds {
        ratios.push(time(skip.with)? / time(skip.without)?);
    }
    Ok(Worth {
        skip,
        counts: [Counts::of(&with)?, Counts::of(&without)?],
        time: Spread::of(ratios).median,
        difference: difference(&with, &without),
    })
}

fn difference(with: &Rendered, without: &Rendered) -> Option<(f64, u8)> {
    if with.image == without.image {
        return None;
    }
    let rel_mse = with.image.rel_mse(&without.image);
    let bytes = with.image.to_srgb8().into_iter().zip(without.image.to_srgb8());
    Some((rel_mse, bytes.map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)))
}

/// What the skips are worth, as a table for the page.
#[must_use]
pub fn worth_markdown(worths: &[Worth]) -> String {
    let header = [
        "skipped",
        "scene",
        "stage",
        "how often",
        "rays, with / without",
        "tests, with / without",
        "time, with / without",
        "picture",
    ];
    let row = |worth: &Worth| {
        let ratio = |of: fn(&Counts) -> u64| {
            let [with, without] = worth.counts.each_ref().map(of);
            format!("{} / {}", grouped(with), grouped(without))
        };
        let tests = |counts: &Counts| counts.tests("volume") + counts.tests("primitive");
        vec![
            worth.skip.name().to_owned(),
            worth.skip.scene.to_owned(),
            worth.skip.stage.to_owned(),
            worth.times().map_or_else(|| "–".to_owned(), grouped),
            ratio(Counts::all_rays),
            ratio(tests),
            factor(worth.time),
            worth.difference.map_or_else(
                || "identical".to_owned(),
                |(rel_mse, byte)| match byte {
                    0 => format!("relMSE {}, same bytes of a PNG", scientific(rel_mse)),
                    1 => format!("relMSE {}, 1 step of 8 bits at most", scientific(rel_mse)),
                    _ => format!("other samples, relMSE {}", scientific(rel_mse)),
                },
            ),
        ]
    };
    table(&header, &worths.iter().map(row).collect::<Vec<_>>())
}
