//! Rays, counted: by kind, by depth, by cutoff.

use mirror_refraction::Limits;
use ray_casting::Scene;
use workbench::{Counter, FilmSettings, Image, Recorder};

use super::stage::{PANEL, draw, limits, scene};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::table::{Table, count};

/// A picture of 120 pixels a row, with its counts.
fn counted(scene: &Scene, limits: Limits) -> (Image, Recorder) {
    let [width, height] = scene.exposure.size;
    let settings = FilmSettings { size: [120, 120 * height / width], ..PANEL };
    let recorder = Recorder::new();
    let image = draw(scene, limits, &settings, &recorder);
    (image, recorder)
}

fn followed(recorder: &Recorder) -> u64 {
    recorder.get(Counter::ReflectionRays) + recorder.get(Counter::RefractionRays)
}

/// Rays by kind.
pub(super) fn rays() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "camera",
        "reflected",
        "refracted",
        "shadow",
        "branches cut",
        "per camera ray",
    ]);
    for name in ["whitted", "nested-glass", "touching-glass", "glass-slab", "two-mirrors"] {
        let (image, recorder) = counted(&scene(name), limits());
        let camera = u64::from(PANEL.samples) * image.pixels.len() as u64;
        table.row([
            format!("`{name}`"),
            count(camera),
            count(recorder.get(Counter::ReflectionRays)),
            count(recorder.get(Counter::RefractionRays)),
            count(recorder.get(Counter::ShadowRays)),
            count(recorder.get(Counter::BranchesBelowThreshold)),
            format!("{:.2}", followed(&recorder) as f64 / camera as f64),
        ]);
    }
    table.into()
}

/// How far apart two pictures are.
struct Difference {
    /// The largest difference of two channels, in linear light.
    worst: f32,
    /// The mean of the differences.
    mean: f64,
    /// Pixels that differ in an 8-bit file, in percent.
    percent: f64,
    /// The largest difference of two bytes.
    codes: u8,
}

impl Difference {
    fn new(a: &Image, b: &Image) -> Self {
        let pairs = a.pixels.iter().flatten().zip(b.pixels.iter().flatten());
        let differences: Vec<f32> = pairs.map(|(a, b)| (a - b).abs()).collect();
        let sum: f64 = differences.iter().copied().map(f64::from).sum();
        let (a, b) = (a.to_srgb8(), b.to_srgb8());
        let (a, b) = (a.chunks_exact(3), b.chunks_exact(3));
        let pixels = a.len() as f64;
        let differing = a.clone().zip(b.clone()).filter(|(a, b)| a != b).count() as f64;
        let codes = a.flatten().zip(b.flatten()).map(|(a, b)| a.abs_diff(*b)).max();
        Self {
            worst: differences.iter().copied().fold(0.0, f32::max),
            mean: sum / differences.len() as f64,
            percent: 100.0 * differing / pixels,
            codes: codes.unwrap_or(0),
        }
    }
}

/// How deep the recursion must go, without a cutoff: compared with depth 24.
pub(super) fn depths() -> Drawing {
    let header = ["depth", "rays", "8-bit pixels that differ", "by at most"];
    let mut table = Table::new(&header);
    let scene = scene("whitted");
    let (deep, _) = counted(&scene, Limits::new(Some(24), 0.0));
    for depth in [0, 1, 2, 3, 4, 5, 6, 8, 12, 16] {
        let (image, recorder) = counted(&scene, Limits::new(Some(depth), 0.0));
        let difference = Difference::new(&image, &deep);
        table.row([
            depth.to_string(),
            count(followed(&recorder)),
            format!("{:.1} %", difference.percent),
            difference.codes.to_string(),
        ]);
    }
    table.into()
}

/// The depth of the table of cutoffs: a little deeper than the stage's own.
const DEEP: u32 = 10;

/// What a cutoff saves, and what it costs.
pub(super) fn cutoffs() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "cutoff",
        "rays followed",
        "branches cut",
        "worst error",
        "mean error",
        "8-bit steps",
    ]);
    for name in ["whitted", "nested-glass", "touching-glass"] {
        let scene = scene(name);
        let (exact, _) = counted(&scene, Limits::new(Some(DEEP), 0.0));
        let cutoffs = [
            ("0", 0.0),
            ("0.00001", 0.000_01),
            ("0.00015 (default)", Limits::CUTOFF),
            ("0.001", 0.001),
            ("0.01", 0.01),
            ("0.1", 0.1),
        ];
        for (text, cutoff) in cutoffs {
            let (image, recorder) = counted(&scene, Limits::new(Some(DEEP), cutoff));
            let difference = Difference::new(&image, &exact);
            let error = |value: f64| match value {
                0.0 => "0".to_owned(),
                value => format!("{value:.6}"),
            };
            table.row([
                format!("`{name}`"),
                text.to_owned(),
                count(followed(&recorder)),
                count(recorder.get(Counter::BranchesBelowThreshold)),
                error(difference.worst.into()),
                error(difference.mean),
                difference.codes.to_string(),
            ]);
        }
    }
    table.into()
}

/// For sentences.
pub(super) fn numbers() -> Drawing {
    let saved = |name: &str| {
        let scene = scene(name);
        let (_, all) = counted(&scene, Limits::new(Some(DEEP), 0.0));
        let (_, cut) = counted(&scene, Limits::new(Some(DEEP), Limits::CUTOFF));
        format!("{:.1}", followed(&all) as f64 / followed(&cut) as f64)
    };
    let mut numbers = Numbers::new();
    numbers.add("cutoff", format!("{:.6}", Limits::CUTOFF));
    numbers.add("whitted-factor", saved("whitted"));
    numbers.add("nested-factor", saved("nested-glass"));
    numbers.into()
}
