//! The error that a picture states of itself, on real scenes, against the true one.
//!
//! The truth is a reference picture of 128 × 128 pixels (`assets/reference`), of which a pixel here
//! is a block of 16 × 16. So the stages follow paths of at most 16 scattering events, as it does.

use std::path::Path;

use acceptance::Folder;
use serde_json::Value;
use statistics::{TEST_ALPHA, binomial_at_least, seed};
use workbench::Image;

const RENDERS: u64 = 100;

/// The reference `name`, made `SIDE` × `SIDE` pixels small.
fn truth(name: &str) -> Image {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/reference");
    let path = folder.join(name).with_extension("exr");
    let large = Image::load_exr(&path).unwrap_or_else(|error| panic!("{error}"));
    let block = large.width / SIDE;
    let mut small = Image::new(SIDE, SIDE);
    for (i, pixel) in (0..).zip(&mut small.pixels) {
        let corner = [i % SIDE * block, i / SIDE * block];
        let mut sum = [0.0_f64; 3];
        for (x, y) in (0..block).flat_map(|y| (0..block).map(move |x| (x, y))) {
            let part = large.pixel(corner[0] + x, corner[1] + y);
            sum = [0, 1, 2].map(|channel| sum[channel] + f64::from(part[channel]));
        }
        *pixel = sum.map(|sum| (sum / f64::from(block * block)) as f32);
    }
    small
}

/// Width and height of the pictures.
const SIDE: u32 = 8;

/// Renders to an error of `percent` with many seeds, and compares how often the true error is above
/// the stated one with the one in twenty that is promised.
///
/// If it were 5 %, there would be 5 ± 2.2 of 100; 17 are a failure, which chance explains once in 10⁵
/// times, and a share of 25 % is found with a probability of 98 %. To show that the statement says
/// something, errors of half the stated size must be found to be too small.
fn check(stage: &str, scene: &str, reference: &str, arguments: &str, percent: f64) {
    let folder = Folder::with(&[]);
    let truth = truth(reference);
    let [mut above, mut above_half] = [0, 0];
    for i in 0..RENDERS {
        let options = format!("--size {SIDE}x{SIDE} --depth 16 --error {percent}% --threads 1");
        let seed = seed(0xE0 + i);
        let line =
            format!("{scene} {options} {arguments} --seed {seed} --quiet --stats - -o a.exr");
        let output = folder.run(stage, &line, 0);
        let all: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        let stated = all["estimated_error"].as_f64().expect("an error is stated");
        assert!(0.0 < stated && stated <= percent / 100.0, "{line}: stopped at {stated}");
        assert_eq!(all["non_finite_samples"], 0, "{line}");
        let picture = Image::load_exr(&folder.path("a.exr")).expect("the picture is read");
        let error = picture.rel_mse(&truth).sqrt();
        assert!(error.is_finite(), "{line}: the true error is {error}");
        above += u64::from(error > stated);
        above_half += u64::from(error > 0.5 * stated);
    }
    let case = format!("{stage} {scene} {arguments}");
    let p = binomial_at_least(above, RENDERS, 0.05);
    assert!(p >= TEST_ALPHA, "{case}: above the stated error in {above} of {RENDERS}, p = {p:e}");
    let p = binomial_at_least(above_half, RENDERS, 0.05);
    assert!(p < TEST_ALPHA, "{case}: above half the stated error in only {above_half}");
}

#[test]
fn chapter_5_states_its_error_truly() {
    check("rendering-equation", "cornell-box", "cornell", "--branching 1", 60.0);
}

#[test]
fn chapter_6_states_its_error_truly() {
    check("path-tracing", "cornell-spheres", "cornell-spheres", "", 60.0);
}

/// Two pixels show a sliver of the lamp, and one sample in 200 has most of their light. Of these
/// renders, 4 are worse than they say; without doubts about the brightness that their pixels have
/// seen, it would be 19.
#[test]
fn chapter_7_states_its_error_truly() {
    check("light-sampling", "cornell-box", "cornell", "", 10.0);
}
