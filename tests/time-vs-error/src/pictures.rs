//! Pictures of two settings at equal time, and at equal error.

use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use workbench::Image;

use statistics::grouped;

use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::flip::flip;
use crate::folder;
use crate::markdown::{factor, table};
use crate::measures;
use crate::report::Outcome;
use crate::scene::{Answer, Scene};
use crate::stages::Stages;
use crate::truth::Truth;

/// A question with the two settings that are shown.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// The question.
    pub question: &'static str,
    /// The scene.
    pub scene: &'static str,
    /// The first picture, with so many samples a pixel.
    pub first: (&'static str, u32),
    /// The other two, with as many as take the same time, and as have the same error if it falls as
    /// 1/n from there.
    pub second: &'static str,
}

/// The questions that are answered by pictures, too.
pub const PAIRS: [Pair; 8] = [
    Pair { question: "density", scene: "furnace", first: ("cosine", 16), second: "uniform" },
    Pair { question: "density", scene: "cornell-box", first: ("cosine", 64), second: "uniform" },
    Pair { question: "branching", scene: "cornell-box", first: ("N = 8", 2), second: "N = 1" },
    Pair { question: "ending", scene: "cornell-box", first: ("depth 2", 64), second: "roulette" },
    Pair { question: "estimators", scene: "cornell-box", first: ("mis", 16), second: "scatter" },
    Pair { question: "estimators", scene: "mesh", first: ("mis", 16), second: "scatter" },
    Pair { question: "estimators", scene: "veach-plates", first: ("mis", 16), second: "light" },
    Pair { question: "lights", scene: "many-lights", first: ("nearby", 16), second: "uniform" },
];

/// However much worse a setting is, its picture is done after so many samples.
const MOST_SAMPLES: u32 = 4096;
/// Samples of the right picture, where it is the course's own.
const OWN_SAMPLES: u32 = 1024;
/// Transparent pixels between pictures.
const GAP: u32 = 8;

/// A rendered picture with what it took.
struct Taken {
    name: String,
    samples: u32,
    image: Image,
    /// At the size of the curves, from which it is known better than from one render.
    seconds: f64,
    rel_mse: f64,
    flip: f64,
}

impl Pair {
    /// Whether it shows this outcome.
    #[must_use]
    pub fn is_of(&self, outcome: &Outcome<'_>) -> bool {
        let experiment = outcome.experiment;
        self.question == experiment.question && self.scene == experiment.scene.name
    }

    /// The name of the file with the pictures.
    #[must_use]
    pub fn file(&self, outcome: &Outcome<'_>) -> String {
        format!("{}-pictures.png", outcome.name())
    }

    /// Renders the three pictures, and writes them side by side, with a table of what they took.
    ///
    /// # Errors
    /// If a setting was not measured, a stage fails, or a file cannot be written.
    pub fn write(&self, outcome: &Outcome<'_>, stages: &Stages, folder: &Path) -> Result<()> {
        let curve = |name: &str| {
            let found = outcome.curves.iter().find(|curve| curve.setting.name == name);
            found.filter(|curve| !curve.points.is_empty()).ok_or_else(|| {
                Error::new(format!("`{name}` of {} was not measured", self.question))
            })
        };
        let (name, samples) = self.first;
        let (first, second) = (curve(name)?, curve(self.second)?);
        let scene = large(&outcome.experiment.scene);
        let truth = Truth::of(&scene, stages)?
            .ok_or_else(|| Error::new(format!("{} has no right picture", self.question)))?;
        let shot = |curve: &Curve, samples: u32| take(&scene, curve, samples, &truth, stages);
        let shown = shot(first, samples)?;
        let equal_time = shot(second, limited(shown.seconds / second.seconds_a_sample()))?;
        let error = equal_time.rel_mse / shown.rel_mse;
        let equal_error = shot(second, limited(f64::from(equal_time.samples) * error))?;
        let taken = [shown, equal_time, equal_error];
        let png = folder.join(self.file(outcome));
        folder::write(&png.with_extension("md"), described(&taken))?;
        let pictures: Vec<&Image> = taken.iter().map(|taken| &taken.image).collect();
        folder::write(&png, side_by_side(&pictures)?)
    }
}

/// The scene at twice its size, and with a right picture that is good enough for one comparison.
fn large(scene: &Scene) -> Scene {
    let answer = match scene.answer {
        Answer::Own { depth, .. } => Answer::Own { depth, samples: OWN_SAMPLES },
        other => other,
    };
    let mut large = scene.clone();
    large.size = scene.size.map(|n| 2 * n);
    large.answer = answer;
    large
}

