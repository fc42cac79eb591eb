//! Drawings of the derivations. Nothing in them is measured.

use glam::{Vec2, vec2};

use crate::diagram::Diagram;
use crate::figures::Drawing;

/// The planes of the box in `slabs`: x from 180 to 330, y from 80 to 190.
const X: [f32; 2] = [180.0, 330.0];
const Y: [f32; 2] = [190.0, 80.0];

/// Two rays, a box, and when each ray is inside of which slab.
pub(super) fn slabs() -> Drawing {
    let mut d = Diagram::new(
        452,
        "Two rays and a box that is the crossing of an upright and a level slab. Below them, the \
         stretches in which each ray is inside each slab: those of the first ray overlap, those of \
         the second do not.",
    );
    d.path(1, 1.5, "6 4", "M180 20V310M330 20V310");
    d.path(2, 1.5, "6 4", "M20 80H660M20 190H660");
    d.text(1, "middle", [255.0, 34.0], "slab in x");
    d.text(2, "start", [24.0, 140.0], "slab in y");
    d.boxed(0, 0.12, [180.0, 80.0], [150.0, 110.0]);
    let rays = [
        (3, vec2(40.0, 230.0), vec2(480.0, 40.0), 345.0, "first ray"),
        (4, vec2(120.0, 300.0), vec2(640.0, 66.0), 405.0, "second ray"),
    ];
    for (series, from, to, bars, name) in rays {
        d.arrow(series, from, to);
        d.dot(series, from);
        let slope = (to.y - from.y) / (to.x - from.x);
        let at_x = X.map(|x| vec2(x, from.y + slope * (x - from.x)));
        let at_y = Y.map(|y| vec2(from.x + (y - from.y) / slope, y));
        for (p, q) in at_x.into_iter().zip(at_y) {
            d.dot(1, p).dot(2, q);
        }
        d.text(series, "start", [20.0, bars + 13.0], name);
        d.path(1, 7.0, "none", &format!("M{:.1} {bars}H{:.1}", at_x[0].x, at_x[1].x));
        let y = bars + 16.0;
        d.path(2, 7.0, "none", &format!("M{:.1} {y}H{:.1}", at_y[0].x, at_y[1].x));
        let (enter, leave) = (at_x[0].x.max(at_y[0].x), at_x[1].x.min(at_y[1].x));
        if enter <= leave {
            let top = bars - 9.0;
            d.boxed(0, 0.12, [enter, top], [leave - enter, 34.0]);
        }
    }
    d.text(3, "start", [400.0, 358.0], "inside both: hit");
    d.text(4, "end", [350.0, 428.0], "never inside both: miss");
    d.finish()
}

/// The part of a convex polygon where n · p ≤ bound.
fn cut(polygon: &[Vec2], n: Vec2, bound: f32) -> Vec<Vec2> {
    let mut kept = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (a, b) = (n.dot(p) - bound, n.dot(q) - bound);
        if a <= 0.0 {
            kept.push(p);
        }
        if (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) {
            kept.push(p.lerp(q, a / (a - b)));
        }
    }
    kept
}

/// The intersection of the slabs along `directions` that enclose `points`.
fn enclosure(points: &[Vec2], directions: &[Vec2]) -> Vec<Vec2> {
    let far = 1000.0;
    let mut polygon = vec![vec2(-far, -far), vec2(far, -far), vec2(far, far), vec2(-far, far)];
    for &n in directions {
        for n in [n, -n] {
            let bound = points.iter().map(|p| n.dot(*p)).fold(f32::NEG_INFINITY, f32::max);
            polygon = cut(&polygon, n, bound);
        }
    }
    polygon
}

