//! How fast the error of Monte Carlo integration falls.

use std::fmt::Display;

use rendering_equation::convergence::{Command, Integrand, Sampling, Study};

use crate::axis::Axis;
use crate::figures::Drawing;
use crate::plot::{Plot, Series, Style};
use crate::table::Table;

/// Errors against N for ∫ cos θ dω and the two narrow functions.
pub(super) fn errors() -> Drawing {
    let curve = |integrand, sampling, name: &str| {
        let study = Study { integrand, samples: 65_536, runs: 41, seed: 0 };
        let exact = integrand.integral();
        let rows = study.course(sampling).rows;
        let points = rows.iter().map(|r| [r.estimate.samples as f64, r.typical_error / exact]);
        let points = points.collect();
        Series { name: name.to_owned(), points, style: Style::LineAndMarks }
    };
    Plot {
        description: "Relative errors fall along parallel straight lines of slope minus one half; \
                      with the peaked density along a flatter one"
            .to_owned(),
        x: Axis::log("N"),
        y: Axis::log("error / integral"),
        series: vec![
            curve(Integrand::Lobe100, Sampling::Uniform, "lobe, uniform"),
            curve(Integrand::Lobe100, Sampling::Cosine, "lobe, cosine"),
            curve(Integrand::Cosine, Sampling::Peaked, "cos, peaked"),
            curve(Integrand::Lobe100, Sampling::Peaked, "lobe, peaked"),
            curve(Integrand::Cosine, Sampling::Uniform, "cos, uniform"),
        ],
    }
    .into()
}

/// The slopes of all functions and densities, and what is left of the error in the end.
pub(super) fn slopes() -> Drawing {
    let mut table = Table::new(&[
        "$f$",
        "slope, uniform",
        "cosine",
        "peaked",
        "error, uniform",
        "cosine",
        "peaked",
    ]);
    let names = Integrand::ALL.map(|integrand| match integrand {
        Integrand::Cosine => "$\\cos\\theta$",
        Integrand::SolidAngle => "1",
        Integrand::Lobe10 => "$(\\mathbf n \\cdot \\mathbf h)^{10} \\cos\\theta$",
        Integrand::Lobe100 => "$(\\mathbf n \\cdot \\mathbf h)^{100} \\cos\\theta$",
        Integrand::SkyPatch => "patch of sky",
    });
    for (integrand, name) in Integrand::ALL.into_iter().zip(names) {
        let study = Study { integrand, samples: 16_384, runs: 101, seed: 0 };
        let courses = Sampling::ALL.map(|sampling| study.course(sampling));
        let slopes = courses.each_ref().map(|course| {
            let expected = study.expected_slope(course.sampling);
            match course.slope {
                None => "none".to_owned(),
                Some(slope) if expected == -0.5 => decimal(slope.exponent),
                // A space at which no line breaks.
                Some(slope) => {
                    format!("{}\u{a0}({})", decimal(slope.exponent), minus(expected))
                }
            }
        });
        let errors = courses.each_ref().map(|course| {
            let last = course.rows.last().expect("N starts at 4").typical_error;
            let mark = if study.has_infinite_variance(course.sampling) { "\u{a0}\\*" } else { "" };
            format!("{:.2}\u{a0}%{mark}", 100.0 * last / integrand.integral())
        });
        table.row([name.to_owned()].into_iter().chain(slopes).chain(errors));
    }
    table.into()
}

/// With two digits.
fn decimal(slope: f64) -> String {
    minus(format!("{slope:.2}"))
}

/// With a sign that is as wide as a digit.
fn minus(number: impl Display) -> String {
    number.to_string().replace('-', "−")
}

/// What the program prints, up to its plot.
pub(super) fn printed() -> Drawing {
    let command = Command {
        integrand: Integrand::Cosine,
        all: false,
        density: Some(Sampling::Uniform),
        samples: 16_384,
        runs: 101,
        seed: 0,
    };
    let text = command.run();
    let table = text.split("\nerror over").next().unwrap_or_default();
    Drawing::Text(format!("```text\n{table}```\n"))
}
