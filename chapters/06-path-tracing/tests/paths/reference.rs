//! Against pictures of another program: `assets/reference`.

use std::path::Path;

use crate::scenes::asset;
use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::{Ending, PathTracer, Roulette};
use rendering_equation::{Density, Opaque};
use statistics::{Criterion, Noisy, assert_images, compare_images, seed};
use workbench::{FilmSettings, Image, Unwatched, expose_estimate};

fn load(name: &str) -> Image {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/reference");
    Image::load_exr(&folder.join(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The Cornell box to depth 16. The lamp is found by chance alone, so the picture is noisy: what
/// these paths can see is a bias of a few percent. Chapter 7 sees smaller ones.
#[test]
fn the_cornell_box_agrees_with_its_reference() {
    let scene = asset("cornell-box");
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let ending = Ending { depth: 16, roulette: Roulette::Throughput };
    let tracer: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(&scene, &[], &geometry, &Unwatched, Density::Cosine, ending);
    let settings = FilmSettings { size: [128, 128], samples: 96, seed: seed(16), threads: None };
    let ours =
        expose_estimate(&settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s));

    let [reference, errors] = [load("cornell.exr"), load("cornell.stderr.exr")];
    let square = |error: &[f32; 3]| error.map(|e| e * e);
    let variance: Vec<[f32; 3]> = errors.pixels.iter().map(square).collect();
    let theirs = Noisy { mean: &reference.pixels, variance: &variance, samples: 16 };
    let noisy =
        |mean| Noisy { mean, variance: &ours.variance_of_mean.pixels, samples: ours.samples };
    let agreement = assert_images(
        "cornell",
        [128, 128],
        &noisy(&ours.image.pixels),
        &theirs,
        &Criterion::THREE_SIGMA,
    );
    assert!(agreement.visible_bias < 0.03, "{agreement:?}");

    let biased: Vec<[f32; 3]> = ours.image.pixels.iter().map(|p| p.map(|v| 0.97 * v)).collect();
    let wrong =
        compare_images("3 % darker", [128, 128], &noisy(&biased), &theirs, &Criterion::THREE_SIGMA);
    assert!(wrong.is_err(), "3 % less light are not missed: {wrong:?}");
}
