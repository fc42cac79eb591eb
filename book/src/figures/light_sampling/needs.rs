//! Where the samples go under `--error`.

use std::sync::OnceLock;

use bv_tree::{Aabb, Builder, BvTree};
use light_sampling::{Estimator, LightTracer};
use rendering_equation::MatteOnly;
use workbench::{Estimate, FilmSettings, Unwatched, expose_until};

use super::stage::{scene, settings};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;

const SIZE: [u32; 2] = [128, 128];

/// Of a hundred pixels, one holds more samples than white shows.
const WHITE: f64 = 0.99;

/// The picture of `--error 5%`.
fn estimate() -> &'static Estimate {
    static ESTIMATE: OnceLock<Estimate> = OnceLock::new();
    ESTIMATE.get_or_init(|| {
        let scene = scene("cornell-box");
        let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
        let tracer: LightTracer<'_, _, _, MatteOnly> =
            LightTracer::new(&scene, &[], &geometry, &Unwatched, settings(Estimator::Mis));
        let film = FilmSettings { size: SIZE, samples: u32::MAX, seed: 0, threads: None };
        expose_until(&film, 0.05, |point, sampler| {
            tracer.incident_radiance(scene.camera.ray(point), sampler)
        })
    })
}

/// How many samples white stands for.
fn white(counts: &[u32]) -> u32 {
    let mut sorted = counts.to_vec();
    sorted.sort_unstable();
    sorted[(WHITE * (sorted.len() - 1) as f64) as usize]
}

/// The picture, and the samples of each pixel as greys.
pub(super) fn pictures() -> Drawing {
    let Estimate { image, counts, samples: fewest, .. } = estimate();
    let range = f64::from(white(counts) - fewest);
    let grey = |&count: &u32| {
        let grey = (255.0 * (f64::from(count - fewest) / range).min(1.0)).round() as u8;
        [grey, grey, grey, 255]
    };
    let map = Picture::new(SIZE[0], SIZE[1], counts.iter().flat_map(grey).collect());
    Picture::side_by_side(&[Picture::from(image).enlarged(2), map.enlarged(2)], 8).into()
}

/// The numbers of samples, and how many more an even picture would take for the same relMSE.
///
/// ```text
/// Σ vᵢ/nᵢ = Σ vᵢ / n,   n = Σ vᵢ / Σ (vᵢ/nᵢ)
/// ```
pub(super) fn numbers() -> Drawing {
    let Estimate { image, variance_of_mean, counts, samples: fewest, .. } = estimate();
    let [mut of_sample, mut of_mean] = [0.0; 2];
    for ((mean, variance), &count) in image.pixels.iter().zip(&variance_of_mean.pixels).zip(counts)
    {
        for (&mean, &variance) in mean.iter().zip(variance) {
            let relative = f64::from(variance) / (f64::from(mean).powi(2) + 0.01);
            of_mean += relative;
            of_sample += relative * f64::from(count);
        }
    }
    let average = counts.iter().map(|&count| f64::from(count)).sum::<f64>() / counts.len() as f64;
    let even = of_sample / of_mean;
    let mut numbers = Numbers::new();
    numbers.add("fewest", fewest);
    numbers.add("white", white(counts));
    numbers.add("most", counts.iter().max().unwrap_or(fewest));
    numbers.add("average", format!("{average:.0}"));
    numbers.add("saved", format!("{:.0}", 100.0 * (even / average - 1.0)));
    numbers.into()
}
