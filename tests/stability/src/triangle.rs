//! Rays and triangles: T1 to T18.

mod needles;
mod sealed;
mod seen;

use std::cmp::Ordering;

use glam::{DVec3, Vec3};
use ray_casting::{Hit, Ray, Scene, ShearedRay, triangle};

use crate::bits::{self, gamma, ulps};
use crate::exact::{self, Exact};
use crate::random::Random;
use crate::scenes::{nearest, scene, surface, toward, triangles};
use crate::trial::Trial;

use needles::the_edges_of_needles_are_decided_exactly;
use sealed::{
    no_ray_leaves_a_closed_mesh, no_ray_leaves_a_closed_mesh_where_coordinates_are_coarse,
};
use seen::Seen;

crate::catalogue! {
    T1 elsewhere "chapters/01-ray-casting/tests/kernels/triangle.rs"
        weights_distance_normal_and_point_are_right_to_a_few_last_places;
    T2 random/1 no_ray_slips_through_the_diagonal_of_a_parallelogram;
    T3 random/5 no_ray_leaves_a_closed_mesh;
    T4 random/5 no_ray_leaves_a_closed_mesh_where_coordinates_are_coarse;
    T5 elsewhere "chapters/01-ray-casting/tests/scenes/placement.rs"
        a_triangle_without_area_is_dropped;
    T6 random/2 a_point_or_a_segment_is_never_hit;
    T7 random/2 the_edges_of_needles_are_decided_exactly;
    T8 random/1 a_ray_in_the_plane_of_a_triangle_misses;
    T9 random/2 reversing_the_winding_changes_no_bit;
    T10 random/2 every_corner_may_come_first;
    T11 random/1 small_and_distant_triangles_are_hit_in_their_middle;
    T12 elsewhere "chapters/01-ray-casting/tests/kernels/triangle.rs" a_huge_triangle_is_hit_once;
    T13 random/1 no_ray_meets_again_the_triangle_that_it_leaves;
    T14 random/20 the_box_around_a_point_contains_the_exact_point;
    T15 random/20 from_next_to_a_triangle_the_exact_plane_decides;
    T16 random/1 no_hit_is_farther_than_the_farthest_corner;
    T17 elsewhere "chapters/01-ray-casting/tests/kernels/triangle.rs" all_axes_and_signs_are_alike;
    T18 random/1 a_corner_that_is_not_finite_is_never_hit;
}

pub(crate) type Corners = [Vec3; 3];

fn intersect(ray: &Ray, corners: &Corners) -> Option<Hit> {
    triangle::intersect(&ShearedRay::new(ray), corners, 0)
}

fn named(ray: &Ray, corners: &[Vec3]) -> String {
    let corners: Vec<String> = corners.iter().map(|&v| bits::vec3(v)).collect();
    format!("{}\non [{}]", bits::ray(ray), corners.join(", "))
}

/// A point whose coordinates have any sign and a magnitude of 10⁻⁸ to 10⁸ each.
fn anywhere(random: &mut Random) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| {
        let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
        (sign * random.magnitude(-8.0, 8.0)) as f32
    }))
}

/// A triangle of some kind and scale, and a ray aimed at a point of its plane, near or in it: round
/// ones and needles, seen from near and far, half of them along the plane, and half of those
/// almost.
pub(crate) fn some_case(random: &mut Random) -> Option<(Corners, Ray)> {
    let scale = random.magnitude(-8.0, 8.0);
    let offset = random.magnitude(-2.0, 3.0) * random.direction();
    let [a, mut b, c] = [(); 3].map(|()| random.in_cube());
    if random.below(2) == 0 {
        let s = random.unit();
        b = a + s * (c - a) + random.magnitude(-6.0, -1.0) * random.direction();
    }
    let (b1, b2) = (random.between(-0.25, 1.25), random.between(-0.25, 1.25));
    let target = a + b1 * (b - a) + b2 * (c - a);
    let n = (b - a).cross(c - a).normalize_or(DVec3::Z);
    let mut view = random.direction();
    if random.below(2) == 0 {
        view = (view - view.dot(n) * n).normalize_or(n.any_orthonormal_vector())
            + random.magnitude(-8.0, -1.0) * n;
    }
    let eye = target + random.magnitude(-2.0, 3.0) * view;
    let place = |p: DVec3| (scale * (offset + p)).as_vec3();
    let ray = toward(place(eye), place(target))?;
    Some(([a, b, c].map(place), ray))
}

