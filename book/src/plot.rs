//! Plots: lines over two axes, as SVG that takes the colours of the page's theme.
//!
//! The file is included into the page (`{{#include figures/….svg}}`), not shown as an `<img>`: only
//! then do `currentColor` and the style sheet's `.series-1` … `.series-6` reach it. Lines also
//! differ by dashes and marks, so that a plot can be read without colours.

use std::fmt::Write;

use crate::axis::{Axis, Span};

/// A plot with named curves.
#[derive(Clone, Debug)]
pub struct Plot {
    /// What the plot shows, for readers who cannot see it.
    pub description: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The curves; at most 6.
    pub series: Vec<Series>,
}

/// A curve of a plot.
#[derive(Clone, Debug)]
pub struct Series {
    /// Written at the end of the curve.
    pub name: String,
    /// (x, y) in the order in which they are joined.
    pub points: Vec<[f64; 2]>,
    /// How the points are drawn.
    pub style: Style,
}

/// How the points of a curve are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    /// Joined, for a function.
    Line,
    /// Marked, for independent measurements.
    Marks,
    /// Joined and marked, for measurements of one thing.
    LineAndMarks,
}

const WIDTH: f64 = 680.0;
const HEIGHT: f64 = 400.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 344.0;
const LEFT: f64 = 74.0;
/// Width of a letter of a series' name, generously.
const LETTER: f64 = 7.6;
/// Least distance between two names.
const LINE: f64 = 17.0;
const DASHES: [&str; 6] = ["none", "9 4", "2 3", "9 3 2 3", "5 3", "14 4"];

impl Plot {
    /// The plot as an SVG element without blank lines, to be included into a page.
    ///
    /// # Panics
    ///
    /// If it has no points or more than 6 series, or if a value is not finite, or not positive on
    /// a logarithmic axis.
    #[must_use]
    pub fn svg(&self) -> String {
        assert!(self.series.len() <= DASHES.len(), "{} series", self.series.len());
        let points = || self.series.iter().flat_map(|series| &series.points);
        assert!(points().flatten().all(|v| v.is_finite()), "a value is not finite");
        let x = self.x.fit(points().map(|p| p[0]));
        let y = self.y.fit(points().map(|p| p[1]));
        let letters = self.series.iter().map(|s| s.name.chars().count()).max().unwrap_or(0);
        let frame = Frame { x, y, right: WIDTH - 14.0 - LETTER * letters as f64 };

        let mut svg = format!(
            "<svg class=\"plot\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" \
             aria-label=\"{}\" font-size=\"14\" fill=\"none\" stroke=\"none\" \
             color=\"currentColor\">\n",
            escape(&self.description)
        );
        frame.draw_axes(&mut svg, &self.x.label, &self.y.label);
        let heights = self.name_heights(&frame);
        for (i, (series, height)) in self.series.iter().zip(heights).enumerate() {
            frame.draw_series(&mut svg, i, series, height);
        }
        svg.push_str("</svg>\n");
        svg
    }

    /// Where each name stands: beside its curve's last point, but not on another name.
    fn name_heights(&self, frame: &Frame) -> Vec<f64> {
        let ends = self.series.iter().map(|s| s.points.last().map_or(BOTTOM, |p| frame.at(*p)[1]));
        let mut order: Vec<(usize, f64)> = ends.enumerate().collect();
        order.sort_by(|a, b| a.1.total_cmp(&b.1));
        for i in 1..order.len() {
            order[i].1 = order[i].1.max(order[i - 1].1 + LINE);
        }
        // What was pushed below the axis is moved up again, with all that it meets there.
        let mut limit = BOTTOM;
        for (_, height) in order.iter_mut().rev() {
            *height = height.min(limit);
            limit = *height - LINE;
        }
        order.sort_by_key(|(i, _)| *i);
        order.into_iter().map(|(_, height)| height).collect()
    }
}

/// The rectangle that the curves are drawn in.
struct Frame {
    x: Span,
    y: Span,
    right: f64,
}

