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
    /// What is skipped.
    pub name: &'static str,
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
pub const SKIPS: [Skip; 31] = [
    volumes("teapot", 2),
    volumes("whitted-teapot", 1),
    volumes("many-lights", 4),
    facing_away("many-lights", "bv-tree", 16),
    facing_away("cornell-box", "light-sampling", 64),
    nothing_to_reflect("veach-plates", "bv-tree", 64),
    nothing_to_reflect("many-lights", "bv-tree", 16),
    delta("sphereflake", "light-sampling", 64),
    any_hit("sphereflake", "mirror-refraction", 4),
    any_hit("sphereflake", "bv-tree", 64),
    any_hit("cornell-box", "light-sampling", 64),
    paths_at_black("veach-plates", "path-tracing", 64),
    splits("touching-glass", "mirror-refraction", 64),
    surface_points("nested-glass", "mirror-refraction", 64),
    surface_points("cornell-box", "light-sampling", 64),
    own("teapot", "path-tracing", 64),
    own("cornell-box", "light-sampling", 64),
    coordinates("sphereflake", "bv-tree", 64),
    coordinates("cornell-box", "light-sampling", 64),
    pictures("whitted", "ray-casting"),
    trees("nested-glass", "bv-tree", 64),
    trees("whitted", "light-sampling", 64),
    branches("whitted", "mirror-refraction"),
    branches("nested-glass", "mirror-refraction"),
    branches("whitted-teapot", "bv-tree"),
    paths("cornell-box", "path-tracing"),
    paths("cornell-box", "light-sampling"),
    paths("many-lights", "light-sampling"),
    code("cornell-box", "rendering-equation", 16),
    code("cornell-box", "path-tracing", 64),
    code("cornell-box", "light-sampling", 64),
];

const fn volumes(scene: &'static str, samples: u32) -> Skip {
    let name = "what volumes enclose";
    let skip = unneeded(name, scene, "bv-tree", ("", 64), "--volume none");
    Skip { without: ("--volume none", samples), ..skip }
}

/// Work without which the picture is the same.
const fn unneeded(
    name: &'static str,
    scene: &'static str,
    stage: &'static str,
    with: (&'static str, u32),
    without: &'static str,
) -> Skip {
    Skip { name, scene, stage, with, without: (without, with.1), part: Part::Sample }
}

const fn facing_away(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "shadow rays from which no light could come";
    unneeded(name, scene, stage, ("", samples), "--no-skip shadow_rays_facing_away")
}

const fn nothing_to_reflect(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "shadow rays with nothing to reflect";
    unneeded(name, scene, stage, ("", samples), "--no-skip shadow_rays_nothing_to_reflect")
}

const fn delta(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "shadow rays at mirrors and glass";
    unneeded(name, scene, stage, ("", samples), "--no-skip shadow_rays_delta")
}

const fn any_hit(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "the search after the first hit of a shadow ray";
    unneeded(name, scene, stage, ("", samples), "--no-skip any_hit_exits")
}

const fn paths_at_black(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "paths from black surfaces";
    unneeded(name, scene, stage, ("", samples), "--no-skip paths_ended_by_black")
}

const fn splits(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "splits between equal indices";
    unneeded(name, scene, stage, ("", samples), "--no-skip fresnel_splits")
}

const fn surface_points(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "points and normals of other hits";
    unneeded(name, scene, stage, ("", samples), "--no-skip surface_points")
}

const fn own(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "the triangle that a ray starts on";
    unneeded(name, scene, stage, ("", samples), "--no-skip own_triangles")
}

const fn coordinates(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "texture coordinates without a picture";
    unneeded(name, scene, stage, ("", samples), "--no-skip texture_coordinates")
}

const fn trees(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "trees over few primitives";
    unneeded(name, scene, stage, ("", samples), "--no-skip trees_not_built")
}

const fn pictures(scene: &'static str, stage: &'static str) -> Skip {
    let name = "pictures that are not needed";
    let skip = unneeded(name, scene, stage, ("", 1), "--no-skip textures_not_loaded");
    Skip { part: Part::Loading, ..skip }
}

const fn branches(scene: &'static str, stage: &'static str) -> Skip {
    let name = "branches below the cutoff";
    unneeded(name, scene, stage, ("", 128), "--cutoff 0")
}

const fn paths(scene: &'static str, stage: &'static str) -> Skip {
    let name = "paths, by roulette";
    unneeded(name, scene, stage, ("--depth 16", 64), "--depth 16 --roulette off")
}

const fn code(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "code for what is not there";
    unneeded(name, scene, stage, ("", samples), "--for-any-scene")
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
            worth.skip.name.to_owned(),
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
