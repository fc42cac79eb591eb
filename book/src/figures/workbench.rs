//! The figures of chapter 0.

use super::{Drawing, Figure};
use crate::axis::Axis;
use crate::plot::{Plot, Series, Style};

pub(super) const FIGURES: &[Figure] =
    &[Figure { file: "00-workbench/srgb-curve.svg", draw: srgb_curve }];

/// What a byte of a PNG file stands for: the sRGB curve, with the straight line beside it.
fn srgb_curve() -> Drawing {
    let linear = |byte: u8| [f64::from(byte), f64::from(workbench::srgb::decode(byte))];
    let curve = (0..=255).step_by(3).map(linear).collect();
    let line = vec![[0.0, 0.0], [255.0, 1.0]];
    let series = |name: &str, points| Series { name: name.to_owned(), points, style: Style::Line };
    Plot {
        description: "Linear light as a function of the byte: the sRGB curve lies below the \
                      straight line everywhere between black and white."
            .to_owned(),
        x: Axis::linear("byte in the PNG file").within(0.0, 255.0),
        y: Axis::linear("linear light").within(0.0, 1.0),
        series: vec![series("sRGB", curve), series("no curve", line)],
    }
    .into()
}