fn limited(samples: f64) -> u32 {
    // A NaN becomes 0, and that 1.
    (samples.round() as u32).clamp(1, MOST_SAMPLES)
}

fn take(
    scene: &Scene,
    curve: &Curve,
    samples: u32,
    truth: &Truth,
    stages: &Stages,
) -> Result<Taken> {
    let [width, height] = scene.size;
    let setting = &curve.setting;
    let options = &setting.options;
    // A seed that no measured picture has.
    let arguments = format!("{options} --size {width}x{height} --samples {samples} --seed 77");
    let rendered = stages.render(setting.stage, &scene.file(&stages.folder)?, &arguments)?;
    Ok(Taken {
        name: setting.name.clone(),
        samples,
        seconds: f64::from(samples) * curve.seconds_a_sample(),
        rel_mse: measures::errors(&rendered.image, truth).rel_mse,
        flip: flip(&rendered.image, &truth.image),
        image: rendered.image,
    })
}

fn described(taken: &[Taken]) -> String {
    let first = &taken[0];
    let places = ["left", "middle: equal time", "right: equal error"];
    let row = |(place, taken): (&str, &Taken)| {
        vec![
            place.to_owned(),
            format!("`{}`", taken.name),
            grouped(u64::from(taken.samples)),
            factor(taken.seconds / first.seconds),
            factor(taken.rel_mse / first.rel_mse),
            format!("{:.3}", taken.flip),
        ]
    };
    let rows: Vec<_> = places.into_iter().zip(taken).map(row).collect();
    table(&["picture", "setting", "samples", "time", "relMSE", "FLIP"], &rows)
}

/// The bytes of a PNG file.
fn side_by_side(pictures: &[&Image]) -> Result<Vec<u8>> {
    let (width, height) = (pictures[0].width, pictures[0].height);
    let whole = pictures.len() as u32 * (width + GAP) - GAP;
    let mut rgba = vec![0; (whole * height * 4) as usize];
    for (i, picture) in pictures.iter().enumerate() {
        let left = i as u32 * (width + GAP);
        for (j, rgb) in picture.to_srgb8().chunks_exact(3).enumerate() {
            let (x, y) = (j as u32 % width, j as u32 / width);
            let at = ((y * whole + left + x) * 4) as usize;
            rgba[at..at + 3].copy_from_slice(rgb);
            rgba[at + 3] = 255;
        }
    }
    let mut png = Vec::new();
    PngEncoder::new_with_quality(&mut png, CompressionType::Best, FilterType::Adaptive)
        .write_image(&rgba, whole, height, ExtendedColorType::Rgba8)
        .map_err(|error| Error::new(format!("a PNG file: {error}")))?;
    Ok(png)
}

#[cfg(test)]
mod tests {
    use super::{PAIRS, limited, side_by_side};
    use crate::matrix::{Extent, experiments};
    use workbench::Image;

    #[test]
    fn every_pair_is_measured() {
        for extent in [Extent::Full, Extent::Quick] {
            let all = experiments(extent);
            for pair in PAIRS {
                let found = all.iter().find(|experiment| {
                    experiment.question == pair.question && experiment.scene.name == pair.scene
                });
                let settings = &found.unwrap_or_else(|| panic!("{pair:?}")).settings;
                for name in [pair.first.0, pair.second] {
                    assert!(settings.iter().any(|s| s.name == name), "{name} of {pair:?}");
                }
            }
        }
    }

    #[test]
    fn samples_have_limits() {
        let found = [0.2, 17.4, 1e9, f64::NAN].map(limited);
        assert_eq!(found, [1, 17, 4096, 1], "rounded and limited");
    }

    #[test]
    fn pictures_stand_side_by_side() {
        let [white, black] =
            [1.0, 0.0].map(|v| Image { width: 2, height: 1, pixels: vec![[v; 3]; 2] });
        let png = side_by_side(&[&white, &black]).expect("a PNG file");
        let found = image::load_from_memory(&png).expect("it is read").to_rgba8();
        assert_eq!(found.dimensions(), (12, 1), "two pixels, a gap of eight, two pixels");
        let at = |x| found.get_pixel(x, 0).0;
        assert_eq!([at(1), at(5), at(10)], [[255; 4], [0; 4], [0, 0, 0, 255]], "the pixels");
    }
}