/// A parallelogram a, b, c, d of any scale and pose, and a ray aimed at a point of the diagonal
/// a-c: one of its triangles is hit.
fn no_ray_slips_through_the_diagonal_of_a_parallelogram(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let scale = random.magnitude(-8.0, 8.0);
        let [a, u, v] = [(); 3].map(|()| random.in_cube());
        let n = u.cross(v);
        if n.length() < 0.1 {
            continue;
        }
        let target = a + random.between(0.05, 0.95) * (u + v);
        let view = random.direction();
        if view.dot(n).abs() < 0.1 * n.length() {
            continue;
        }
        let eye = target + random.magnitude(-1.0, 3.0) * view;
        let place = |p: DVec3| (scale * p).as_vec3();
        let [a, b, c, d] = [a, a + u, a + u + v, a + v].map(place);
        let Some(ray) = toward(place(eye), place(target)) else { continue };
        let hits = [[a, b, c], [a, c, d]].map(|corners| intersect(&ray, &corners));
        trial.require(hits.iter().any(Option::is_some), || named(&ray, &[a, b, c, d]));
    }
}

/// Two or three equal corners, each coordinate 10⁻⁸ to 10⁸, rays aimed at what is left of them.
fn a_point_or_a_segment_is_never_hit(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let [a, b, eye] = [(); 3].map(|()| anywhere(random));
        let between = a.as_dvec3().lerp(b.as_dvec3(), random.unit()).as_vec3();
        let target = [a, b, between][random.below(3) as usize];
        let Some(ray) = toward(eye, target) else { continue };
        for corners in [[a, a, a], [a, a, b], [a, b, a], [b, a, a]] {
            trial.require(intersect(&ray, &corners).is_none(), || named(&ray, &corners));
        }
    }
}

/// Planes in which no rounding leads out: x = const, and x = ±y, for all axes and 16 decades.
fn a_ray_in_the_plane_of_a_triangle_misses(trial: &mut Trial) {
    for i in 0..trial.rays {
        let random = &mut trial.random;
        let [x, y] = [i % 3, (i + 1) % 3].map(|axis| axis as usize);
        let (kind, level) = (random.below(3), anywhere(random).x);
        let flat = |mut p: Vec3, level: f32| {
            p[x] = [level, p[y], -p[y]][kind as usize];
            p
        };
        let scale = random.magnitude(-8.0, 8.0);
        let mut point = || flat((scale * random.in_cube()).as_vec3(), level);
        let (corners, origin, target) = ([point(), point(), point()], point(), point());
        let direction = random.in_cube().as_vec3();
        let aimed = (target - origin).normalize_or_zero();
        for direction in [flat(direction, 0.0), flat(aimed, 0.0)] {
            let ray = Ray::new(origin, direction);
            trial.require(intersect(&ray, &corners).is_none(), || named(&ray, &corners));
        }
    }
}

/// a, c, b instead of a, b, c: the same answer, the same bits of t, the same weights exchanged, and
/// the opposite normal.
fn reversing_the_winding_changes_no_bit(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let Some((corners, ray)) = some_case(&mut trial.random) else { continue };
        let [a, b, c] = corners;
        let (hit, other) = (intersect(&ray, &corners), intersect(&ray, &[a, c, b]));
        let swapped = hit.map(|hit| (hit.t.to_bits(), hit.barycentric.y, hit.barycentric.x));
        let other = other.map(|hit| (hit.t.to_bits(), hit.barycentric.x, hit.barycentric.y));
        let same_normal = || {
            let [one, other] = [corners, [a, c, b]]
                .map(|corners| surface(&scene(triangles(&[corners])), &ray))
                .map(|surface| surface.map(|surface| surface.geometric_normal));
            other.is_some_and(|n| one.is_none_or(|m| m.to_array() == (-n).to_array()))
        };
        let same = swapped == other && (hit.is_none() || same_normal());
        trial.require(same, || format!("{hit:?} and {other:?}: {}", named(&ray, &corners)));
    }
}

