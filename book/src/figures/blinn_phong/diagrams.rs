//! Drawings of the derivations. Nothing in them is measured.

use glam::vec2;

use crate::diagram::{Diagram, bold, indexed, polar};
use crate::figures::Drawing;

/// A beam meets a surface upright, and at an angle of 60°, where it covers twice the length.
pub(super) fn beam() -> Drawing {
    let mut d = Diagram::new(
        230,
        "The same beam on a surface. Upright it covers its own width A; at an angle theta to the \
         normal it covers A divided by the cosine of theta.",
    )
    .pointed();
    // Upright: 80 wide, 80 covered.
    d.path(0, 3.0, "none", "M40 190H280");
    d.path(1, 1.0, "5 4", "M120 40V190M200 40V190");
    for x in [130.0, 160.0, 190.0] {
        d.arrow(1, [x, 40.0], [x, 184.0]);
    }
    d.path(2, 4.0, "none", "M120 190H200");
    d.text(2, "middle", [160.0, 214.0], "A");
    d.text(1, "middle", [160.0, 28.0], "beam of width A");
    // At 60° from the normal, down to the right: the beam, 80 across, covers 160.
    d.path(0, 3.0, "none", "M380 190H660");
    for (offset, head) in [(0.0, false), (20.0, true), (80.0, true), (140.0, true), (160.0, false)]
    {
        let foot = [460.0 + offset, 190.0];
        let start = polar(foot, -60.0, 170.0);
        if head {
            d.arrow(1, start, polar(foot, -60.0, 6.0));
        } else {
            d.line(1, 1.0, "5 4", start, foot);
        }
    }
    d.path(2, 4.0, "none", "M460 190H620");
    d.text(2, "middle", [540.0, 214.0], "A / cos θ");
    d.arrow(0, [620.0, 190.0], [620.0, 60.0]);
    d.text(0, "start", [628.0, 72.0], &bold("n"));
    d.path(0, 1.0, "none", "M620 150A40 40 0 0 0 585.4 170");
    d.text(0, "middle", [594.0, 150.0], "θ");
    d.finish()
}

/// **l**, **v**, **h** between them, and the mirrored direction **r**.
pub(super) fn halfway() -> Drawing {
    let foot = [340.0, 200.0];
    let mut d = Diagram::new(
        220,
        "The directions l to the light and v to the eye, the half vector h between them, the normal \
         n, and r, the mirrored l. The angle between h and n is half of that between r and v.",
    )
    .pointed();
    d.path(0, 3.0, "none", "M120 200H560");
    // l at −60°, r mirrored at +60°, v at +30°: h at −15°, and the angle from r to v is twice that.
    for (series, degrees, name) in [
        (0, 0.0, bold("n")),
        (1, -60.0, bold("l")),
        (1, 30.0, format!("{} = {}", bold("v"), indexed("ω", "o"))),
        (2, -15.0, bold("h")),
        (3, 60.0, format!("{}, {} mirrored", bold("r"), bold("l"))),
    ] {
        d.arrow(series, foot, polar(foot, degrees, 165.0));
        let anchor = if degrees < 0.0 { "end" } else { "start" };
        d.text(series, anchor, polar(foot, degrees, 173.0) + vec2(0.0, 2.0), &name);
    }
    d.angle(2, foot, [-15.0, 0.0], 120.0);
    d.text(2, "middle", polar(foot, -7.5, 130.0), "α");
    d.angle(3, foot, [30.0, 60.0], 120.0);
    d.text(3, "middle", polar(foot, 45.0, 136.0) + vec2(0.0, 4.0), "2α");
    d.finish()
}
