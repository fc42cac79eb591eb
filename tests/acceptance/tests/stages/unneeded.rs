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

/// A material of glass that nothing is made of makes the stages run the code that knows of glass.
/// It finds the same with the same rays, but for a few that find out, once a render, in what the
/// eye is. What it costs is a few instructions a hit (`rendering_equation::Renderer` has the
/// numbers), and without glass not even these.
#[test]
fn code_for_glass_finds_the_same_with_the_same_rays() {
    let opaque = format!("{BALL}[materials.lamp]\nke = [3, 4, 5]\n")
        + "[[sphere]]\ncenter = [1.5, 0.5, 0]\nradius = 0.5\nmaterial = 'lamp'\n";
    let opaque = scene(&opaque).replace("[materials.glass]\nsurface = 'glass'\n", "");
    assert!(!opaque.contains("glass"), "no glass in {opaque}");
    let with_glass = format!("{opaque}[materials.unused]\nsurface = 'glass'\n");
    let folder = Folder::with(&[("opaque.toml", &opaque), ("glass.toml", &with_glass)]);
    for stage in ESTIMATING {
        let [(without, few), (with, more)] =
            ["opaque.toml", "glass.toml"].map(|name| work(&folder, stage, name));
        assert_eq!(without, with, "{stage}: rays, skipped and picture without and with glass");
        let [scatter, refraction] = ["scatter", "refraction"].map(|key| &without.0[key]);
        assert!(scatter.as_u64() > Some(1000), "{stage}: {scatter} scattered rays");
        assert_eq!(refraction, 0, "{stage}: refracted rays");
        assert!((few..few + 20).contains(&more), "{stage}: {few} tests without glass, {more} with");
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