/// b, c, a and c, a, b: the same answer, and t within 2 ULP. Error in those.
fn every_corner_may_come_first(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let Some((corners, ray)) = some_case(&mut trial.random) else { continue };
        let hit = intersect(&ray, &corners);
        let mut turned = corners;
        for _ in 0..2 {
            turned.rotate_left(1);
            let other = intersect(&ray, &turned);
            let error = match (hit, other) {
                (None, None) => 0.0,
                (Some(one), Some(two)) => ulps(one.t, f64::from(two.t)),
                _ => f64::INFINITY,
            };
            trial.within(error, 2.0, || format!("{hit:?}, {other:?}: {}", named(&ray, &corners)));
        }
    }
}

/// An equilateral triangle around the origin, 1 to 10⁻⁴ wide, seen head on or up to 85° aside from
/// 1 to 10⁴ away: its middle is hit as long as it looks large enough.
///
/// Rounding moves a vertex by up to γ(6) √2 of the distance D, and direction and target move the
/// ray by another 2 u D; so a circle of 11 u D around the middle has to be visible. (The catalogue
/// asks for an edge of 8 u D, of which that circle is ¼ at best: of such triangles, up to 70°
/// aside, one in 600 000 is lost.)
fn small_and_distant_triangles_are_hit_in_their_middle(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let distance = random.magnitude(0.0, 4.0);
        let (n, spin, view) = (random.direction(), random.direction(), random.direction());
        let cos_theta = view.dot(n).abs();
        // The circle inside of an edge e has the radius e / √12.
        let least = 11.0 * bits::U * distance * 12.0_f64.sqrt() / cos_theta;
        let edge = if random.below(2) == 0 { least } else { random.magnitude(-4.0, 0.0) };
        if edge < least || cos_theta < 0.087 {
            continue;
        }
        let x = n.cross(spin).normalize();
        let y = n.cross(x);
        let circumradius = edge / 3.0_f64.sqrt();
        let corners = [(1.0, 0.0), (-0.5, 0.75_f64.sqrt()), (-0.5, -0.75_f64.sqrt())]
            .map(|(a, b)| (circumradius * (a * x + b * y)).as_vec3());
        let middle = corners.iter().map(|v| v.as_dvec3()).sum::<DVec3>() / 3.0;
        let Some(ray) = toward((distance * view).as_vec3(), middle.as_vec3()) else { continue };
        trial.require(intersect(&ray, &corners).is_some(), || {
            format!("{edge:e} at {distance:e}: {}", named(&ray, &corners))
        });
    }
}

/// A triangle each of whose coordinates is 10⁻⁸ to 10⁸ (pbrt-v4, `Triangle, Reintersect`), or all
/// of one scale; and a ray toward a point of it.
fn wild_case(random: &mut Random) -> (Scene, Option<Ray>) {
    let one_scale = random.below(2) == 0;
    let (scale, offset) = (random.magnitude(-8.0, 8.0), random.magnitude(-2.0, 3.0));
    let offset = offset * random.direction();
    let point = |random: &mut Random| {
        if one_scale { (scale * (offset + random.in_cube())).as_vec3() } else { anywhere(random) }
    };
    let corners = [(); 3].map(|()| point(random));
    let [a, b, c] = corners.map(|v| v.as_dvec3());
    let (mut b1, mut b2) = (random.unit(), random.unit());
    if b1 + b2 > 1.0 {
        (b1, b2) = (1.0 - b1, 1.0 - b2);
    }
    let target = a + b1 * (b - a) + b2 * (c - a);
    (scene(triangles(&[corners])), toward(point(random), target.as_vec3()))
}

/// Spawned rays for each hit.
const PER_HIT: u64 = 16;

/// Triangles of 16 decades, in every coordinate by itself: no ray that leaves one meets it again,
/// be it in any direction, almost along the triangle, or toward a point.
fn no_ray_meets_again_the_triangle_that_it_leaves(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_HIT) {
        let (scene, ray) = wild_case(&mut trial.random);
        let Some(surface) = ray.and_then(|ray| surface(&scene, &ray)) else { continue };
        let n = surface.geometric_normal.as_dvec3();
        for i in 0..PER_HIT {
            let random = &mut trial.random;
            let direction = random.direction();
            let along = (direction - direction.dot(n) * n).normalize_or(n.any_orthonormal_vector());
            let next =
                match i % 4 {
                    0 => surface.spawn(direction.as_vec3()),
                    1 => surface
                        .spawn((along + random.magnitude(-8.0, -1.0) * n).normalize().as_vec3()),
                    2 => surface
                        .spawn((along - random.magnitude(-8.0, -1.0) * n).normalize().as_vec3()),
                    _ => surface.spawn_to(anywhere(random)),
                };
            let again = nearest(&scene.geometry, &next);
            trial.require(again.is_none(), || {
                format!("{again:?}: {}", named(&next, &scene.geometry.vertices))
            });
        }
    }
}

