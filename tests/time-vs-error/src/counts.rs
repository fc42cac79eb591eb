//! What each stage does and skips, by exact counts.
//!
//! Counts do not depend on the machine, the threads, or the day. So "skips what the scene does not
//! need" is a table, and a test holds it (`tests/counts.rs`).

use std::collections::BTreeMap;
use std::fmt::Write;

use statistics::grouped;

use crate::curve::Spread;
use crate::error::{Error, Result};
use crate::markdown::{factor, scientific, table};
use crate::row::spent;
use crate::scene::assets;
use crate::stages::{Rendered, STAGES, Stages};

/// Scenes whose files need nothing that is generated, in the order of the chapters.
pub const SCENES: [&str; 13] = [
    "whitted",
    "teapot",
    "sphereflake",
    "two-mirrors",
    "glass-slab",
    "nested-glass",
    "touching-glass",
    "whitted-teapot",
    "furnace",
    "cornell-box",
    "cornell-spheres",
    "veach-plates",
    "many-lights",
];

/// Stages whose paths have no limit to their number of events but this, so that a count is finite.
const LIMITED: [(&str, &str); 1] = [("rendering-equation", "--depth 3")];

/// A stage on a scene.
#[derive(Clone, Debug)]
pub struct Counted {
    /// The scene.
    pub scene: &'static str,
    /// The stage.
    pub stage: &'static str,
    /// What was counted.
    pub counts: Counts,
}

/// What one render did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Rays by kind.
    pub rays: BTreeMap<String, u64>,
    /// Tests of volumes and of primitives.
    pub tests: BTreeMap<String, u64>,
    /// What was skipped, by reason.
    pub skipped: BTreeMap<String, u64>,
}

impl Counts {
    /// The counts of a render.
    ///
    /// # Errors
    /// If its statistics are not those of a stage.
    pub fn of(rendered: &Rendered) -> Result<Self> {
        let group = |name: &str| -> Result<BTreeMap<String, u64>> {
            let group = rendered.stats[name].as_object();
            let counts = group.into_iter().flatten().map(|(key, value)| {
                let broken = || Error::new(format!("`{name}.{key}` is {value}, not a count"));
                Ok((key.clone(), value.as_u64().ok_or_else(broken)?))
            });
            let counts = counts.collect::<Result<BTreeMap<_, _>>>()?;
            if counts.is_empty() { Err(Error::new(format!("no `{name}`"))) } else { Ok(counts) }
        };
        Ok(Self { rays: group("rays")?, tests: group("tests")?, skipped: group("skipped")? })
    }

    fn ray(&self, kind: &str) -> u64 {
        self.rays.get(kind).copied().unwrap_or(0)
    }

    /// All rays together.
    #[must_use]
    pub fn all_rays(&self) -> u64 {
        self.rays.values().sum()
    }

    /// Tests of volumes (`volume`) or primitives (`primitive`).
    #[must_use]
    pub fn tests(&self, kind: &str) -> u64 {
        self.tests.get(kind).copied().unwrap_or(0)
    }
}

/// Counts every stage on every scene, one sample a pixel.
///
/// # Errors
/// If a stage fails.
pub fn count_all(stages: &Stages, [width, height]: [u32; 2]) -> Result<Vec<Counted>> {
    let pairs = SCENES.iter().flat_map(|&scene| STAGES.iter().map(move |&stage| (scene, stage)));
    let counted = |(scene, stage)| {
        let limit = LIMITED.iter().find(|(limited, _)| *limited == stage);
        let options = limit.map_or("", |(_, options)| *options);
        let arguments = format!("{options} --size {width}x{height} --samples 1");
        let counts = Counts::of(&render(stages, scene, stage, &arguments)?)?;
        Ok(Counted { scene, stage, counts })
    };
    pairs.map(counted).collect()
}

fn render(stages: &Stages, scene: &str, stage: &str, arguments: &str) -> Result<Rendered> {
    let file = assets().join("scenes").join(scene).with_extension("toml");
    stages.render(stage, &file, arguments)
}

/// The counts as plain text, for a snapshot: a line for each stage and scene, without zeros.
#[must_use]
pub fn text(counted: &[Counted]) -> String {
    let mut text = String::new();
    for Counted { scene, stage, counts } in counted {
        // Writing to a String cannot fail.
        let _ = write!(text, "{scene} {stage}:");
        for (name, group) in
            [("rays", &counts.rays), ("tests", &counts.tests), ("skipped", &counts.skipped)]
        {
            for (key, n) in group.iter().filter(|(_, n)| **n > 0) {
                let _ = write!(text, " {name}.{key}={n}");
            }
        }
        text.push('\n');
    }
    text
}

/// The counts as a table for the page.
#[must_use]
pub fn markdown(counted: &[Counted]) -> String {
    let header = [
        "scene",
        "stage",
        "camera",
        "shadow",
        "mirrored",
        "refracted",
        "scattered",
        "volume tests",
        "primitive tests",
        "skipped",
    ];
    let row = |Counted { scene, stage, counts }: &Counted| {
        let kinds = ["camera", "shadow", "reflection", "refraction", "scatter"];
        let mut cells = vec![(*scene).to_owned(), (*stage).to_owned()];
        cells.extend(kinds.map(|kind| grouped(counts.ray(kind))));
        cells.extend(["volume", "primitive"].map(|kind| grouped(counts.tests(kind))));
        cells.push(skipped(counts));
        cells
    };
    table(&header, &counted.iter().map(row).collect::<Vec<_>>())
}

/// What was skipped, in words.
fn skipped(counts: &Counts) -> String {
    let reasons = counts.skipped.iter().filter(|(_, n)| **n > 0);
    let words = reasons.map(|(reason, n)| format!("{} {}", grouped(*n), reason.replace('_', " ")));
    words.collect::<Vec<_>>().join("; ")
}

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
}

/// Every skip that can be switched off, on scenes in which it has something to do.
pub const SKIPS: [Skip; 12] = [
    volumes("teapot", 2),
    volumes("whitted-teapot", 1),
    volumes("many-lights", 4),
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
    Skip { name, scene, stage: "bv-tree", with: ("", 64), without: ("--volume none", samples) }
}

const fn branches(scene: &'static str, stage: &'static str) -> Skip {
    let name = "branches below the cutoff";
    Skip { name, scene, stage, with: ("", 128), without: ("--cutoff 0", 128) }
}

const fn paths(scene: &'static str, stage: &'static str) -> Skip {
    let with = ("--depth 16", 64);
    Skip {
        name: "paths, by roulette",
        scene,
        stage,
        with,
        without: ("--depth 16 --roulette off", 64),
    }
}

const fn code(scene: &'static str, stage: &'static str, samples: u32) -> Skip {
    let name = "code for what is not there";
    Skip { name, scene, stage, with: ("", samples), without: ("--for-any-scene", samples) }
}

/// A skip with what it is worth.
#[derive(Clone, Debug)]
pub struct Worth {
    /// The skip.
    pub skip: Skip,
    /// Counts with the skip, and without.
    pub counts: [Counts; 2],
    /// Median of the ratios of the time of a sample, with / without.
    pub time: f64,
    /// How far apart the pictures are: relMSE of the one with the skip against the other, and the
    /// largest difference of a byte. `None` if they are the same floats.
    pub difference: Option<(f64, u8)>,
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
        Ok(spent(rendered.seconds(), rendered.cpu)[2] / f64::from(samples))
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
