//! Directions drawn with the stage's two densities, and the frame that turns them.

use glam::{DVec3, Vec2, Vec3, vec2};
use rendering_equation::Frame;
use rendering_equation::directions::{cosine_hemisphere, uniform_hemisphere};
use workbench::Sampler;

use crate::axis::Axis;
use crate::diagram::Diagram;
use crate::figures::Drawing;
use crate::plot::{Plot, Series, Style};

/// From two uniform numbers to a direction.
type Hemisphere = fn([f32; 2]) -> Vec3;

/// The same random numbers as directions of either density, seen from above and from the side.
pub(super) fn densities() -> Drawing {
    let mut d = Diagram::new(
        372,
        "Random directions on the hemisphere, from above and from the side. Uniform ones crowd at \
         the rim when seen from above and are even over the height; those of cosine density fill \
         the disk evenly and crowd near the top.",
    );
    let radius = 120.0;
    let samplers: [(&str, Hemisphere); 2] =
        [("uniform", uniform_hemisphere), ("cosine", cosine_hemisphere)];
    for (i, (name, sample)) in samplers.into_iter().enumerate() {
        let series = 1 + i as u32;
        let x = 170.0 + 340.0 * i as f32;
        let [above, side] = [vec2(x, 136.0), vec2(x, 340.0)];
        d.path(
            0,
            1.0,
            "none",
            &format!(
                "M{} {}a{radius} {radius} 0 1 0 {} 0a{radius} {radius} 0 1 0 -{} 0z",
                above.x - radius,
                above.y,
                2.0 * radius,
                2.0 * radius
            ),
        );
        // Seen from the side, half as large.
        let half = 0.5 * radius;
        d.path(
            0,
            1.0,
            "none",
            &format!("M{} {}a{half} {half} 0 0 1 {radius} 0z", side.x - half, side.y),
        );
        for sample_number in 0..400 {
            let mut sampler = Sampler::new(0, 0, sample_number);
            let w = sample(sampler.next_2d());
            d.spot(series, 1.5, above + radius * Vec2::new(w.x, -w.y));
            d.spot(series, 1.5, side + half * Vec2::new(w.x, -w.z));
        }
        d.text(series, "middle", [x, 366.0], name);
    }
    d.finish()
}

// ANCHOR: unsigned
/// The frame without the sign: s = 1 always.
pub(super) fn unsigned(n: Vec3) -> Frame {
    let a = -1.0 / (1.0 + n.z);
    let b = n.x * n.y * a;
    let tangent = Vec3::new(1.0 + n.x * n.x * a, b, -n.x);
    Frame { tangent, bitangent: Vec3::new(b, 1.0 + n.y * n.y * a, -n.y), normal: n }
}
// ANCHOR_END: unsigned

/// How far the three vectors are from unit length and right angles.
fn error(frame: &Frame) -> f64 {
    let [t, b, n] = [frame.tangent, frame.bitangent, frame.normal].map(|v| v.as_dvec3());
    let errors: [f64; 5] = [t.length() - 1.0, b.length() - 1.0, t.dot(b), t.dot(n), b.dot(n)];
    errors.into_iter().fold(0.0, |worst, error| worst.max(error.abs()))
}

/// The worst error of either frame against the angle between the normal and −z.
pub(super) fn frames() -> Drawing {
    let curve = |name: &str, frame: fn(Vec3) -> Frame| {
        let points = (0..=28).map(|i| {
            let angle = libm::pow(10.0, f64::from(i) / 8.0 - 3.5);
            let worst = (0..400).map(|k| {
                let phi = f64::from(k) * 2.399_963;
                // Angles within a step of the curve.
                let angle = angle * (1.0 + f64::from(k) / 1600.0);
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let n = DVec3::new(sin * libm::cos(phi), sin * libm::sin(phi), -cos).as_vec3();
                error(&frame(n))
            });
            [angle, worst.fold(0.0, f64::max)]
        });
        Series { name: name.to_owned(), points: points.collect(), style: Style::Line }
    };
    Plot {
        description: "Without the sign the error of the frame grows as the normal nears minus z, \
                      up to a tenth and more; with it the error stays at the rounding."
            .to_owned(),
        x: Axis::log("angle between n and −z / radians"),
        y: Axis::log("largest error of the frame"),
        series: vec![curve("s = 1", unsigned), curve("s = ±1", Frame::around)],
    }
    .into()
}
