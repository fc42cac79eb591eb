//! Drawings of the derivations. Nothing in them is measured.

use crate::figures::Drawing;

/// Where the lines of a drawing begin: 680 wide, in the colours of the page.
const OPEN: &str = "class=\"plot\" role=\"img\" font-size=\"15\" fill=\"none\" stroke=\"none\" \
                    color=\"currentColor\"";

/// A drawing of this height with words for readers who cannot see it.
fn drawing(height: u32, description: &str, body: &str) -> Drawing {
    Drawing::Text(format!(
        "<svg viewBox=\"0 0 680 {height}\" aria-label=\"{description}\" {OPEN}>\n{body}</svg>\n"
    ))
}

/// A line with a head at its end, in the colour of a series; 0 is the colour of the text.
fn arrow(series: u32, from: [f32; 2], to: [f32; 2]) -> String {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = (dx * dx + dy * dy).sqrt();
    let (dx, dy) = (9.0 * dx / length, 9.0 * dy / length);
    let head = |side: f32| (to[0] - dx - side * 0.45 * dy, to[1] - dy + side * 0.45 * dx);
    let ((ax, ay), (bx, by)) = (head(1.0), head(-1.0));
    let ([x0, y0], [x1, y1]) = (from, to);
    line(
        series,
        2.0,
        "none",
        &format!(
            "M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}M{ax:.1} {ay:.1}L{x1:.1} {y1:.1}L{bx:.1} {by:.1}"
        ),
    )
}

/// A path of the given weight and dashes.
fn line(series: u32, width: f32, dashes: &str, path: &str) -> String {
    format!(
        "<g class=\"series-{series}\"><path d=\"{path}\" stroke=\"currentColor\" \
         stroke-width=\"{width}\" stroke-dasharray=\"{dashes}\"/></g>\n"
    )
}

/// Words that stand at a point: `start`, `middle` or `end` say which part of them.
fn words(series: u32, anchor: &str, [x, y]: [f32; 2], words: &str) -> String {
    format!(
        "<g class=\"series-{series}\"><text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" \
         fill=\"currentColor\">{words}</text></g>\n"
    )
}

/// A vector's name.
fn bold(letter: &str) -> String {
    format!("<tspan font-weight=\"bold\">{letter}</tspan>")
}

/// A beam meets a surface upright, and at an angle of 60°, where it covers twice the length.
pub(super) fn beam() -> Drawing {
    let mut body = String::new();
    // Upright: 80 wide, 80 covered.
    body += &line(0, 3.0, "none", "M40 190H280");
    body += &line(1, 1.0, "5 4", "M120 40V190M200 40V190");
    for x in [130.0, 160.0, 190.0] {
        body += &arrow(1, [x, 40.0], [x, 184.0]);
    }
    body += &line(2, 4.0, "none", "M120 190H200");
    body += &words(2, "middle", [160.0, 214.0], "A");
    body += &words(1, "middle", [160.0, 28.0], "beam of width A");
    // At 60° from the normal, down to the right: the direction is (sin 60°, cos 60°), and the beam,
    // 80 across, covers 160.
    body += &line(0, 3.0, "none", "M380 190H660");
    let (sin, cos) = (0.866_f32, 0.5_f32);
    for (offset, head) in [(0.0, false), (20.0, true), (80.0, true), (140.0, true), (160.0, false)]
    {
        let foot = [460.0 + offset, 190.0];
        let start = [foot[0] - 170.0 * sin, foot[1] - 170.0 * cos];
        if head {
            let end = [foot[0] - 6.0 * sin, foot[1] - 6.0 * cos];
            body += &arrow(1, start, end);
        } else {
            let path = format!("M{:.1} {:.1}L{:.1} {:.1}", start[0], start[1], foot[0], foot[1]);
            body += &line(1, 1.0, "5 4", &path);
        }
    }
    body += &line(2, 4.0, "none", "M460 190H620");
    body += &words(2, "middle", [540.0, 214.0], "A / cos θ");
    body += &arrow(0, [620.0, 190.0], [620.0, 60.0]);
    body += &words(0, "start", [628.0, 72.0], &bold("n"));
    body += &line(0, 1.0, "none", "M620 150A40 40 0 0 0 585.4 170");
    body += &words(0, "middle", [594.0, 150.0], "θ");
    drawing(
        230,
        "The same beam on a surface. Upright it covers its own width A; at an angle theta to the \
         normal it covers A divided by the cosine of theta.",
        &body,
    )
}

/// **l**, **v**, **h** between them, and the mirrored direction **r**.
pub(super) fn halfway() -> Drawing {
    let foot = [340.0_f32, 200.0];
    let at = |degrees: f32, length: f32| {
        let (sin, cos) = ray_casting::math::sin_cos(degrees.to_radians());
        [foot[0] + length * sin, foot[1] - length * cos]
    };
    let arc = |from: f32, to: f32, radius: f32| {
        let ([x0, y0], [x1, y1]) = (at(from, radius), at(to, radius));
        format!("M{x0:.1} {y0:.1}A{radius} {radius} 0 0 1 {x1:.1} {y1:.1}")
    };
    let mut body = line(0, 3.0, "none", "M120 200H560");
    // l at −60°, r mirrored at +60°, v at +30°: h at −15°, and the angle from r to v is twice that.
    for (series, degrees, length, name) in [
        (0, 0.0, 165.0, bold("n")),
        (1, -60.0, 165.0, bold("l")),
        (1, 30.0, 165.0, format!("{} = ω<tspan font-size=\"11\" dy=\"4\">o</tspan>", bold("v"))),
        (2, -15.0, 165.0, bold("h")),
        (3, 60.0, 165.0, format!("{}, {} mirrored", bold("r"), bold("l"))),
    ] {
        body += &arrow(series, foot, at(degrees, length));
        let anchor = if degrees < 0.0 { "end" } else { "start" };
        let [x, y] = at(degrees, length + 8.0);
        body += &words(series, anchor, [x, y + 2.0], &name);
    }
    body += &line(2, 1.5, "none", &arc(-15.0, 0.0, 120.0));
    let [x, y] = at(-7.5, 130.0);
    body += &words(2, "middle", [x, y], "α");
    body += &line(3, 1.5, "none", &arc(30.0, 60.0, 120.0));
    let [x, y] = at(45.0, 136.0);
    body += &words(3, "middle", [x, y + 4.0], "2α");
    drawing(
        220,
        "The directions l to the light and v to the eye, the half vector h between them, the normal \
         n, and r, the mirrored l. The angle between h and n is half of that between r and v.",
        &body,
    )
}
