//! How much of the light a highlight reflects.

use std::f64::consts::PI;

use glam::Vec3;
use ray_casting::Rgb;
use rendering_equation::{Brdf, Density, Lambert, Lobe};
use workbench::{Image, expose};

use super::scenes::empty;
use super::stage::settings;
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::plot::{Plot, Series, Style};

/// A highlight that reflects all that it can, seen from this many degrees off the normal.
fn highlight(exponent: f32, degrees: f64) -> Brdf {
    let theta = degrees.to_radians();
    let wo = Vec3::new(libm::sin(theta) as f32, 0.0, libm::cos(theta) as f32);
    Brdf {
        normal: Vec3::Z,
        facing: Vec3::Z,
        wo,
        lambert: Lambert { albedo: Rgb::ZERO },
        lobe: Some(Lobe::new(Rgb::ONE, exponent)),
    }
}

/// ∫ f cos θ dω: the mean weight of the stage's own samples, over a grid of random numbers.
fn albedo(exponent: f32, degrees: f64) -> f64 {
    const N: u16 = 200;
    let brdf = highlight(exponent, degrees);
    let lobe = Lobe::new(Rgb::ONE, exponent);
    let at = |i: u16| (f32::from(i) + 0.5) / f32::from(N);
    let grid = (0..N).flat_map(|i| (0..N).map(move |j| [at(i), at(j)]));
    let weights = grid.map(|u| {
        let wi = lobe.sample(brdf.normal, brdf.wo, u);
        let pdf = brdf.pdf(Density::Cosine, wi);
        if pdf > 0.0 { f64::from(brdf.eval(wi).x * brdf.cos_theta(wi) / pdf) } else { 0.0 }
    });
    weights.sum::<f64>() / f64::from(N).powi(2)
}

/// (p + 8)/8π over C(p).
fn common(p: f64) -> f64 {
    let exact = (p + 2.0) * (p + 4.0) / (8.0 * PI * (libm::exp2(-0.5 * p) + p));
    (p + 8.0) / (8.0 * PI) / exact
}

/// The albedo against the angle of the viewer.
pub(super) fn curves() -> Drawing {
    let angles = || (0..=43).map(|i| 2.0 * f64::from(i)).chain([87.0, 88.0, 88.5, 89.0, 89.5]);
    let curve = |name: String, exponent: f32, factor: f64| {
        let points = angles().map(|degrees| [degrees, factor * albedo(exponent, degrees)]);
        Series { name, points: points.collect(), style: Style::Line }
    };
    let mut series: Vec<_> =
        [1.0, 9.0, 100.0, 1000.0].map(|p| curve(format!("p = {p}"), p, 1.0)).into();
    series.push(curve("p = 9, (p + 8)/8π".to_owned(), 9.0, common(9.0)));
    Plot {
        description: "The albedo of the highlight against the angle of the viewer. With the exact \
                      factor every curve starts at 1 and falls; with the common factor it starts \
                      above 1."
            .to_owned(),
        x: Axis::linear("angle of the viewer to the normal / degrees").within(0.0, 90.0),
        y: Axis::linear("albedo for k_s = 1").within(0.0, 1.1),
        series,
    }
    .into()
}

/// The most that the common factor makes of the light, head on.
pub(super) fn numbers() -> Drawing {
    let steps = (0..=2000).map(|i| f64::from(i) / 50.0);
    let worst = steps.max_by(|a, b| common(*a).total_cmp(&common(*b))).expect("there are steps");
    let least = (1..=2000).map(|i| common(f64::from(i) / 50.0)).fold(f64::INFINITY, f64::min);
    assert!(least > 1.0, "the common factor is {least} times the exact one");
    let mut numbers = Numbers::new();
    numbers.add("worst-p", format!("{worst:.0}"));
    numbers.add("worst-gain", format!("{:.1}", 100.0 * (common(worst) - 1.0)));
    for (name, p) in [("gain-1", 1.0), ("gain-100", 100.0), ("gain-1000", 1000.0)] {
        numbers.add(name, format!("{:.1}", 100.0 * (common(p) - 1.0)));
    }
    for (name, degrees) in [("at-45", 45.0), ("at-80", 80.0)] {
        numbers.add(name, format!("{:.0}", 100.0 * albedo(100.0, degrees)));
    }
    numbers.into()
}

/// A ball that reflects all it can, with p = 9, in an even sky of radiance 0.6: by the exact factor
/// and by the common one. Where the ball is brighter than the sky, it is marked in red.
pub(super) fn furnace() -> Drawing {
    let panel = |factor: f64| {
        // The ball is seen from far away, so that each pixel has one angle.
        let size = [160, 160];
        let scene = empty(Vec3::new(0.0, 0.0, 60.0), Vec3::ZERO, 2.2, size, 0.6);
        let curve: Vec<f64> = (0..=90).map(|i| albedo(9.0, f64::from(i).min(89.5))).collect();
        let mut image = expose(&settings(size, 4), |point, _| {
            let [x, y] = [point.x, point.y].map(|v| f64::from(v) / 80.0 * 1.15 - 1.15);
            let sin = (x * x + y * y).sqrt();
            if sin >= 1.0 {
                return scene.background;
            }
            let degrees = libm::asin(sin).to_degrees();
            let (i, rest) = (degrees as usize, degrees.fract());
            let albedo = curve[i] + rest * (curve[(i + 1).min(90)] - curve[i]);
            scene.background * (factor * albedo) as f32
        });
        mark_brighter(&mut image, 0.6);
        Picture::from(&image)
    };
    Picture::side_by_side(&[panel(1.0), panel(common(9.0))], 8).into()
}

/// Paints what exceeds the sky by more than the rounding of the sum red.
fn mark_brighter(image: &mut Image, sky: f32) {
    for pixel in &mut image.pixels {
        if pixel[0] > 1.002 * sky {
            *pixel = [pixel[0], 0.25 * sky, 0.2 * sky];
        }
    }
}
