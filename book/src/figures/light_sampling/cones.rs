//! The cone of a sphere lamp, computed so that it collapses and so that it does not.

use crate::axis::Axis;
use crate::figures::Drawing;
use crate::plot::{Plot, Series, Style};

/// 1 − cos θ_max from a rounded cosine: what the folklore computes.
fn naive(sin: f32) -> f32 {
    1.0 - (1.0 - sin * sin).sqrt()
}

/// The same without the difference of two numbers near 1.
fn stable(sin: f32) -> f32 {
    sin * sin / (1.0 + ((1.0 - sin) * (1.0 + sin)).sqrt())
}

/// Both, relative to the exact value; 0 means that the lamp has no solid angle at all.
pub(super) fn plot() -> Drawing {
    let exact = |sin: f64| sin * sin / (1.0 + ((1.0 - sin) * (1.0 + sin)).sqrt());
    let curve = |name: &str, of: fn(f32) -> f32| {
        let points = (0..=160).map(|i| {
            let sin = libm::pow(10.0, -5.0 + f64::from(i) / 40.0) as f32;
            [f64::from(sin), f64::from(of(sin)) / exact(f64::from(sin))]
        });
        Series { name: name.to_owned(), points: points.collect(), style: Style::Line }
    };
    Plot {
        description: "Below an angle of a thousandth, the naive solid angle jumps up and down and \
                      falls to zero; the stable one stays exact."
            .to_owned(),
        x: Axis::log("sine of the cone's half angle"),
        y: Axis::linear("computed solid angle / exact one").within(0.0, 2.5),
        series: vec![curve("1 − cos θ", naive), curve("stable", stable)],
    }
    .into()
}
