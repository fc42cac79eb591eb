//! What the reflection model computes, beside what a hand computes.

use std::f64::consts::PI;

use blinn_phong::reflection::{Arriving, diffuse, specular};
use glam::{Vec3, vec3};
use ray_casting::{PointLight, Rgb, math};

use crate::axis::Axis;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::plot::{Plot, Series, Style};
use crate::table::Table;

/// A surface in the plane z = 0 under one light, seen from one direction.
struct Setting {
    what: &'static str,
    light: Vec3,
    intensity: f32,
    point: Vec3,
    wo: Vec3,
    kd: f32,
    ks: f32,
    p: f32,
    /// The calculation, and what it gives.
    diffuse: (&'static str, f64),
    specular: (&'static str, f64),
}

/// Looking and lighting straight down.
const HEAD_ON: Setting = Setting {
    what: "light and eye straight above, $I = 4$, $r = 2$, $k_d = k_s = \\frac12$",
    light: vec3(0.0, 0.0, 2.0),
    intensity: 4.0,
    point: Vec3::ZERO,
    wo: Vec3::Z,
    kd: 0.5,
    ks: 0.5,
    p: 50.0,
    diffuse: ("$\\frac12 \\cdot \\frac44 \\cdot 1$", 0.5),
    specular: ("$\\frac12 \\cdot \\frac44 \\cdot 1^{50}$", 0.5),
};

fn settings() -> [Setting; 6] {
    // cos 60° = ½, and the half vector of the light and an eye straight above is at 30°.
    let slanted = vec3(0.75_f32.sqrt(), 0.0, 0.5);
    let (quarter, sixteenth) = ("$\\frac12 \\cdot 1 \\cdot \\frac12$", "$\\frac12 (\\cos 30°)^4$");
    [
        HEAD_ON,
        Setting {
            what: "the same from twice as far, $r = 4$",
            light: vec3(0.0, 0.0, 4.0),
            diffuse: ("$\\frac12 \\cdot \\frac4{16} \\cdot 1$", 0.125),
            specular: ("$\\frac12 \\cdot \\frac4{16} \\cdot 1^{50}$", 0.125),
            ..HEAD_ON
        },
        Setting {
            what: "light at 60°, $I = 1$, $r = 1$, $p = 4$",
            light: slanted,
            intensity: 1.0,
            p: 4.0,
            diffuse: (quarter, 0.25),
            specular: (sixteenth, 0.28125),
            ..HEAD_ON
        },
        Setting {
            what: "a point 2 beside the foot of a light at height 1, $I = 1$",
            light: Vec3::Z,
            intensity: 1.0,
            point: vec3(2.0, 0.0, 0.0),
            ks: 0.0,
            diffuse: (
                "$\\frac12 \\cdot \\frac15 \\cdot \\frac1{\\sqrt5}$",
                0.5 / libm::pow(5.0, 1.5),
            ),
            specular: ("$k_s = 0$", 0.0),
            ..HEAD_ON
        },
        Setting {
            what: "light below the surface, yet $\\mathbf n \\cdot \\mathbf h > 0$",
            light: vec3(0.8, 0.0, -0.6),
            intensity: 1.0,
            p: 1.0,
            diffuse: ("$\\max(0, -0.6)$", 0.0),
            specular: ("gated", 0.0),
            ..HEAD_ON
        },
        Setting {
            what: "the light in the point itself, $r = 0$",
            light: Vec3::ZERO,
            diffuse: ("no direction: 0", 0.0),
            specular: ("0", 0.0),
            ..HEAD_ON
        },
    ]
}

/// Equations 1 and 2 at a few points, by hand and by the stage.
pub(super) fn by_hand() -> Drawing {
    let mut table = Table::new(&["", "$I_d$ by hand", "computed", "$I_s$ by hand", "computed"]);
    for setting in settings() {
        let light = PointLight::new(setting.light, Rgb::splat(setting.intensity));
        let arriving = Arriving::new(&light, setting.point);
        let diffuse = diffuse(Rgb::splat(setting.kd), &arriving, Vec3::Z).x;
        let ks = Rgb::splat(setting.ks);
        let specular = specular(ks, setting.p, &arriving, Vec3::Z, setting.wo).x;
        let by_hand = |(calculation, value): (&str, f64)| {
            if value == 0.0 {
                calculation.to_owned()
            } else {
                format!("{calculation} = {}", short(value))
            }
        };
        table.row([
            setting.what.to_owned(),
            by_hand(setting.diffuse),
            short(f64::from(diffuse)),
            by_hand(setting.specular),
            short(f64::from(specular)),
        ]);
    }
    table.into()
}

/// (1 − 2⁻²⁴) to the power 2²⁴, which is e⁻¹ to seven digits: by squaring in single precision, and
/// by the stage's way.
pub(super) fn power() -> Drawing {
    let (x, squarings) = (1.0_f32.next_down(), 24);
    let single = (0..squarings).fold(x, |square, _| square * square);
    let mut numbers = Numbers::new();
    numbers.add("stage", short(f64::from(math::power(x, 16_777_216.0))));
    numbers.add("single", short(f64::from(single)));
    numbers.add("exact", short(libm::exp(-1.0)));
    numbers.into()
}

/// Seven digits after the point, without the zeros at the end.
fn short(value: f64) -> String {
    let digits = format!("{value:.7}");
    digits.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The lobe over the angle between **n** and **h**.
pub(super) fn lobes() -> Drawing {
    let lobe = |p: f32| {
        let points = (0..=90).map(|degrees| {
            // Light from the eye's own direction: **h** is that direction as well.
            let alpha = f64::from(degrees).to_radians();
            let h = Vec3::new(libm::sin(alpha) as f32, 0.0, libm::cos(alpha) as f32);
            let along_h = Arriving { direction: h, strength: Rgb::ONE };
            [f64::from(degrees), f64::from(specular(Rgb::ONE, p, &along_h, Vec3::Z, h).x)]
        });
        Series { name: format!("p = {p}"), points: points.collect(), style: Style::Line }
    };
    Plot {
        description: "The highlight as a function of the angle between the normal and the half \
                      vector, for p = 1, 4, 16, 64 and 256: the larger p, the narrower."
            .to_owned(),
        x: Axis::linear("angle between n and h / degrees").within(0.0, 90.0),
        y: Axis::linear("(n·h)ᵖ").within(0.0, 1.0),
        series: [1.0, 4.0, 16.0, 64.0, 256.0].map(lobe).into(),
    }
    .into()
}

/// What a highlight sends back of even light from all sides, to an eye straight above: the sum over
/// the hemisphere by midpoints, and the closed form.
///
/// ```text
/// ∫ (n·h)ᵖ (n·l) dω = 8π (2^(−p/2) + p) / ((p + 2)(p + 4)),   v = n
/// ```
pub(super) fn lobe_sums() -> Drawing {
    const STEPS: u32 = 20_000;
    let mut table = Table::new(&["$p$", "summed", "closed form"]);
    for p in [0.0_f32, 1.0, 10.0, 100.0, 1000.0] {
        // v = n: the lobe is the same all around, and dω = 2π d(cos θ).
        let rings = (0..STEPS).map(|i| {
            let cos = (f64::from(i) + 0.5) / f64::from(STEPS);
            let sin = (1.0 - cos * cos).sqrt();
            let direction = Vec3::new(sin as f32, 0.0, cos as f32);
            let arriving = Arriving { direction, strength: Rgb::ONE };
            f64::from(specular(Rgb::ONE, p, &arriving, Vec3::Z, Vec3::Z).x) * cos
        });
        let sum = 2.0 * PI * rings.sum::<f64>() / f64::from(STEPS);
        let p = f64::from(p);
        let exact = 8.0 * PI * (libm::exp2(-p / 2.0) + p) / ((p + 2.0) * (p + 4.0));
        table.row([format!("{p}"), format!("{sum:.5}"), format!("{exact:.5}")]);
    }
    table.into()
}
