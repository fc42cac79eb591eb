//! Rays and planes, which are two triangles: P1 to P6.

use std::cmp::Ordering;

use glam::{DVec3, Vec3};
use ray_casting::{Geometry, Hit, Ray, Scene, SurfacePoint};

use crate::bits::{self, U, gamma, ulp};
use crate::exact;
use crate::random::Random;
use crate::scenes::{nearest, scene, surface, toward, triangles};
use crate::trial::Trial;
use crate::triangle::passes_an_edge;

crate::catalogue! {
    P1 elsewhere "chapters/01-ray-casting/tests/kernels/plane.rs"
        a_plane_is_hit_from_above_and_neither_along_it_nor_within_it;
    P2 elsewhere "chapters/01-ray-casting/tests/kernels/plane.rs"
        a_plane_is_hit_from_above_and_neither_along_it_nor_within_it;
    P3 elsewhere "chapters/01-ray-casting/tests/kernels/plane.rs"
        a_plane_is_hit_from_above_and_neither_along_it_nor_within_it;
    P4 random/1 a_grazing_ray_is_as_accurate_as_its_slope_allows;
    P5 random/1 a_distant_plane_is_hit_within_its_bound;
    P6 random/10 rays_leave_a_plane_on_their_side_and_do_not_meet_it;
}

/// The square with this centre, and ± `u` ± `v` from there to its corners.
fn square(center: DVec3, u: DVec3, v: DVec3) -> Geometry {
    let [a, b, c, d] =
        [center - u - v, center + u - v, center + u + v, center - u + v].map(|p| p.as_vec3());
    triangles(&[[a, b, c], [a, c, d]])
}

/// A square of 1 to 10³ times the way t of a ray, which starts at a height of 10⁻⁴ to 10⁴ and comes
/// down by 10⁻¹ to 10⁻⁶ of its length. Half of the squares lie in y = 0, the others in any plane
/// (unless the roundings of their corners could be as large as the height).
fn grazed_floor(random: &mut Random) -> (Geometry, Ray) {
    let (height, slope) = (random.magnitude(-4.0, 4.0), random.magnitude(-6.0, -1.0));
    let way = height / slope;
    let half = way * random.magnitude(0.5, 3.0);
    let (mut u, mut n, mut v) = (DVec3::X, DVec3::Y, DVec3::Z);
    if height > 64.0 * U * half && random.below(2) == 0 {
        n = random.direction();
        (u, v) = n.any_orthonormal_pair();
    }
    let (sin, cos) = libm::sincos(random.between(0.0, std::f64::consts::TAU));
    let direction = (cos * u - slope * n + sin * v).normalize().as_vec3();
    let beside = 0.9 * way * (random.unit() * u + random.unit() * v);
    let floor = square(DVec3::ZERO, half * u, half * v);
    (floor, Ray::new((beside + height * n).as_vec3(), direction))
}

/// A square 4·10⁶ wide at 10⁶ from the origin, tilted in any way, and a ray from near the origin to
/// a point of it.
fn tilted_plane(random: &mut Random) -> Option<(Geometry, Ray)> {
    let normal = if random.below(4) == 0 { DVec3::ONE.normalize() } else { random.direction() };
    let (u, v) = normal.any_orthonormal_pair();
    let center = 1e6 * normal;
    let plane = square(center, 2e6 * u, 2e6 * v);
    let target = center + 1.8e6 * (random.between(-1.0, 1.0) * u + random.between(-1.0, 1.0) * v);
    let origin = random.magnitude(-2.0, 5.9) * random.direction();
    Some((plane, toward(origin.as_vec3(), target.as_vec3())?))
}

/// How far the t of a hit may be off: the vertices are moved by γ(1) S along the ray's longest axis
/// z and by γ(6) S across, where S is the largest component of a vertex seen from the origin. The
/// plane through them then moves, along the ray, by
///
/// ```text
/// γ(1) S / |d_z| + γ(6) S (|n_x| + |n_y|) / |n·d|
/// ```
///
/// and t is rounded once more. This is the catalogue's "one cancellation over n·d", with S in place
/// of |o| and |δ|: the plane is known by its corners.
fn bound(ray: &Ray, [v0, v1, v2]: [DVec3; 3], n: DVec3, t: f64) -> f64 {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let size = [v0, v1, v2].map(|v| (v - o).abs().max_element()).into_iter().fold(0.0, f64::max);
    let longest = d.abs().max_position();
    let across = n.abs().element_sum() - n[longest].abs();
    let moved = gamma(1) / d[longest].abs() + gamma(6) * across / n.dot(d).abs();
    // The slopes are those of the rounded plane: another share as large as the bound is of t.
    let moved = moved * size;
    moved * (1.0 + moved / t) + 0.5 * ulp(t as f32)
}

