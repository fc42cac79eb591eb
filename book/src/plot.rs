//! Plots: lines over two axes, as SVG that takes the colours of the page's theme.
//!
//! The file is included into the page (`{{#include figures/….svg}}`), not shown as an `<img>`: only
//! then do `currentColor` and the style sheet's `.series-1` … `.series-6` reach it. Lines also
//! differ by dashes and marks, so that a plot can be read without colours.

use std::fmt::Write;

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

/// An axis of a plot.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Quantity and unit, for example `triangles` or `time / s`.
    pub label: String,
    /// Equal steps or equal factors.
    pub scale: Scale,
    /// The smallest and the largest value shown; what the points need if left out.
    pub range: Option<[f64; 2]>,
}

/// How values are spread over an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Equal lengths are equal differences.
    Linear,
    /// Equal lengths are equal factors; all values must be positive.
    Log,
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

impl Axis {
    /// An axis with equal steps that shows all points.
    #[must_use]
    pub fn linear(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            scale: Scale::Linear,
            range: None,
        }
    }

    /// An axis with equal factors that shows all points.
    #[must_use]
    pub fn log(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            scale: Scale::Log,
            range: None,
        }
    }

    /// The same axis from `min` to `max`.
    #[must_use]
    pub fn within(mut self, min: f64, max: f64) -> Self {
        self.range = Some([min, max]);
        self
    }

    /// The range with limits that make good ticks, unless it was given.
    fn fit(&self, values: impl Iterator<Item = f64>) -> Span {
        let [min, max] = self.range.unwrap_or_else(|| {
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| {
                [a.min(v), b.max(v)]
            })
        });
        let finite = min.is_finite() && max.is_finite() && min <= max;
        assert!(finite, "axis `{}` from {min} to {max}", self.label);
        match self.scale {
            Scale::Log => {
                assert!(min > 0.0, "logarithmic axis `{}` from {min}", self.label);
                let [low, high] = [libm::log10(min), libm::log10(max)];
                // A decade at least, so that a constant can be shown.
                let fitted = [
                    libm::floor(low),
                    libm::ceil(high).max(libm::floor(low) + 1.0),
                ];
                let [low, high] = if self.range.is_some() {
                    [low, high]
                } else {
                    fitted
                };
                Span {
                    scale: Scale::Log,
                    low,
                    high,
                    step: 1.0,
                }
            }
            Scale::Linear => {
                let max = if max > min { max } else { min + 1.0 };
                let step = good_step((max - min) / 5.0);
                let fitted = [
                    libm::floor(min / step) * step,
                    libm::ceil(max / step) * step,
                ];
                let [low, high] = if self.range.is_some() {
                    [min, max]
                } else {
                    fitted
                };
                Span {
                    scale: Scale::Linear,
                    low,
                    high,
                    step,
                }
            }
        }
    }
}

/// The smallest of 1, 2, 5, 10, 20, … (and 0.5, 0.2, …) that is at least `step`.
fn good_step(step: f64) -> f64 {
    let decade = power_of_ten(libm::floor(libm::log10(step)));
    // The factor tolerates rounding: a step of 0.2000…01 is 0.2.
    let fits = |m: &f64| m * decade * (1.0 + 1e-9) >= step;
    [1.0, 2.0, 5.0].into_iter().find(fits).unwrap_or(10.0) * decade
}

fn power_of_ten(exponent: f64) -> f64 {
    libm::pow(10.0, exponent)
}

/// What an axis shows; in powers of ten if it is logarithmic.
struct Span {
    scale: Scale,
    low: f64,
    high: f64,
    step: f64,
}

impl Span {
    /// The place of a value: 0 at the low end, 1 at the high end.
    fn place(&self, value: f64) -> f64 {
        let value = if self.scale == Scale::Log {
            libm::log10(value)
        } else {
            value
        };
        (value - self.low) / (self.high - self.low)
    }