/// The exact point with the weights of a hit, b₁ and b₂ as they are and b₀ = 1 − b₁ − b₂, lies in
/// the box around the position; and the box is no larger than γ(7) Σ |bᵢ vᵢ|, but for 2⁻⁴⁷ of the
/// numbers that went into it. Error in widths of the box.
fn the_box_around_a_point_contains_the_exact_point(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let (scene, ray) = wild_case(&mut trial.random);
        let Some(surface) = ray.and_then(|ray| surface(&scene, &ray)) else { continue };
        let corners = scene.geometry.corners(0);
        let b = surface.hit.barycentric;
        let [e1, e2] = [1, 2].map(|i| exact::difference(corners[i], corners[0]));
        let weights = [1.0 - f64::from(b.x) - f64::from(b.y), f64::from(b.x), f64::from(b.y)];
        for axis in 0..3 {
            let along = &(&Exact::from(b.x) * &e1[axis]) + &(&Exact::from(b.y) * &e2[axis]);
            let point = &Exact::from(corners[0][axis]) + &along;
            let error = (&Exact::from(surface.position[axis]) - &point).value().abs();
            let reach = f64::from(surface.position_error[axis]);
            let [v0, v1, v2] = corners.map(|v| f64::from(v[axis]).abs());
            let terms = weights[0].abs() * v0 + weights[1].abs() * v1 + weights[2].abs() * v2;
            let bound = gamma(7) * terms + 2.0_f64.powi(-47) * (v0 + v1 + v2 + v0 + v0);
            let share = if reach <= bound { error / reach } else { f64::INFINITY };
            trial.within(share, 1.0, || {
                format!(
                    "axis {axis}, off by {error:e}, box {reach:e}, bound {bound:e}: {surface:?}"
                )
            });
        }
    }
}

/// Origins at a point of a triangle as far as floats can say, in every direction, half of them
/// almost along the triangle. The test has no δt below which a hit would not count; instead
///
/// - a ray whose exact t is 0 or less, or which runs parallel, misses, and
/// - one whose exact t is more hits, if the edges do not decide otherwise (see T7),
///
/// whatever t came out of rounded vertices. Two exceptions: an exact distance below 2⁻⁴⁸ of the
/// size is zero as far as `settle` can see; and a ray that runs along the triangle (N·d is zero up
/// to γ(8), the origin on it up to γ(8)) may miss.
fn from_next_to_a_triangle_the_exact_plane_decides(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let Some((corners, ray)) = beside_a_triangle(&mut trial.random) else { continue };
        let n = exact::normal(corners);
        let height = exact::dot(&n, &exact::difference(corners[0], ray.origin));
        let speed = exact::dot(&n, &exact::vector(ray.direction));
        let (h, s) = (height.value(), speed.value());
        let abs = DVec3::from_array([0, 1, 2].map(|i| n[i].value().abs()));
        let sum = corners.iter().fold(ray.origin.abs(), |sum, v| sum + v.abs()).as_dvec3();
        let [d, o] = [ray.direction, ray.origin].map(|v| v.abs().as_dvec3());
        let unseen = h != 0.0 && h.abs() <= 2.0_f64.powi(-48) * abs.dot(sum);
        let runs_along = s.abs() <= 1.001 * gamma(8) * abs.dot(d)
            && h.abs() <= 1.001 * gamma(8) * abs.dot(o) + 1e-13 * abs.dot(sum);
        if unseen {
            continue;
        }
        let hit = intersect(&ray, &corners);
        let is_ahead = height.sign() == speed.sign() && height.sign() != Ordering::Equal;
        let holds = match hit {
            Some(_) => is_ahead,
            None => !is_ahead || runs_along || !surely_inside(&ray, corners),
        };
        trial.require(holds, || format!("exact t {h:e}/{s:e}, {hit:?}: {}", named(&ray, &corners)));
    }
}

