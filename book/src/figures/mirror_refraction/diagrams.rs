//! Drawings of the derivations. Nothing in them is measured.

use ray_casting::math::sin_cos;

use crate::figures::Drawing;

const FOOT: [f32; 2] = [340.0, 165.0];

/// A place at an angle from the normal, in degrees to the right, and a distance from the foot.
fn at(degrees: f32, length: f32) -> [f32; 2] {
    let (sin, cos) = sin_cos(degrees.to_radians());
    [FOOT[0] + length * sin, FOOT[1] - length * cos]
}

fn line(series: u32, width: f32, dashes: &str, path: &str) -> String {
    format!(
        "<g class=\"series-{series}\"><path d=\"{path}\" stroke=\"currentColor\" \
         stroke-width=\"{width}\" stroke-dasharray=\"{dashes}\"/></g>\n"
    )
}

/// From the foot outwards, with a head at the end.
fn arrow(series: u32, degrees: f32, length: f32) -> String {
    let ([x0, y0], [x1, y1]) = (FOOT, at(degrees, length));
    let (dx, dy) = (9.0 * (x1 - x0) / length, 9.0 * (y1 - y0) / length);
    let [ax, ay] = [x1 - dx - 0.45 * dy, y1 - dy + 0.45 * dx];
    let [bx, by] = [x1 - dx + 0.45 * dy, y1 - dy - 0.45 * dx];
    let path =
        format!("M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}M{ax:.1} {ay:.1}L{x1:.1} {y1:.1}L{bx:.1} {by:.1}");
    line(series, 2.0, "none", &path)
}

fn words(series: u32, anchor: &str, [x, y]: [f32; 2], words: &str) -> String {
    format!(
        "<g class=\"series-{series}\"><text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" \
         fill=\"currentColor\">{words}</text></g>\n"
    )
}

fn arc(series: u32, from: f32, to: f32, radius: f32) -> String {
    let ([x0, y0], [x1, y1]) = (at(from, radius), at(to, radius));
    let path = format!("M{x0:.1} {y0:.1}A{radius} {radius} 0 0 1 {x1:.1} {y1:.1}");
    line(series, 1.5, "none", &path)
}

fn omega(letter: &str) -> String {
    format!("ω<tspan font-size=\"11\" dy=\"4\">{letter}</tspan>")
}

/// ωₒ at 50° to the left, mirrored to the right, refracted downwards with ηᵢ/ηₜ = 1/1.5.
pub(super) fn directions() -> Drawing {
    let sin_t = sin_cos(50.0_f32.to_radians()).0 / 1.5;
    let theta_t = libm::asinf(sin_t).to_degrees();
    let down = 180.0 - theta_t;
    let mut body = line(0, 3.0, "none", "M100 165H580");
    body += &line(0, 1.0, "5 4", "M340 165V312");
    body += &arrow(0, 0.0, 140.0);
    body += &words(0, "start", [348.0, 34.0], "<tspan font-weight=\"bold\">n</tspan>");
    for (series, degrees, name, anchor) in
        [(1, -50.0, "o", "end"), (2, 50.0, "i", "start"), (3, down, "t", "start")]
    {
        body += &arrow(series, degrees, 140.0);
        let [x, y] = at(degrees, 150.0);
        body += &words(series, anchor, [x, y + 3.0], &omega(name));
    }
    // ωₒ = its part along n, and s across.
    let ([x, y], [foot_x, foot_y]) = (at(-50.0, 140.0), FOOT);
    body += &line(1, 1.5, "5 4", &format!("M{foot_x} {y:.1}H{x:.1}V{foot_y}"));
    let s = [(x + foot_x) / 2.0, y - 7.0];
    body += &words(1, "middle", s, "<tspan font-weight=\"bold\">s</tspan>");
    body +=
        &words(1, "end", [x - 6.0, (y + foot_y) / 2.0], "<tspan font-weight=\"bold\">n</tspan>·ωₒ");
    body += &arc(1, -50.0, 0.0, 46.0);
    body += &arc(2, 0.0, 50.0, 46.0);
    body += &arc(3, down, 180.0, 60.0);
    let theta = |letter: &str| format!("θ<tspan font-size=\"11\" dy=\"4\">{letter}</tspan>");
    for (series, degrees, radius, letter) in
        [(1, -25.0, 60.0, "i"), (2, 25.0, 60.0, "i"), (3, 180.0 - theta_t / 2.0, 78.0, "t")]
    {
        let [x, y] = at(degrees, radius);
        body += &words(series, "middle", [x, y + 4.0], &theta(letter));
    }
    body += &words(0, "start", [110.0, 155.0], "index η<tspan font-size=\"11\" dy=\"4\">i</tspan>");
    body += &words(0, "start", [110.0, 188.0], "index η<tspan font-size=\"11\" dy=\"4\">t</tspan>");
    Drawing::Text(format!(
        "<svg viewBox=\"0 0 680 330\" aria-label=\"A surface with its normal n. Omega o leaves up to \
         the left, omega i mirrored up to the right at the same angle, omega t downwards at a smaller \
         angle to the normal. The part of omega o across the normal is s.\" class=\"plot\" \
         role=\"img\" font-size=\"15\" fill=\"none\" stroke=\"none\" color=\"currentColor\">\n\
         {body}</svg>\n"
    ))
}
