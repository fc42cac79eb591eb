//! Plots with two logarithmic axes, as SVG that takes the colours of the page around it.
//!
//! The book has a plot of its own, but also a builder of pages that nobody should have to compile
//! for a measurement. This one draws what a measurement needs: curves with names and intervals.
//! The classes are those of the book's style sheet; without it everything has the text's colour,
//! and dashes and marks tell the curves apart.

use std::fmt::Write;

/// Named curves over two logarithmic axes.
#[derive(Clone, Debug)]
pub struct Plot {
    /// The question that the plot answers.
    pub title: String,
    /// Quantity and unit of the horizontal axis.
    pub x: String,
    /// Quantity and unit of the vertical axis.
    pub y: String,
    /// The curves.
    pub curves: Vec<Line>,
}

/// A curve of a plot.
#[derive(Clone, Debug)]
pub struct Line {
    /// Written beside the plot, with a line to the curve's end.
    pub name: String,
    /// Its points, from left to right.
    pub points: Vec<Mark>,
}

/// A point of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// Where it is on the horizontal axis.
    pub x: f64,
    /// Where it is on the vertical axis.
    pub y: f64,
    /// Half the length of its interval on the vertical axis; 0 or NaN for none.
    pub interval: f64,
}

const WIDTH: f64 = 680.0;
const HEIGHT: f64 = 420.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 362.0;
const LEFT: f64 = 74.0;
/// Width of a letter, generously.
const LETTER: f64 = 7.6;
/// Least distance between two names.
const SPACING: f64 = 17.0;
const DASHES: [&str; 6] = ["none", "9 4", "2 3", "9 3 2 3", "5 3", "14 4"];

impl Plot {
    /// The plot as an SVG element without blank lines, so that Markdown takes it for one block.
    ///
    /// Points that have no logarithm are left out: relMSE less that of the reference can fall
    /// below 0. A plot without points is `None`.
    #[must_use]
    pub fn svg(&self) -> Option<String> {
        let curves = self.curves.iter().map(Line::drawable);
        let curves: Vec<Line> = curves.filter(|curve| !curve.points.is_empty()).collect();
        let marks = || curves.iter().flat_map(|curve| &curve.points);
        let letters = curves.iter().map(|curve| curve.name.chars().count()).max()?;
        let frame = Frame {
            x: Decades::around(marks().map(|mark| mark.x)),
            y: Decades::around(marks().map(|mark| mark.y)),
            right: WIDTH - 16.0 - LETTER * letters as f64,
        };
        let title = escape(&self.title);
        let mut svg = format!(
            "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"{title}\" \
             font-size=\"14\" fill=\"none\" stroke=\"none\" color=\"currentColor\">\n\
             <text x=\"{LEFT}\" y=\"18\" fill=\"currentColor\">{title}</text>\n"
        );
        frame.draw_axes(&mut svg, &escape(&self.x), &escape(&self.y));
        let heights = frame.name_heights(&curves);
        for (i, (curve, height)) in curves.iter().zip(heights).enumerate() {
            frame.draw_curve(&mut svg, i, curve, height);
        }
        svg.push_str("</svg>\n");
        Some(svg)
    }
}

impl Line {
    /// The curve without the points that have no logarithm.
    fn drawable(&self) -> Self {
        let good = |value: f64| value > 0.0 && value.is_finite();
        let points = self.points.iter().filter(|mark| good(mark.x) && good(mark.y));
        Self { name: self.name.clone(), points: points.copied().collect() }
    }
}

/// Whole decades that hold all values, as powers of ten.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Decades {
    low: i32,
    high: i32,
}

impl Decades {
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let [min, max] = values
            .map(libm::log10)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], v| [min.min(v), max.max(v)]);
        // Rounding may put 1000 a hair above the third power of ten.
        let low = (min + 1e-9).floor() as i32;
        Self { low, high: ((max - 1e-9).ceil() as i32).max(low + 1) }
    }

    /// 0 at the low end, 1 at the high end.
    fn place(self, value: f64) -> f64 {
        (libm::log10(value) - f64::from(self.low)) / f64::from(self.high - self.low)
    }

    /// Places and texts of the ticks; below three decades also 2 and 5.
    fn ticks(self) -> Vec<(f64, String)> {
        let decades = self.high - self.low;
        let steps: &[u32] = if decades < 3 { &[1, 2, 5] } else { &[1] };
        let every = (decades + 7) / 8;
        (self.low..=self.high)
            .filter(|power| (power - self.low) % every == 0)
            .flat_map(|power| steps.iter().map(move |&step| (step, power)))
            .map(|(step, power)| {
                let value = f64::from(step) * libm::pow(10.0, f64::from(power));
                (self.place(value), magnitude(step, power))
            })
            .filter(|(place, _)| *place <= 1.0 + 1e-9)
            .collect()
    }
}

