//! Needles, whose edges are decided exactly: T7.

use std::cmp::Ordering;

use glam::DVec3;
use ray_casting::Ray;

use super::seen::Seen;
use super::{intersect, named};
use crate::random::Random;
use crate::scenes::toward;
use crate::trial::Trial;

/// Two facts, each for half of the rays: where nothing has to be rounded the answer is that of
/// integers, and elsewhere it is that of exact arithmetic unless the ray passes an edge within the
/// rounding of the vertices.
pub(super) fn the_edges_of_needles_are_decided_exactly(trial: &mut Trial) {
    for i in 0..trial.rays {
        if i % 2 == 0 {
            decide_on_a_grid(trial);
        } else {
            decide_anywhere(trial);
        }
    }
}

/// Coordinates are integers below 2¹⁹, the direction is (p, q, ±4) with |p|, |q| ≤ 4 in some order:
/// differences, shear and sheared vertices have at most 24 bits, and no rounding occurs before the
/// edges are decided. The needle's middle corner is the grid point next to its long edge, at a
/// third of a unit from it: an aspect of 10⁶. The ray passes through a grid point at or beside that
/// edge.
///
/// A hit is expected just if the three integers U, V, W have no two signs, their sum is not 0, and
/// the plane lies ahead. (They are below 2⁴⁶, so doubles are integers here.) An origin next to the
/// plane is the matter of T15 and left out.
fn decide_on_a_grid(trial: &mut Trial) {
    const REACH: f64 = 262_144.0;
    let random = &mut trial.random;
    let whole = |random: &mut Random, end: f64| random.between(-end - 0.5, end + 0.5).round();
    let step = |random: &mut Random| DVec3::from_array([(); 3].map(|()| whole(random, 1.0)));
    let [a, b] = [(); 2].map(|()| (REACH * random.in_cube()).round());
    let c = a.lerp(b, random.unit()).round();
    let beside = a.lerp(b, random.unit()).round() + step(random);
    let target = [beside, a, b, c][(random.below(8) as usize).saturating_sub(4)];
    let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
    let mut d = [whole(random, 4.0), whole(random, 4.0), 4.0 * sign];
    d.rotate_left(random.below(3) as usize);
    let d = DVec3::from_array(d).clamp(DVec3::splat(-4.0), DVec3::splat(4.0));
    let origin = target - (1 + random.below(32_768)) as f64 * d;

    let [va, vb, vc] = [a, b, c].map(|v| v - origin);
    let [u, v, w] = [d.dot(vb.cross(vc)), d.dot(vc.cross(va)), d.dot(va.cross(vb))];
    let inside = u.max(v).max(w) <= 0.0 || u.min(v).min(w) >= 0.0;
    let n = (b - a).cross(c - a);
    let (height, speed) = (n.dot(va), n.dot(d));
    if height != 0.0 && height.abs() < 1e-5 * n.abs().dot(DVec3::splat(REACH)) {
        return;
    }
    let expected = inside && u + v + w != 0.0 && height * speed > 0.0;

    let scale = libm::exp2f(whole(random, 20.0) as f32);
    let place = |p: DVec3| scale * p.as_vec3();
    let corners = [a, b, c].map(place);
    let ray = Ray::new(place(origin), d.as_vec3());
    let hit = intersect(&ray, &corners);
    trial.require(hit.is_some() == expected, || {
        format!("U, V, W = {u}, {v}, {w}, t = {height}/{speed}, {hit:?}: {}", named(&ray, &corners))
    });
}

/// Two needles with a common long edge, aspects of 10³ to 10⁷, rays aimed at it and beside it. Each
/// edge that the ray passes farther away than the vertices are rounded decides as exact arithmetic
/// does; and a ray within all four outer edges by that much hits one of the two.
fn decide_anywhere(trial: &mut Trial) {
    let random = &mut trial.random;
    let scale = random.magnitude(-8.0, 8.0);
    let [a, b] = [(); 2].map(|()| random.in_cube());
    let along = b - a;
    let across = along.cross(random.direction()).normalize_or(DVec3::Z);
    let thin = random.magnitude(-7.0, -3.0) * along.length();
    let [c, d] = [1.0, -1.0].map(|side| a + random.unit() * along + side * thin * across);
    let target = a + random.unit() * along + random.between(-1.2, 1.2) * thin * across;
    let target = if random.below(2) == 0 { target } else { a + random.unit() * along };
    let eye = target + random.magnitude(-2.0, 2.0) * random.direction();
    let place = |p: DVec3| (scale * p).as_vec3();
    let [a, b, c, d] = [a, b, c, d].map(place);
    let Some(ray) = toward(place(eye), place(target)) else { return };

    let [hit_c, hit_d] = [[a, b, c], [b, a, d]].map(|corners| intersect(&ray, &corners).is_some());
    let [sa, sb, sc, sd] = [a, b, c, d].map(|v| Seen::new(&ray, v));
    let [ab, bc, ca] = [sa.side(&sb), sb.side(&sc), sc.side(&sa)];
    let [ad, db] = [sa.side(&sd), sd.side(&sb)];
    let agrees = |hit: bool, sides: [Ordering; 3]| {
        let [left, right] = [Ordering::Greater, Ordering::Less].map(|side| sides.contains(&side));
        let on_edge = sides.contains(&Ordering::Equal);
        if left && right { !hit } else { on_edge || hit }
    };
    let outer = [bc, ca, ad, db];
    let one_side = outer.iter().all(|&side| side == outer[0] && side != Ordering::Equal);
    let holds = agrees(hit_c, [ab, bc, ca])
        && agrees(hit_d, [ab.reverse(), ad, db])
        && (!one_side || hit_c || hit_d);
    trial.require(holds, || {
        let sides = [ab, bc, ca, ad, db];
        format!("{hit_c}, {hit_d} with sides {sides:?}: {}", named(&ray, &[a, b, c, d]))
    });
}