    /// Places and texts of the ticks.
    fn ticks(&self) -> Vec<(f64, String)> {
        match self.scale {
            Scale::Linear => {
                let first = libm::ceil(self.low / self.step - 1e-9) as i64;
                let last = libm::floor(self.high / self.step + 1e-9) as i64;
                let tick = |i| i as f64 * self.step;
                (first..=last)
                    .map(|i| (self.place(tick(i)), decimal(tick(i), self.step)))
                    .collect()
            }
            Scale::Log => {
                let [first, last] = [libm::floor(self.low) as i32, libm::ceil(self.high) as i32];
                // Below three decades, 2 and 5 are worth a tick as well.
                let narrow: &[f64] = if last - first < 3 {
                    &[1.0, 2.0, 5.0]
                } else {
                    &[1.0]
                };
                let every = (last - first + 7) / 8;
                (first..=last)
                    .filter(|exponent| exponent % every == 0)
                    .flat_map(|exponent| narrow.iter().map(move |m| (*m, exponent)))
                    .map(|(m, exponent)| {
                        let value = m * power_of_ten(f64::from(exponent));
                        (self.place(value), magnitude(m, exponent))
                    })
                    .filter(|(place, _)| (-1e-9..=1.0 + 1e-9).contains(place))
                    .collect()
            }
        }
    }
}

/// A tick of a linear axis, with as many digits as its step needs.
fn decimal(value: f64, step: f64) -> String {
    let digits = (-libm::floor(libm::log10(step) + 1e-9)).clamp(0.0, 12.0) as usize;
    // Adding zero turns −0 into 0.
    format!("{:.digits$}", value + 0.0).replace('-', "−")
}

