//! How the error falls with the number of paths.

use crate::scenes::{ROULETTE, anywhere, matte, scene, sphere, with_paths};
use rendering_equation::Density;
use statistics::{PowerLaw, seed};
use workbench::Sampler;

/// accuracy.md E12: the root of the mean square error falls as N^(−1/2). Concentric spheres, whose
/// radiance is known; N = 4 to 4096, and for each 16 seeds × 12 pixels. The slope of so many is
/// known to 0.007.
#[test]
fn the_error_falls_as_one_over_the_root_of_the_number_of_paths() {
    let materials = matte("inner", 0.5, 1.0) + &matte("outer", 0.8, 0.0);
    let spheres = sphere([2.5, 0.0, 0.0], 1.0, "inner") + &sphere([2.5, 0.0, 0.0], 2.0, "outer");
    let mut scene = scene(0.0, &(materials + &spheres));
    scene.camera.eye.x = 1.0;
    let truth = 2.0 / 3.0;
    let points: Vec<[f64; 2]> = with_paths(&scene, ROULETTE, Density::Cosine, |follow| {
        let mean = |pixel, samples: u32| {
            let path = |i| {
                let sampler = &mut Sampler::new(seed(12), pixel, u64::from(i));
                let mut ray = anywhere(sampler);
                ray.origin.x = 1.0;
                ray.direction.x = -ray.direction.x.abs(); // away from the inner sphere
                f64::from(follow(ray, sampler).x)
            };
            (0..samples).map(path).sum::<f64>() / f64::from(samples)
        };
        (2..=12)
            .map(|power| {
                let samples = 1 << power;
                let squares = (0..16 * 12).map(|i| {
                    let error = mean(1000 * u64::from(samples) + i, samples) - truth;
                    error * error
                });
                [f64::from(samples), (squares.sum::<f64>() / f64::from(16 * 12)).sqrt()]
            })
            .collect()
    });
    let law = PowerLaw::fit(&points).unwrap_or_else(|sentence| panic!("{sentence}"));
    assert!((law.exponent + 0.5).abs() <= 0.02, "{law:?}, for {points:?}");
}
