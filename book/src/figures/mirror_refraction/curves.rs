//! Fresnel's equations and Schlick's approximation.

use mirror_refraction::fresnel::{fresnel, schlick};
use ray_casting::math::sin_cos_f64;

use crate::axis::Axis;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::plot::{Plot, Series, Style};

/// The index of the glass of this page.
const IOR: f64 = 1.5;

/// cos θₜ, or `None` under total internal reflection.
fn refracted(cos_theta_i: f64, eta: f64) -> Option<f64> {
    let cos2 = 1.0 - eta * eta * (1.0 - cos_theta_i * cos_theta_i);
    (cos2 > 0.0).then(|| cos2.sqrt())
}

fn exact(cos_theta_i: f64, eta: f64) -> f64 {
    match refracted(cos_theta_i, eta) {
        Some(cos_theta_t) => fresnel(cos_theta_i as f32, cos_theta_t as f32, eta as f32).into(),
        None => 1.0,
    }
}

fn approximate(cos_theta_i: f64, eta: f64) -> f64 {
    match refracted(cos_theta_i, eta) {
        Some(cos_theta_t) => schlick(cos_theta_i as f32, cos_theta_t as f32, eta as f32).into(),
        None => 1.0,
    }
}

/// Schlick's polynomial of the cosine inside: wrong.
fn with_inner_cosine(cos_theta_i: f64, eta: f64) -> f64 {
    match refracted(cos_theta_i, eta) {
        Some(_) => schlick(cos_theta_i as f32, cos_theta_i as f32, eta as f32).into(),
        None => 1.0,
    }
}

/// The share at an angle in degrees.
type Share = fn(f64, f64) -> f64;

fn plot(description: &str, eta: f64, curves: &[(&str, Share)]) -> Drawing {
    // The critical angle is a corner of the curves: a point on either side of it.
    let critical = libm::asin(1.0 / IOR).to_degrees();
    let mut angles: Vec<f64> = (0..=360).map(|i| f64::from(i) / 4.0).collect();
    angles.extend([critical - 1e-3, critical + 1e-3]);
    angles.extend((1..20).map(|i| critical - f64::from(i) / 100.0));
    angles.sort_by(f64::total_cmp);
    let series = curves.iter().map(|(name, share)| {
        let points = angles
            .iter()
            .map(|&degrees| [degrees, share(sin_cos_f64(degrees.to_radians()).1.max(0.0), eta)])
            .collect();
        Series { name: (*name).to_owned(), points, style: Style::Line }
    });
    Plot {
        description: description.to_owned(),
        x: Axis::linear("angle of incidence / degrees").within(0.0, 90.0),
        y: Axis::linear("share that is reflected").within(0.0, 1.0),
        series: series.collect(),
    }
    .into()
}

/// Light that comes from the air.
pub(super) fn outside() -> Drawing {
    plot(
        "Reflectance of glass against the angle of incidence, from the air: 4 percent up to about \
         45 degrees, then rising ever faster to 1 at 90 degrees. Schlick's curve stays close.",
        1.0 / IOR,
        &[("exact", exact), ("Schlick", approximate)],
    )
}

/// Light that comes from within the glass.
pub(super) fn inside() -> Drawing {
    plot(
        "Reflectance of glass against the angle of incidence, from within: 4 percent, rising \
         steeply to 1 at the critical angle of 41.8 degrees and staying there. Schlick's curve with \
         the outer cosine stays close, with the inner cosine it stays at 4 percent and jumps.",
        IOR,
        &[
            ("exact", exact),
            ("Schlick, cos θₜ", approximate),
            ("Schlick, cos θᵢ", with_inner_cosine),
        ],
    )
}

/// The largest error, and the angle of incidence in degrees at which it is made.
fn worst(eta: f64, share: Share) -> (f64, f64) {
    let steps = 200_000;
    // Steps of the outer cosine, so that both sides are looked at equally closely.
    let cosines = (1..=steps).map(|i| f64::from(i) / f64::from(steps)).map(|outer| {
        if eta < 1.0 { outer } else { (1.0 - (1.0 - outer * outer) / (eta * eta)).sqrt() }
    });
    let error = |cos: f64| ((share(cos, eta) - exact(cos, eta)).abs(), cos);
    let largest = cosines.map(error).fold((0.0, 1.0), |a, b| if b.0 > a.0 { b } else { a });
    (largest.0, libm::acos(largest.1).to_degrees())
}

/// For sentences.
pub(super) fn numbers() -> Drawing {
    let at = |degrees: f64| exact(sin_cos_f64(degrees.to_radians()).1, 1.0 / IOR);
    let mean = |eta: f64| {
        let steps = 100_000;
        let cosines = (0..steps).map(|i| (f64::from(i) + 0.5) / f64::from(steps));
        cosines.map(|cos| 2.0 * cos * exact(cos, eta)).sum::<f64>() / f64::from(steps)
    };
    let percent = |share: f64| format!("{:.1}", 100.0 * share);
    let (entering, entering_angle) = worst(1.0 / IOR, approximate);
    let (leaving, leaving_angle) = worst(IOR, approximate);
    let (inner, inner_angle) = worst(IOR, with_inner_cosine);

    let mut numbers = Numbers::new();
    numbers.add("head-on", percent(at(0.0)));
    numbers.add("at-45", percent(at(45.0)));
    numbers.add("at-60", percent(at(60.0)));
    numbers.add("at-85", percent(at(85.0)));
    numbers.add("critical", format!("{:.2}", libm::asin(1.0 / IOR).to_degrees()));
    numbers.add("entering", format!("{entering:.4}"));
    numbers.add("entering-angle", format!("{entering_angle:.1}"));
    numbers.add("leaving", format!("{leaving:.4}"));
    numbers.add("leaving-angle", format!("{leaving_angle:.1}"));
    numbers.add("inner", format!("{inner:.3}"));
    numbers.add("inner-angle", format!("{inner_angle:.1}"));
    numbers.add("mean-outside", percent(mean(1.0 / IOR)));
    numbers.add("mean-inside", percent(mean(IOR)));
    numbers.into()
}