/// The same shape in a box along the axes, a box of its own and a polytope with eight sides.
pub(super) fn volumes() -> Drawing {
    let mut d = Diagram::new(
        236,
        "A slanted quadrilateral three times: in a box along the axes with much empty space, in a \
         turned box that fits closely, and in an octagon.",
    );
    let shape = [vec2(38.0, 158.0), vec2(60.0, 176.0), vec2(196.0, 58.0), vec2(168.0, 34.0)];
    let along = (shape[2] - shape[1]).normalize();
    let axes = [Vec2::X, Vec2::Y];
    let octagon = [Vec2::X, Vec2::Y, vec2(1.0, 1.0), vec2(1.0, -1.0)];
    let kinds: [(u32, &[Vec2], &str); 3] = [
        (1, &axes, "AABB"),
        (2, &[along, along.perp()], "OBB"),
        (3, &octagon, "k-DOP, here k = 8"),
    ];
    for (i, (series, directions, name)) in kinds.into_iter().enumerate() {
        let shift = vec2(228.0 * i as f32, 0.0);
        let moved = |points: &[Vec2]| points.iter().map(|p| *p + shift).collect::<Vec<_>>();
        d.polygon(series, 0.12, &moved(&enclosure(&shape, directions)));
        d.polygon(0, 0.35, &moved(&shape));
        d.text(series, "middle", [112.0 + shift.x, 222.0], name);
    }
    d.finish()
}

/// Boxes in boxes, the binary tree that they are, and the same with four children.
pub(super) fn tree() -> Drawing {
    let mut d = Diagram::new(
        352,
        "On the left triangles in boxes within boxes, crossed by a ray that enters B and in it F. \
         On the right two trees of these boxes. In the first, A and B are below the root, C and D \
         below A, E and F below B. In the second, C, D, E and F are below the root. The ways from \
         the root to F are marked.",
    );
    let leaves = [
        ("C", [34.0, 60.0], [90.0, 70.0]),
        ("D", [52.0, 160.0], [82.0, 96.0]),
        ("E", [220.0, 54.0], [92.0, 80.0]),
        ("F", [196.0, 180.0], [110.0, 84.0]),
    ];
    d.boxed(1, 0.06, [28.0, 44.0], [114.0, 220.0]);
    d.text(1, "start", [32.0, 258.0], "A");
    d.boxed(2, 0.06, [186.0, 44.0], [136.0, 228.0]);
    d.text(2, "end", [318.0, 168.0], "B");
    for (name, [x, y], [w, h]) in leaves {
        d.boxed(3, 0.06, [x, y], [w, h]);
        d.text(3, "start", [x + 4.0, y + 16.0], name);
        let corner = |a: f32, b: f32| vec2(x + a * w, y + b * h);
        d.polygon(0, 0.35, &[corner(0.0, 0.9), corner(0.5, 0.0), corner(0.6, 0.7)]);
        d.polygon(0, 0.35, &[corner(0.55, 1.0), corner(0.75, 0.2), corner(1.0, 0.8)]);
    }
    d.arrow(4, vec2(160.0, 306.0), vec2(318.0, 188.0));
    d.text(4, "end", [154.0, 308.0], "ray");

    // Names, places and parents; series 4 is the way of the ray.
    let binary = [
        (4, "", vec2(510.0, 34.0), 0),
        (0, "A", vec2(440.0, 96.0), 0),
        (4, "B", vec2(580.0, 96.0), 0),
        (0, "C", vec2(405.0, 158.0), 1),
        (0, "D", vec2(475.0, 158.0), 1),
        (0, "E", vec2(545.0, 158.0), 2),
        (4, "F", vec2(615.0, 158.0), 2),
    ];
    let four = [
        (4, "", vec2(510.0, 244.0), 0),
        (0, "C", vec2(405.0, 306.0), 0),
        (0, "D", vec2(475.0, 306.0), 0),
        (0, "E", vec2(545.0, 306.0), 0),
        (4, "F", vec2(615.0, 306.0), 0),
    ];
    for nodes in [&binary[..], &four[..]] {
        for &(series, name, p, parent) in nodes {
            if p != nodes[parent].2 {
                let [from, to] = [nodes[parent].2 + vec2(0.0, 14.0), p - vec2(0.0, 14.0)];
                let dashes = if series == 4 { "none" } else { "4 4" };
                d.path(series, 1.5, dashes, &format!("M{} {}L{} {}", from.x, from.y, to.x, to.y));
            }
            d.boxed(series, 0.08, [p.x - 20.0, p.y - 14.0], [40.0, 28.0]);
            d.text(series, "middle", [p.x, p.y + 5.0], name);
        }
    }
    d.text(0, "middle", [510.0, 196.0], "two children a node");
    d.text(0, "middle", [510.0, 344.0], "four children a node");
    d.finish()
}