/// Plain numbers from 0.001 to 1000, powers of ten elsewhere.
fn magnitude(step: u32, power: i32) -> String {
    let value = f64::from(step) * libm::pow(10.0, f64::from(power));
    match power {
        0..=3 => format!("{value:.0}"),
        -3..0 => format!("{value:.*}", power.unsigned_abs() as usize),
        _ => {
            let power: String = power.to_string().chars().map(superscript).collect();
            if step == 1 { format!("10{power}") } else { format!("{step}·10{power}") }
        }
    }
}

fn superscript(character: char) -> char {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    character.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize])
}

/// The rectangle that the curves are drawn in.
struct Frame {
    x: Decades,
    y: Decades,
    right: f64,
}

// Writing to a String cannot fail, so the results of `writeln!` are dropped.
impl Frame {
    fn across(&self, x: f64) -> f64 {
        LEFT + self.x.place(x) * (self.right - LEFT)
    }

    fn down(&self, y: f64) -> f64 {
        BOTTOM + self.y.place(y) * (TOP - BOTTOM)
    }

    fn draw_axes(&self, svg: &mut String, x_label: &str, y_label: &str) {
        let right = self.right;
        let mut grid = String::new();
        svg.push_str("<g fill=\"currentColor\">\n");
        for (place, text) in self.x.ticks() {
            let (x, y) = (LEFT + place * (right - LEFT), BOTTOM + 20.0);
            let _ = write!(grid, "M{x:.1} {TOP}V{BOTTOM}");
            let _ =
                writeln!(svg, "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{text}</text>");
        }
        for (place, text) in self.y.ticks() {
            let y = BOTTOM + place * (TOP - BOTTOM);
            let _ = write!(grid, "M{LEFT} {y:.1}H{right:.1}");
            let (x, y) = (LEFT - 8.0, y + 5.0);
            let _ = writeln!(svg, "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"end\">{text}</text>");
        }
        let (x, y) = ((LEFT + right) / 2.0, HEIGHT - 12.0);
        let _ =
            writeln!(svg, "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{x_label}</text>");
        let y = (TOP + BOTTOM) / 2.0;
        let _ = writeln!(
            svg,
            "<text transform=\"translate(16 {y}) rotate(-90)\" text-anchor=\"middle\">{y_label}\
             </text>\n</g>"
        );
        let _ = writeln!(svg, "<path d=\"{grid}\" stroke=\"currentColor\" opacity=\"0.2\"/>");
        let frame = format!("M{LEFT} {TOP}V{BOTTOM}H{right:.1}");
        let _ = writeln!(svg, "<path d=\"{frame}\" stroke=\"currentColor\"/>");
    }

    fn draw_curve(&self, svg: &mut String, i: usize, curve: &Line, name_height: f64) {
        let (mut path, mut marks, mut intervals) = (String::new(), String::new(), String::new());
        for (step, mark) in curve.points.iter().enumerate() {
            let (x, y) = (self.across(mark.x), self.down(mark.y));
            let _ = write!(path, "{}{x:.1} {y:.1}", if step == 0 { 'M' } else { 'L' });
            marks.push_str(&symbol(i, x, y));
            if mark.interval > 0.0 {
                let high = self.down(mark.y + mark.interval).max(TOP);
                let low = mark.y - mark.interval;
                let low = if low > 0.0 { self.down(low).min(BOTTOM) } else { BOTTOM };
                let _ = write!(intervals, "M{x:.1} {high:.1}V{low:.1}");
            }
        }
        let end =
            curve.points.last().map_or([LEFT, BOTTOM], |m| [self.across(m.x), self.down(m.y)]);
        let leader =
            format!("M{:.1} {:.1}L{:.1} {name_height:.1}", end[0], end[1], self.right + 6.0);
        let (x, y, name) = (self.right + 9.0, name_height + 5.0, escape(&curve.name));
        let (class, dashes) = (i % 6 + 1, DASHES[i % 6]);
        let _ = writeln!(
            svg,
            "<g class=\"series-{class}\">\n\
             <path d=\"{path}\" stroke=\"currentColor\" stroke-width=\"2\" \
             stroke-dasharray=\"{dashes}\" stroke-linejoin=\"round\"/>\n\
             <path d=\"{leader}\" stroke=\"currentColor\" opacity=\"0.4\"/>\n\
             <path d=\"{intervals}\" stroke=\"currentColor\"/>\n\
             <path d=\"{marks}\" fill=\"currentColor\"/>\n\
             <text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"currentColor\">{name}</text>\n</g>"
        );
    }