/// A triangle, and a ray from within 8 floats of a point of it.
pub(crate) fn beside_a_triangle(random: &mut Random) -> Option<(Corners, Ray)> {
    let scale = random.magnitude(-8.0, 8.0);
    let offset = random.magnitude(-2.0, 2.0) * random.direction();
    let [a, b, c] = [(); 3].map(|()| offset + random.in_cube());
    let n = (b - a).cross(c - a);
    if n.length() < 0.1 {
        return None;
    }
    let n = n.normalize();
    let (b1, b2) = (random.between(0.1, 0.45), random.between(0.1, 0.45));
    let mut origin = (scale * (a + b1 * (b - a) + b2 * (c - a))).as_vec3();
    for _ in 0..random.below(8) {
        origin = random.beside_point(origin);
    }
    let mut direction = random.direction();
    if random.below(2) == 0 {
        let side = if random.below(2) == 0 { 1.0 } else { -1.0 };
        direction = direction - direction.dot(n) * n + side * random.magnitude(-7.0, -1.0) * n;
    }
    let ray = Ray::new(origin, direction.normalize_or(n).as_vec3());
    Some(([a, b, c].map(|p| (scale * p).as_vec3()), ray))
}

/// On which side of each edge the ray passes, as far as the roundings of the vertices do not
/// decide.
fn edge_sides(ray: &Ray, corners: Corners) -> [Ordering; 3] {
    let [a, b, c] = corners.map(|v| Seen::new(ray, v));
    [a.side(&b), b.side(&c), c.side(&a)]
}

/// Whether the ray passes all edges on the same side, farther away than the vertices are rounded.
fn surely_inside(ray: &Ray, corners: Corners) -> bool {
    let sides = edge_sides(ray, corners);
    sides[0].is_ne() && sides == [sides[0]; 3]
}

/// Whether it passes one so closely that the roundings of the vertices may decide.
pub(crate) fn passes_an_edge(ray: &Ray, corners: Corners) -> bool {
    edge_sides(ray, corners).contains(&Ordering::Equal)
}

/// Slivers with an aspect of 10 to 10⁷, rays at an angle of 10⁻⁶ to 30° to them (Embree's thread
/// 387 tells of a hit at t = 12291 on a triangle within 600): t ≤ the distance of the farthest
/// corner, to γ(7). Error in γ(7) of that distance, beyond it.
fn no_hit_is_farther_than_the_farthest_corner(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let (start, along) = (random.magnitude(-2.0, 2.0) * random.direction(), random.direction());
        let across = random.magnitude(-7.0, -1.0) * random.direction();
        let corners = [start, start + along, start + random.unit() * along + across];
        let target = start + random.unit() * along + random.between(-0.2, 1.2) * across;
        let view = along + random.magnitude(-6.0, -0.24) * random.direction();
        let eye = target - random.magnitude(-2.0, 2.0) * view;
        let corners = corners.map(|v| v.as_vec3());
        let Some(ray) = toward(eye.as_vec3(), target.as_vec3()) else { continue };
        let Some(hit) = intersect(&ray, &corners) else { continue };
        let farthest = corners.map(|v| v.as_dvec3().distance(ray.origin.as_dvec3()));
        let farthest = farthest.into_iter().fold(0.0, f64::max);
        let error = (f64::from(hit.t) / farthest - 1.0).max(0.0) / gamma(7);
        trial.within(error, 1.0, || format!("{hit:?}: {}", named(&ray, &corners)));
    }
}

/// One coordinate or more is NaN or ±∞, the others are anything at all: never hit. Nor is a
/// triangle of finite numbers hit at a t that is not one.
fn a_corner_that_is_not_finite_is_never_hit(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let any = random.below(2) == 0;
        let point = |random: &mut Random| {
            let wild = [(); 3].map(|()| random.finite());
            if any { Vec3::from_array(wild) } else { random.in_cube().as_vec3() }
        };
        let mut corners = [(); 3].map(|()| point(random));
        let ray = Ray::new(point(random), point(random));
        let hit = intersect(&ray, &corners);
        let sound = hit.is_none_or(|hit| hit.t.is_finite() && hit.t > 0.0);
        trial.require(sound, || format!("{hit:?}: {}", named(&ray, &corners)));
        for _ in 0..=trial.random.below(3) {
            let random = &mut trial.random;
            let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY][random.below(3) as usize];
            corners[random.below(3) as usize][random.below(3) as usize] = bad;
        }
        let axis = Vec3::AXES[trial.random.below(3) as usize];
        for direction in [ray.direction, axis, -axis] {
            let ray = Ray::new(ray.origin, direction);
            trial.require(intersect(&ray, &corners).is_none(), || named(&ray, &corners));
        }
    }
}
