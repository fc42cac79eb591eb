//! Drawings of the derivations. Nothing in them is measured.

use glam::{Vec2, vec2};
use ray_casting::math::sin_cos;

use crate::diagram::{Diagram, bold, indexed, polar};
use crate::figures::Drawing;

const FOOT: Vec2 = vec2(340.0, 165.0);

/// ωₒ at 50° to the left, mirrored to the right, refracted downwards with ηᵢ/ηₜ = 1/1.5.
pub(super) fn directions() -> Drawing {
    let sin_t = sin_cos(50.0_f32.to_radians()).0 / 1.5;
    let theta_t = libm::asinf(sin_t).to_degrees();
    let down = 180.0 - theta_t;
    let at = |degrees, length| polar(FOOT, degrees, length);
    let mut d = Diagram::new(
        330,
        "A surface with its normal n. Omega o leaves up to the left, omega i mirrored up to the \
         right at the same angle, omega t downwards at a smaller angle to the normal. The part of \
         omega o across the normal is s.",
    )
    .pointed();
    d.path(0, 3.0, "none", "M100 165H580");
    d.path(0, 1.0, "5 4", "M340 165V312");
    d.arrow(0, FOOT, at(0.0, 140.0));
    d.text(0, "start", [348.0, 34.0], &bold("n"));
    for (series, degrees, name, anchor) in
        [(1, -50.0, "o", "end"), (2, 50.0, "i", "start"), (3, down, "t", "start")]
    {
        d.arrow(series, FOOT, at(degrees, 140.0));
        d.text(series, anchor, at(degrees, 150.0) + vec2(0.0, 3.0), &indexed("ω", name));
    }
    // ωₒ = its part along n, and s across.
    let tip = at(-50.0, 140.0);
    d.path(1, 1.5, "5 4", &format!("M{} {:.1}H{:.1}V{}", FOOT.x, tip.y, tip.x, FOOT.y));
    d.text(1, "middle", [(tip.x + FOOT.x) / 2.0, tip.y - 7.0], &bold("s"));
    let along = format!("{}·ωₒ", bold("n"));
    d.text(1, "end", [tip.x - 6.0, (tip.y + FOOT.y) / 2.0], &along);
    d.angle(1, FOOT, [-50.0, 0.0], 46.0);
    d.angle(2, FOOT, [0.0, 50.0], 46.0);
    d.angle(3, FOOT, [down, 180.0], 60.0);
    for (series, degrees, radius, letter) in
        [(1, -25.0, 60.0, "i"), (2, 25.0, 60.0, "i"), (3, 180.0 - theta_t / 2.0, 78.0, "t")]
    {
        let middle = at(degrees, radius) + vec2(0.0, 4.0);
        d.text(series, "middle", middle, &indexed("θ", letter));
    }
    d.text(0, "start", [110.0, 155.0], &indexed("index η", "i"));
    d.text(0, "start", [110.0, 188.0], &indexed("index η", "t"));
    d.finish()
}