    /// At which height each name stands: that of its curve's end, but not on another name.
    fn name_heights(&self, curves: &[Line]) -> Vec<f64> {
        let end = |curve: &Line| curve.points.last().map_or(BOTTOM, |mark| self.down(mark.y));
        let mut order: Vec<(usize, f64)> = curves.iter().map(end).enumerate().collect();
        order.sort_by(|a, b| a.1.total_cmp(&b.1));
        for i in 1..order.len() {
            order[i].1 = order[i].1.max(order[i - 1].1 + SPACING);
        }
        // What was pushed below the axis is moved up again, with all that it meets there.
        let mut limit = BOTTOM;
        for (_, height) in order.iter_mut().rev() {
            *height = height.min(limit);
            limit = *height - SPACING;
        }
        order.sort_by_key(|(i, _)| *i);
        order.into_iter().map(|(_, height)| height).collect()
    }
}

/// A circle, square, triangle, diamond, triangle upside down or bar, about 8 pixels wide.
fn symbol(i: usize, x: f64, y: f64) -> String {
    match i % 6 {
        0 => format!("M{:.1} {y:.1}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", x - 4.0),
        1 => format!("M{:.1} {:.1}h7v7h-7z", x - 3.5, y - 3.5),
        2 => format!("M{x:.1} {:.1}l4.5 8h-9z", y - 5.0),
        3 => format!("M{x:.1} {:.1}l5 5l-5 5l-5 -5z", y - 5.0),
        4 => format!("M{x:.1} {:.1}l4.5 -8h-9z", y + 5.0),
        _ => format!("M{:.1} {:.1}h10v4h-10z", x - 5.0, y - 2.0),
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{BOTTOM, Decades, Line, Mark, Plot, TOP, magnitude};

    fn plot(points: &[[f64; 2]], curves: usize) -> Plot {
        let points: Vec<Mark> =
            points.iter().map(|&[x, y]| Mark { x, y, interval: 0.5 * y }).collect();
        let line = |i| Line { name: format!("curve <{i}>"), points: points.clone() };
        Plot {
            title: "Which is \"better\"?".into(),
            x: "n".into(),
            y: "t".into(),
            curves: (0..curves).map(line).collect(),
        }
    }

    #[test]
    fn the_svg_follows_the_theme_and_fits_into_markdown() {
        let svg = plot(&[[1.0, 10.0], [100.0, 0.1]], 7).svg().expect("two points");
        assert!(!svg.contains("\n\n"), "a blank line would end the HTML block");
        assert!(!svg.contains('#') && !svg.contains("NaN"), "{svg}");
        assert!(svg.contains("curve &lt;3>"), "texts are escaped");
        assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count(), "groups are closed");
        assert!(svg.contains("Which is &quot;better&quot;?</text>"), "the question is named");
    }

    #[test]
    fn what_has_no_logarithm_is_left_out() {
        let svg = plot(&[[1.0, 1.0], [2.0, -1.0], [3.0, f64::NAN]], 1).svg().expect("a point");
        assert!(!svg.contains("NaN"), "{svg}");
        assert!(plot(&[[1.0, 0.0]], 1).svg().is_none(), "nothing is left");
    }

    #[test]
    fn a_decade_is_as_long_as_another() {
        let decades = Decades::around([1000.0, 2.0].into_iter());
        assert_eq!(decades, Decades { low: 0, high: 3 }, "1 to 1000");
        assert!((decades.place(10.0) - 1.0 / 3.0).abs() < 1e-12, "{}", decades.place(10.0));
        let texts: Vec<String> = decades.ticks().into_iter().map(|(_, text)| text).collect();
        assert_eq!(texts, ["1", "10", "100", "1000"], "ticks");
        assert_eq!(
            [magnitude(5, -2), magnitude(1, -7), magnitude(2, 4)],
            ["0.05", "10⁻⁷", "2·10⁴"]
        );
    }

    #[test]
    fn names_never_overlap() {
        let plot = plot(&[[1.0, 1.0], [10.0, 1.0]], 6);
        let frame = super::Frame {
            x: Decades { low: 0, high: 1 },
            y: Decades { low: 0, high: 1 },
            right: 600.0,
        };
        let mut heights = frame.name_heights(&plot.curves);
        heights.sort_by(f64::total_cmp);
        let closest = heights.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
        assert!(closest >= super::SPACING - 1e-9, "names {closest} apart: {heights:?}");
        assert!(heights.iter().all(|h| (TOP..=BOTTOM).contains(h)), "{heights:?}");
    }
}