/// The error of t, in its bound, for the triangle that is hit.
fn check(trial: &mut Trial, plane: &Geometry, ray: &Ray) {
    let named = || format!("{}\non {:?}", bits::ray(ray), plane.vertices);
    let Some(hit) = nearest(plane, ray) else { return trial.require(false, named) };
    let corners = plane.corners(hit.primitive).map(|v| v.as_dvec3());
    let n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let exact = n.dot(corners[0] - o) / n.dot(d);
    let error = (f64::from(hit.t) - exact).abs();
    trial.within(error / bound(ray, corners, n, exact), 1.0, named);
}

/// Slopes of 10⁻¹ to 10⁻⁶, planes of 10¹ to 10¹³ times the height: the error in its bound.
fn a_grazing_ray_is_as_accurate_as_its_slope_allows(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let (plane, ray) = grazed_floor(&mut trial.random);
        check(trial, &plane, &ray);
    }
}

/// Planes at 10⁶, seen from 10⁻² to 8·10⁵ beside the origin: the error in its bound.
fn a_distant_plane_is_hit_within_its_bound(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let Some((plane, ray)) = tilted_plane(&mut trial.random) else { continue };
        check(trial, &plane, &ray);
    }
}

/// Spawned rays for each hit.
const PER_HIT: u64 = 16;

/// From hits of the two kinds above: a spawned ray starts on the side of the exact plane to which
/// it leads (or on it), unless it leads to neither by γ(8); it never meets its own triangle again,
/// and the other half of the square only where that is right: rounding has bent the square a
/// little, so that one half stands in the way of rays that graze the other, or shows them its edge.
fn rays_leave_a_plane_on_their_side_and_do_not_meet_it(trial: &mut Trial) {
    for i in 0..trial.rays.div_ceil(PER_HIT) {
        let random = &mut trial.random;
        let case = if i % 2 == 0 { Some(grazed_floor(random)) } else { tilted_plane(random) };
        let Some((plane, ray)) = case else { continue };
        let scene = scene(plane);
        let Some(surface) = surface(&scene, &ray) else { continue };
        let [x, y, z] = exact::normal(scene.geometry.corners(surface.hit.primitive));
        let n = DVec3::new(x.value(), y.value(), z.value()).normalize();
        for i in 0..PER_HIT {
            let mut direction = trial.random.direction();
            if i % 2 == 0 {
                let slope = trial.random.magnitude(-8.0, -1.0) * (i as f64 - 7.5).signum();
                direction = (direction - direction.dot(n) * n + slope * n).normalize();
            }
            leave(trial, &scene, &surface, n, direction.as_vec3());
        }
    }
}

/// One such ray, from a triangle with the normal `n`.
fn leave(trial: &mut Trial, scene: &Scene, surface: &SurfacePoint, n: DVec3, direction: Vec3) {
    let (geometry, own) = (&scene.geometry, surface.hit.primitive);
    let next = surface.spawn(direction);
    let d = next.direction.as_dvec3();
    let is_along = n.dot(d).abs() <= gamma(8) * n.abs().dot(d.abs());
    let [side, leads] = sides(geometry.corners(own), &next);
    let again = nearest(geometry, &next);
    let is_right = |hit: Hit| {
        let corners = geometry.corners(hit.primitive);
        let [side, leads] = sides(corners, &next);
        let is_ahead = side.is_ne() && side == leads.reverse();
        hit.primitive != own && (is_ahead || passes_an_edge(&next, corners))
    };
    let holds = (is_along || side != leads.reverse()) && again.is_none_or(is_right);
    trial.require(holds, || {
        let (ray, vertices) = (bits::ray(&next), &geometry.vertices);
        let there = again.map(|hit| sides(geometry.corners(hit.primitive), &next));
        format!(
            "from {own}, starts {side:?}, leads {leads:?}, meets {again:?}, {there:?}: {ray}\n\
             on {vertices:?}"
        )
    });
}

/// On which side of a triangle's exact plane the ray starts, and to which it leads.
fn sides(corners: [Vec3; 3], ray: &Ray) -> [Ordering; 2] {
    let normal = exact::normal(corners);
    [exact::difference(ray.origin, corners[0]), exact::vector(ray.direction)]
        .map(|v| exact::dot(&normal, &v).sign())
}
