//! Diagrams: the drawings of derivations, in which nothing is measured.
//!
//! Like a [`plot`](crate::plot), a diagram is included into the page and takes the colours of its
//! theme: series 1 to 6 are those of the plots, and series 0 is the colour of the text. Lengths are
//! pixels of a drawing that is 680 wide; y grows downwards.

use std::fmt::Write;

use glam::{Vec2, vec2};
use ray_casting::math::sin_cos;

use crate::figures::Drawing;

/// A drawing of lines and words.
#[derive(Clone, Debug)]
pub struct Diagram {
    height: u32,
    description: String,
    corners: &'static str,
    body: String,
}

impl Diagram {
    /// An empty drawing, 680 wide, with words for readers who cannot see it.
    #[must_use]
    pub fn new(height: u32, description: &str) -> Self {
        Self { height, description: description.to_owned(), corners: "round", body: String::new() }
    }

    /// The same with pointed corners and arrows.
    #[must_use]
    pub fn pointed(self) -> Self {
        Self { corners: "miter", ..self }
    }

    /// A path of the given weight; `dashes` are those of SVG, or `none`.
    pub fn path(&mut self, series: u32, width: f32, dashes: &str, path: &str) -> &mut Self {
        self.draw(
            series,
            &format!(
                "<path d=\"{path}\" stroke=\"currentColor\" stroke-width=\"{width}\" \
                 stroke-dasharray=\"{dashes}\"/>"
            ),
        )
    }

    /// A straight line between two points.
    pub fn line(
        &mut self,
        series: u32,
        width: f32,
        dashes: &str,
        from: impl Into<Vec2>,
        to: impl Into<Vec2>,
    ) -> &mut Self {
        let path = format!("M{}L{}", place(from.into()), place(to.into()));
        self.path(series, width, dashes, &path)
    }

    /// A line with a head at its end.
    pub fn arrow(&mut self, series: u32, from: impl Into<Vec2>, to: impl Into<Vec2>) -> &mut Self {
        let (from, to) = (from.into(), to.into());
        let back = 9.0 * (from - to).normalize();
        let [a, b] = [1.0, -1.0].map(|side| place(to + back + 0.45 * side * back.perp()));
        let (from, to) = (place(from), place(to));
        self.path(series, 2.0, "none", &format!("M{from}L{to}M{a}L{to}L{b}"))
    }

    /// The angle between two directions, in degrees clockwise from straight up.
    pub fn angle(
        &mut self,
        series: u32,
        center: impl Into<Vec2>,
        [from, to]: [f32; 2],
        radius: f32,
    ) -> &mut Self {
        let center = center.into();
        let [from, to] = [from, to].map(|degrees| place(polar(center, degrees, radius)));
        self.path(series, 1.5, "none", &format!("M{from}A{radius} {radius} 0 0 1 {to}"))
    }

    /// A closed polygon, its inside faintly coloured.
    pub fn polygon(&mut self, series: u32, opacity: f32, points: &[Vec2]) -> &mut Self {
        let corners: Vec<_> = points.iter().map(|&p| place(p)).collect();
        self.draw(
            series,
            &format!(
                "<polygon points=\"{}\" stroke=\"currentColor\" stroke-width=\"2\" \
                 fill=\"currentColor\" fill-opacity=\"{opacity}\"/>",
                corners.join(" ")
            ),
        )
    }

    /// An upright rectangle, its inside faintly coloured.
    pub fn boxed(
        &mut self,
        series: u32,
        opacity: f32,
        [x, y]: [f32; 2],
        [w, h]: [f32; 2],
    ) -> &mut Self {
        let corners = [vec2(x, y), vec2(x + w, y), vec2(x + w, y + h), vec2(x, y + h)];
        self.polygon(series, opacity, &corners)
    }

    /// A point that is to be seen.
    pub fn dot(&mut self, series: u32, at: impl Into<Vec2>) -> &mut Self {
        self.spot(series, 4.0, at)
    }

    /// A filled circle.
    pub fn spot(&mut self, series: u32, radius: f32, at: impl Into<Vec2>) -> &mut Self {
        let [x, y] = at.into().to_array().map(short);
        self.draw(
            series,
            &format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"currentColor\"/>"),
        )
    }

    /// Words that begin at, stand around or end at a point: `start`, `middle` or `end`.
    pub fn text(
        &mut self,
        series: u32,
        anchor: &str,
        at: impl Into<Vec2>,
        words: &str,
    ) -> &mut Self {
        let [x, y] = at.into().to_array().map(short);
        self.draw(
            series,
            &format!(
                "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" fill=\"currentColor\">{words}</text>"
            ),
        )
    }

    fn draw(&mut self, series: u32, element: &str) -> &mut Self {
        let class = if series == 0 { String::new() } else { format!(" class=\"series-{series}\"") };
        // Writing to a String cannot fail.
        let _ = writeln!(self.body, "<g{class}>{element}</g>");
        self
    }

    /// The drawing as an SVG element without blank lines, to be included into a page.
    #[must_use]
    pub fn finish(&self) -> Drawing {
        let Self { height, description, corners, body } = self;
        Drawing::Text(format!(
            "<svg class=\"plot\" viewBox=\"0 0 680 {height}\" role=\"img\" \
             aria-label=\"{description}\" font-size=\"15\" fill=\"none\" stroke=\"none\" \
             stroke-linejoin=\"{corners}\" color=\"currentColor\">\n{body}</svg>\n"
        ))
    }
}

/// The place at an angle, in degrees clockwise from straight up, and a distance from another.
#[must_use]
pub fn polar(center: impl Into<Vec2>, degrees: f32, length: f32) -> Vec2 {
    let (sin, cos) = sin_cos(degrees.to_radians());
    center.into() + length * vec2(sin, -cos)
}

/// A vector's name.
#[must_use]
pub fn bold(letter: &str) -> String {
    format!("<tspan font-weight=\"bold\">{letter}</tspan>")
}

/// A name with a small letter below; what follows on the same line stands lower, too.
#[must_use]
pub fn indexed(name: &str, index: &str) -> String {
    format!("{name}<tspan font-size=\"11\" dy=\"4\">{index}</tspan>")
}

fn place(p: Vec2) -> String {
    format!("{} {}", short(p.x), short(p.y))
}

/// One digit after the point, if it is not 0.
fn short(x: f32) -> String {
    let digits = format!("{x:.1}");
    let digits = digits.strip_suffix(".0").unwrap_or(&digits);
    if digits == "-0" { "0".to_owned() } else { digits.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::{Diagram, short};
    use crate::figures::Drawing;

    #[test]
    fn a_diagram_follows_the_theme_and_fits_into_markdown() {
        let mut diagram = Diagram::new(100, "a drawing");
        diagram.arrow(1, [0.0, 0.0], [30.0, 40.0]).dot(0, [1.0, 2.0]).text(
            2,
            "end",
            [3.0, 4.0],
            "x",
        );
        let Drawing::Text(svg) = diagram.finish() else { panic!("a diagram is text") };
        assert!(!svg.contains("\n\n"), "a blank line would end the HTML block: {svg}");
        assert!(!svg.contains('#'), "no fixed colour: {svg}");
        assert!(svg.contains("<g><circle") && svg.contains("<g class=\"series-2\">"), "{svg}");
    }

    #[test]
    fn numbers_have_the_digits_that_they_need() {
        let written = [40.0, 0.25, -0.01, -3.55, 163.21].map(short);
        assert_eq!(written, ["40", "0.2", "0", "-3.5", "163.2"], "rounded to tenths");
    }
}
