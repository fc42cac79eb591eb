//! What each stage does and skips, by exact counts.
//!
//! Counts do not depend on the machine, the threads, or the day. So "skips what the scene does not
//! need" is a table, and a test holds it (`tests/counts.rs`).

use std::collections::BTreeMap;
use std::fmt::Write;

use statistics::grouped;

use crate::error::{Error, Result};
use crate::markdown::table;
use crate::scene::stored;
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

/// Renders a scene of the assets.
pub(crate) fn render(
    stages: &Stages,
    scene: &str,
    stage: &str,
    arguments: &str,
) -> Result<Rendered> {
    let file = stored(scene);
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
