//! What a scene does not need, it does not pay for.

use acceptance::{ESTIMATING, Folder};
use serde_json::Value;
use workbench::Image;

use crate::scenes::{BALL, scene};

/// The counts of rays and of what was skipped with the hash of the picture; and the tests of
/// primitives.
fn work(folder: &Folder, stage: &str, scene: &str) -> ((Value, Value, u64), u64) {
    let line = format!("{scene} --samples 16 --quiet --stats - -o a.exr");
    let output = folder.run(stage, &line, 0);
    let all: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let picture = Image::load_exr(&folder.path("a.exr")).expect("the picture is read");
    let tests = all["tests"]["primitive"].as_u64().expect("a count");
    ((all["rays"].clone(), all["skipped"].clone(), picture.hash()), tests)
}

/// The code for any scene finds the same as the code for matte surfaces alone, with the same rays.
/// What it costs is a few instructions a hit, and where it is left out not even these. A material
/// that nothing is made of changes nothing.
#[test]
fn code_for_any_scene_finds_the_same_with_the_same_rays() {
    let matte = format!("{BALL}[materials.lamp]\nke = [3, 4, 5]\n")
        + "[[sphere]]\ncenter = [1.5, 0.5, 0]\nradius = 0.5\nmaterial = 'lamp'\n";
    let matte = scene(&matte).replace("[materials.glass]\nsurface = 'glass'\n", "");
    assert!(!matte.contains("glass"), "no glass in {matte}");
    let unused = format!("{matte}[materials.unused]\nsurface = 'glass'\n");
    let folder = Folder::with(&[("matte.toml", &matte), ("unused.toml", &unused)]);
    for stage in ESTIMATING {
        let [(matte, few), (unused, more), (any, same)] =
            ["matte.toml", "unused.toml", "matte.toml --for-any-scene"]
                .map(|arguments| work(&folder, stage, arguments));
        assert_eq!(matte, unused, "{stage}: without and with glass that nothing is made of");
        assert_eq!(matte, any, "{stage}: code for matte surfaces and for any scene");
        assert_eq!(few, same, "{stage}: tests of primitives by both");
        // A few rays find out, once a render, whether the eye is in that glass.
        assert!((few..few + 20).contains(&more), "{stage}: {few} tests, {more} with unused glass");
        let [scatter, refraction] = ["scatter", "refraction"].map(|key| &matte.0[key]);
        assert!(scatter.as_u64() > Some(1000), "{stage}: {scatter} scattered rays");
        assert_eq!(refraction, 0, "{stage}: refracted rays");
    }
}

/// Light that is the same from everywhere, and directions in proportion to the cosine: every sample
/// is the same number, to the last bit. So the first look at the error, after 16 samples, is the
/// last.
#[test]
fn a_furnace_has_no_variance_and_stops_at_once() {
    let furnace = "background = [1, 1, 1]\n\
        [camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\nfov = 10\nsize = [32, 24]\n\
        [materials.half]\nkd = [0.5, 0.5, 0.5]\n\
        [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = 'half'\n";
    let folder = Folder::with(&[("furnace.toml", furnace)]);
    let run = |stage: &str, options: &str| {
        let line = format!("furnace.toml {options} --quiet --stats - -o a.exr");
        let output = folder.run(stage, &line, 0);
        let all: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        let picture = Image::load_exr(&folder.path("a.exr")).expect("the picture is read");
        (all["samples"].clone(), all["estimated_error"].as_f64().expect("an error"), picture)
    };
    for (stage, options) in [
        ("rendering-equation", "--density cosine"),
        ("path-tracing", "--density cosine"),
        ("light-sampling", "--estimator scatter"),
    ] {
        let (samples, error, picture) = run(stage, &format!("{options} --error 0.001%"));
        assert_eq!((samples, error), (16.into(), 0.0), "{stage} {options}: samples and error");
        assert!(picture.pixels.iter().all(|pixel| *pixel == [0.5; 3]), "{stage} {options}");
    }
    // Light that is sought in the sky is divided by a density, and rounded.
    for estimator in ["light", "mis"] {
        let (samples, error, _) =
            run("light-sampling", &format!("--estimator {estimator} --error 0.001%"));
        assert_eq!(samples, 16, "{estimator}: samples");
        assert!(error < f64::from(f32::EPSILON), "{estimator}: the error is {error}");
    }
    // With directions of equal density the samples differ, and more of them are taken.
    let (samples, error, _) = run("path-tracing", "--density uniform --error 5%");
    assert!(samples.as_u64() > Some(16) && error > 0.01, "uniform: {samples} samples, {error}");
}