/// A tick of a logarithmic axis: plain numbers near 1, powers of ten elsewhere.
fn magnitude(m: f64, exponent: i32) -> String {
    match exponent {
        0..=3 => format!("{:.0}", m * power_of_ten(f64::from(exponent))),
        -3..0 => format!(
            "{:.*}",
            exponent.unsigned_abs() as usize,
            m * power_of_ten(f64::from(exponent))
        ),
        _ => {
            let digit = |c| match c {
                '-' => '⁻',
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                c => char::from_u32('⁰' as u32 + (c as u32 - '0' as u32)).unwrap_or(c),
            };
            let power: String = exponent.to_string().chars().map(digit).collect();
            if m == 1.0 {
                format!("10{power}")
            } else {
                format!("{m:.0}·10{power}")
            }
        }
    }
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
        assert!(
            self.series.len() <= DASHES.len(),
            "{} series",
            self.series.len()
        );
        let points = || self.series.iter().flat_map(|series| &series.points);
        assert!(
            points().flatten().all(|v| v.is_finite()),
            "a value is not finite"
        );
        let x = self.x.fit(points().map(|p| p[0]));
        let y = self.y.fit(points().map(|p| p[1]));
        let letters = self
            .series
            .iter()
            .map(|s| s.name.chars().count())
            .max()
            .unwrap_or(0);
        let frame = Frame {
            x,
            y,
            right: WIDTH - 14.0 - LETTER * letters as f64,
        };

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
        let ends = self
            .series
            .iter()
            .map(|s| s.points.last().map_or(BOTTOM, |p| frame.at(*p)[1]));
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
            let _ = writeln!(
                svg,
                "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{text}</text>"
            );
        }
        for (place, text) in self.y.ticks() {
            let y = BOTTOM + place * (TOP - BOTTOM);
            let _ = write!(grid, "M{LEFT} {y:.1}H{right:.1}");
            let (x, y) = (LEFT - 8.0, y + 5.0);
            let _ = writeln!(
                svg,
                "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"end\">{text}</text>"
            );
        }
        let (x, y) = ((LEFT + right) / 2.0, HEIGHT - 10.0);
        let label = escape(x_label);
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{label}</text>"
        );
        let y = (TOP + BOTTOM) / 2.0;
        let label = escape(y_label);
        let _ = writeln!(
            svg,
            "<text transform=\"translate(16 {y}) rotate(-90)\" text-anchor=\"middle\">{label}</text>"
        );
        svg.push_str("</g>\n");
        let _ = writeln!(
            svg,
            "<path d=\"{grid}\" stroke=\"currentColor\" opacity=\"0.2\"/>"
        );
        let _ = writeln!(
            svg,
            "<path d=\"M{LEFT} {TOP}V{BOTTOM}H{right:.1}\" stroke=\"currentColor\"/>"
        );
    }

    fn draw_series(&self, svg: &mut String, i: usize, series: &Series, name_height: f64) {
        let _ = writeln!(svg, "<g class=\"series-{}\">", i + 1);
        let points: Vec<_> = series.points.iter().map(|p| self.at(*p)).collect();
        if series.style != Style::Marks {
            let steps = points
                .iter()
                .zip(["M"].iter().chain(std::iter::repeat(&"L")));
            let path: String = steps
                .map(|([x, y], step)| format!("{step}{x:.1} {y:.1}"))
                .collect();
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
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"currentColor\">{name}</text>"
        );
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
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{Axis, Plot, Scale, Series, Span, Style, decimal, good_step, magnitude};

    fn plot(x: Axis, y: Axis, series: &[&[[f64; 2]]]) -> Plot {
        let series = series.iter().enumerate().map(|(i, points)| Series {
            name: format!("curve {i}"),
            points: points.to_vec(),
            style: Style::LineAndMarks,
        });
        Plot {
            description: "a <test>".into(),
            x,
            y,
            series: series.collect(),
        }
    }

    fn texts(span: &Span) -> Vec<String> {
        span.ticks().into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(good_step(0.2), 0.2, "0.2 stays");
        assert_eq!(good_step(0.21), 0.5, "above 0.2 comes 0.5");
        assert_eq!(good_step(7.0), 10.0, "above 5 comes 10");
        let linear = Axis::linear("x").fit([0.0, 1.0].into_iter());
        assert_eq!(
            texts(&linear),
            ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"],
            "0 to 1"
        );
        let negative = Axis::linear("x").fit([-3.0, 2.0].into_iter());
        assert_eq!(
            texts(&negative),
            ["−3", "−2", "−1", "0", "1", "2"],
            "−3 to 2"
        );
        let log = Axis::log("x").fit([1e3, 1e6].into_iter());
        assert_eq!(texts(&log), ["1000", "10⁴", "10⁵", "10⁶"], "three decades");
        let narrow = Axis::log("x").fit([1.0, 8.0].into_iter());
        assert_eq!(texts(&narrow), ["1", "2", "5", "10"], "one decade");
    }

    #[test]
    fn a_tick_is_written_with_the_digits_it_needs() {
        assert_eq!(decimal(0.30000000000000004, 0.1), "0.3", "a tenth");
        assert_eq!(decimal(-0.0, 1.0), "0", "no minus zero");
        assert_eq!(magnitude(2.0, -3), "0.002", "thousandths");
        assert_eq!(magnitude(1.0, -7), "10⁻⁷", "tiny");
        assert_eq!(magnitude(5.0, 12), "5·10¹²", "huge");
    }

    #[test]
    fn equal_factors_are_equal_lengths_on_a_logarithmic_axis() {
        let span = Span {
            scale: Scale::Log,
            low: 0.0,
            high: 4.0,
            step: 1.0,
        };
        assert!(
            (span.place(10.0) - 0.25).abs() < 1e-12,
            "10 at {}",
            span.place(10.0)
        );
        assert!(
            (span.place(1000.0) - 0.75).abs() < 1e-12,
            "1000 at {}",
            span.place(1000.0)
        );
    }

    #[test]
    fn the_svg_follows_the_theme_and_fits_into_markdown() {
        let points: &[[f64; 2]] = &[[1.0, 1.0], [100.0, 2.0]];
        let svg = plot(Axis::log("n"), Axis::linear("t"), &[points, points]).svg();
        assert!(
            !svg.contains("\n\n"),
            "a blank line would end the HTML block"
        );
        assert!(!svg.contains('#'), "no fixed colour: {svg}");
        assert!(svg.contains("a &lt;test>"), "texts are escaped");
        assert_eq!(
            svg.matches("<g").count(),
            svg.matches("</g>").count(),
            "groups are closed"
        );
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
        let closest = heights
            .windows(2)
            .map(|w| w[1] - w[0])
            .fold(f64::INFINITY, f64::min);
        assert!(
            closest >= super::LINE - 1e-9,
            "names {closest} apart: {heights:?}"
        );
    }

    #[test]
    #[should_panic(expected = "logarithmic axis `n` from 0")]
    fn zero_has_no_place_on_a_logarithmic_axis() {
        let _ = plot(Axis::log("n"), Axis::linear("t"), &[&[[0.0, 1.0]]]).svg();
    }
}
