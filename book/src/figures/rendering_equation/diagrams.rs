//! Drawings of the derivations. Nothing in them is measured.

use glam::{Vec2, vec2};

use crate::diagram::{Diagram, bold, indexed, polar};
use crate::figures::Drawing;

/// A patch of surface and its normal, in degrees clockwise from straight up.
struct Patch {
    center: Vec2,
    normal: f32,
    half: f32,
}

impl Patch {
    fn ends(&self) -> [Vec2; 2] {
        [90.0, -90.0].map(|turn| polar(self.center, self.normal + turn, self.half))
    }

    fn draw(&self, d: &mut Diagram, series: u32, length: f32) {
        let [a, b] = self.ends();
        d.line(series, 4.0, "none", a, b);
        d.arrow(0, self.center, polar(self.center, self.normal, length));
    }
}

/// Radiance at a patch, and two patches that see each other.
pub(super) fn radiance() -> Drawing {
    let mut d = Diagram::new(
        236,
        "On the left a patch dA of a surface with its normal, and a narrow cone d omega of \
         directions at the angle theta to it. On the right two tilted patches at distance r; each \
         fills a narrow cone as seen from the other.",
    );
    d.path(0, 1.5, "none", "M30 196H300");
    let patch = Patch { center: vec2(150.0, 196.0), normal: 0.0, half: 34.0 };
    patch.draw(&mut d, 1, 150.0);
    d.text(1, "middle", [150.0, 222.0], "dA");
    d.text(0, "end", [142.0, 60.0], &bold("n"));
    let (foot, theta) = (patch.center, 42.0);
    for side in [-5.0, 5.0] {
        d.line(2, 1.0, "5 4", foot, polar(foot, theta + side, 176.0));
    }
    d.arrow(2, foot, polar(foot, theta, 158.0));
    d.angle(2, foot, [theta - 5.0, theta + 5.0], 170.0);
    d.text(2, "start", polar(foot, theta, 178.0) + vec2(2.0, 4.0), "dω");
    d.angle(0, foot, [0.0, theta], 52.0);
    d.text(0, "middle", polar(foot, 0.5 * theta, 66.0) + vec2(0.0, 4.0), "θ");

    let near = Patch { center: vec2(410.0, 180.0), normal: 26.0, half: 30.0 };
    let far = Patch { center: vec2(614.0, 66.0), normal: 192.0, half: 30.0 };
    d.line(0, 1.0, "5 4", near.center, far.center);
    for end in far.ends() {
        d.line(1, 1.0, "none", near.center, end);
    }
    for end in near.ends() {
        d.line(2, 1.0, "none", far.center, end);
    }
    near.draw(&mut d, 1, 84.0);
    far.draw(&mut d, 2, 84.0);
    d.text(1, "middle", near.center + vec2(-26.0, 24.0), "dA");
    d.text(2, "start", far.center + vec2(10.0, -20.0), "dA′");
    d.angle(1, near.center, [26.0, 60.8], 56.0);
    d.angle(2, far.center, [192.0, 240.8], 50.0);
    d.text(0, "middle", [512.0, 152.0], "r");
    d.text(1, "middle", polar(near.center, 40.0, 70.0), "θ");
    d.text(2, "middle", polar(far.center, 210.0, 66.0) + vec2(0.0, 5.0), "θ′");
    d.finish()
}

/// Light that leaves x″, is scattered at x′ and arrives at x.
pub(super) fn three_points() -> Drawing {
    let mut d = Diagram::new(
        262,
        "Light goes from x'' to x' and from there to x. At each of the three points stands the \
         normal of its surface; the angle between the normal and the way of the light is theta at \
         either end of each way.",
    );
    let x = Patch { center: vec2(120.0, 84.0), normal: 78.0, half: 44.0 };
    let middle = Patch { center: vec2(340.0, 220.0), normal: 0.0, half: 80.0 };
    let source = Patch { center: vec2(570.0, 62.0), normal: 196.0, half: 44.0 };
    for (series, from, to, name, at) in [
        (2, &source, &middle, "I(x′, x″)", vec2(474.0, 164.0)),
        (1, &middle, &x, "I(x, x′)", vec2(222.0, 176.0)),
    ] {
        let along = (to.center - from.center).normalize();
        d.arrow(series, from.center + 8.0 * along, to.center - 8.0 * along);
        d.text(series, "middle", at, name);
    }
    for (patch, name, shift) in [
        (&x, bold("x"), vec2(-22.0, 6.0)),
        (&middle, bold("x′"), vec2(0.0, 28.0)),
        (&source, bold("x″"), vec2(16.0, -10.0)),
    ] {
        patch.draw(&mut d, 0, 92.0);
        d.dot(0, patch.center);
        d.text(0, "middle", patch.center + shift, &name);
    }
    for (series, patch, angles, name) in [
        (1, &x, [78.0, 121.7], indexed("θ", "x")),
        (1, &middle, [-58.3, 0.0], indexed("θ", "x′")),
        (2, &middle, [0.0, 55.5], "θ′".to_owned()),
        (2, &source, [196.0, 235.5], "θ″".to_owned()),
    ] {
        d.angle(series, patch.center, angles, 48.0);
        let [from, to] = angles;
        let place = polar(patch.center, 0.5 * (from + to), 64.0) + vec2(0.0, 5.0);
        d.text(series, "middle", place, &name);
    }
    d.finish()
}
