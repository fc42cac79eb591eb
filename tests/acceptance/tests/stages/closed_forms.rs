//! Scenes whose right answer is known without a computer.

use acceptance::Folder;
use workbench::Image;

/// accuracy.md E2: a point light of radiant intensity π at the centre of a unit sphere of albedo ½.
/// The light alone makes the wall as bright as ½, each further bounce adds half of the one before,
/// and all together are 1. A scene file gives 1/π of the radiant intensity.
///
/// Without roulette nothing is random about it: the light is π/r² everywhere, and the throughput ½ⁿ.
/// What differs from pixel to pixel is rounding.
#[test]
fn a_point_light_at_the_centre_of_a_sphere_makes_it_evenly_bright() {
    let ball = "[camera]\neye = [0, 0.2, -0.5]\ntarget = [0, 0.1, 1]\nfov = 70\nsize = [16, 16]\n\
        [materials.half]\nkd = [0.5, 0.5, 0.5]\n\
        [[point_light]]\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\n\
        [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = 'half'\n";
    let folder = Folder::with(&[("ball.toml", ball)]);
    for (depth, expected) in [(1, 0.5), (2, 0.75), (30, 1.0)] {
        for estimator in ["light", "mis"] {
            let options = format!("--estimator {estimator} --roulette off --depth {depth}");
            let line = format!("ball.toml {options} --samples 4 --quiet -o a.exr");
            folder.run("light-sampling", &line, 0);
            let picture = Image::load_exr(&folder.path("a.exr")).expect("the picture is read");
            for (i, value) in picture.pixels.iter().flatten().enumerate() {
                let off = value - expected;
                assert!(off.abs() < 1e-5, "{options}, pixel {}: {value} for {expected}", i / 3);
            }
        }
    }
}