// Writing to a String cannot fail, so the results of `writeln!` are dropped.
impl Frame {
    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [self.x.place(x), self.y.place(y)];
        [LEFT + x * (self.right - LEFT), BOTTOM + y * (TOP - BOTTOM)]
    }

    fn draw_axes(&self, svg: &mut String, x_label: &str, y_label: &str) {
        let right = self.right;
        let mut grid = String::new();
        svg.push_str("<g fill=\"currentColor\">\n");
        for (place, text) in self.x.ticks() {
            let x = LEFT + place * (right - LEFT);
            let _ = write!(grid, "M{x:.1} {TOP}V{BOTTOM}");
            let y = BOTTOM + 20.0;
            let _ =
                writeln!(svg, "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{text}</text>");
        }
        for (place, text) in self.y.ticks() {
            let y = BOTTOM + place * (TOP - BOTTOM);
            let _ = write!(grid, "M{LEFT} {y:.1}H{right:.1}");
            let (x, y) = (LEFT - 8.0, y + 5.0);
            let _ = writeln!(svg, "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"end\">{text}</text>");
        }
        let (x, y) = ((LEFT + right) / 2.0, HEIGHT - 10.0);
        let label = escape(x_label);
        let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{label}</text>");
        let y = (TOP + BOTTOM) / 2.0;
        let label = escape(y_label);
        let _ = writeln!(
            svg,
            "<text transform=\"translate(16 {y}) rotate(-90)\" text-anchor=\"middle\">{label}</text>"
        );
        svg.push_str("</g>\n");
        let _ = writeln!(svg, "<path d=\"{grid}\" stroke=\"currentColor\" opacity=\"0.2\"/>");
        let _ = writeln!(
            svg,
            "<path d=\"M{LEFT} {TOP}V{BOTTOM}H{right:.1}\" stroke=\"currentColor\"/>"
        );
    }

    fn draw_series(&self, svg: &mut String, i: usize, series: &Series, name_height: f64) {
        let _ = writeln!(svg, "<g class=\"series-{}\">", i + 1);
        let points: Vec<_> = series.points.iter().map(|p| self.at(*p)).collect();
        if series.style != Style::Marks {
            let steps = points.iter().zip(["M"].iter().chain(std::iter::repeat(&"L")));
            let path: String = steps.map(|([x, y], step)| format!("{step}{x:.1} {y:.1}")).collect();
            let dashes = DASHES[i];
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" stroke=\"currentColor\" stroke-width=\"2\" \
                 stroke-dasharray=\"{dashes}\" stroke-linejoin=\"round\"/>"
            );
        }
        if series.style != Style::Line {
            let marks: String = points.iter().map(|[x, y]| mark(i, *x, *y)).collect();
            let _ = writeln!(svg, "<path d=\"{marks}\" fill=\"currentColor\"/>");
        }
        let end = points.last().map_or(LEFT, |p| p[0]);
        let (x, y) = (end + 8.0, name_height + 5.0);
        let name = escape(&series.name);
        let _ =
            writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"currentColor\">{name}</text>");
        svg.push_str("</g>\n");
    }
}

/// A circle, square, triangle or diamond, about 8 pixels wide.
fn mark(i: usize, x: f64, y: f64) -> String {
    match i % 4 {
        0 => format!("M{:.1} {y:.1}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", x - 4.0),
        1 => format!("M{:.1} {:.1}h7v7h-7z", x - 3.5, y - 3.5),
        2 => format!("M{x:.1} {:.1}l4.5 8h-9z", y - 5.0),
        _ => format!("M{x:.1} {:.1}l5 5l-5 5l-5 -5z", y - 5.0),
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{Plot, Series, Style};
    use crate::axis::Axis;

    fn plot(x: Axis, y: Axis, series: &[&[[f64; 2]]]) -> Plot {
        let series = series.iter().enumerate().map(|(i, points)| Series {
            name: format!("curve {i}"),
            points: points.to_vec(),
            style: Style::LineAndMarks,
        });
        Plot { description: "a <test>".into(), x, y, series: series.collect() }
    }

    #[test]
    fn the_svg_follows_the_theme_and_fits_into_markdown() {
        let points: &[[f64; 2]] = &[[1.0, 1.0], [100.0, 2.0]];
        let svg = plot(Axis::log("n"), Axis::linear("t"), &[points, points]).svg();
        assert!(!svg.contains("\n\n"), "a blank line would end the HTML block");
        assert!(!svg.contains('#'), "no fixed colour: {svg}");
        assert!(svg.contains("a &lt;test>"), "texts are escaped");
        assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count(), "groups are closed");
    }

    #[test]
    fn names_never_overlap() {
        let points: &[[f64; 2]] = &[[0.0, 0.0], [1.0, 0.0]];
        let plot = plot(Axis::linear("x"), Axis::linear("y"), &[points; 6]);
        let frame = super::Frame {
            x: plot.x.fit([0.0, 1.0].into_iter()),
            y: plot.y.fit([0.0, 1.0].into_iter()),
            right: 600.0,
        };
        let mut heights = plot.name_heights(&frame);
        heights.sort_by(f64::total_cmp);
        let closest = heights.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
        assert!(closest >= super::LINE - 1e-9, "names {closest} apart: {heights:?}");
    }

    #[test]
    #[should_panic(expected = "logarithmic axis `n` from 0")]
    fn zero_has_no_place_on_a_logarithmic_axis() {
        let _ = plot(Axis::log("n"), Axis::linear("t"), &[&[[0.0, 1.0]]]).svg();
    }
}
