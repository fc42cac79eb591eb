//! Planes, as quads of two triangles.

use glam::{DVec3, Vec3, vec3};
use ray_casting::math::gamma;
use ray_casting::{Geometry, Ray};
use workbench::Sampler;

use crate::tools::{in_cube, nearest, toward, triangles, ulp};

/// The square |x|, |z| ≤ `half` in the plane y = 0.
fn floor(half: f32) -> Geometry {
    let [a, b, c, d] = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]
        .map(|(x, z)| vec3(half * x, 0.0, half * z));
    triangles(&[[a, b, c], [a, c, d]])
}

/// accuracy P1, P2, P3.
#[test]
fn a_plane_is_hit_from_above_and_neither_along_it_nor_within_it() {
    let t = |o: Vec3, d: Vec3| nearest(&floor(2.0), &Ray::new(o, d)).map(|hit| hit.t);
    assert_eq!(t(Vec3::Y, Vec3::NEG_Y), Some(1.0), "straight down");
    assert_eq!(t(Vec3::Y, Vec3::X), None, "along the plane, above it");
    assert_eq!(t(vec3(-9.0, 0.0, 0.0), Vec3::X), None, "within the plane");
    assert_eq!(t(Vec3::ZERO, vec3(0.6, 0.0, 0.8)), None, "within the plane, from a point of it");
    assert_eq!(t(Vec3::ZERO, Vec3::NEG_Y), None, "downwards from a point of it");
}

/// accuracy P4: the sheared vertices are off by γ(6) of the plane's size, and the slope turns that
/// into 1/|cos θ| times as much of t. Where that bound reaches t itself, at a height of a millionth
/// of the plane's size, the plane is not seen any more.
#[test]
fn a_grazing_ray_is_as_accurate_as_its_slope_allows() {
    for k in 1..=5 {
        let length = 10.0_f32.powi(k);
        let direction = vec3(1.0, -1.0 / length, 0.0).normalize();
        let size = 2.0 * length;
        let hit = nearest(&floor(size), &Ray::new(Vec3::Y, direction));
        let exact = -1.0 / f64::from(direction.y);
        let error = hit.map(|hit| (f64::from(hit.t) - exact).abs());
        let bound = f64::from(gamma(6)) * f64::from(size) / f64::from(direction.y).abs();
        assert!(error.is_some_and(|e| e <= bound), "k = {k}: {hit:?} for {exact}, bound {bound:e}");
    }
}

/// accuracy P5: a tilted plane 10⁶ away from the origin, seen from near it.
#[test]
fn a_distant_plane_is_hit_within_its_bound() {
    let normal = DVec3::ONE.normalize();
    let center = (1e6 * normal).as_vec3();
    let (u, v) = (vec3(1.0, -1.0, 0.0), vec3(1.0, 1.0, -2.0));
    let corner = |a: f32, b: f32| center + 2e6 * (a * u + b * v);
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let plane = triangles(&[[a, b, c], [a, c, d]]);
    for i in 0..10_000 {
        let mut sampler = Sampler::new(8, i, 0);
        let origin = 10.0 * in_cube(&mut sampler);
        let ray = toward(origin, center + 5e5 * in_cube(&mut sampler));
        let hit = nearest(&plane, &ray).unwrap_or_else(|| panic!("{ray:?} misses"));
        let [v0, v1, v2] = plane.corners(hit.primitive).map(|v| v.as_dvec3());
        let n = (v1 - v0).cross(v2 - v0).normalize();
        let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let exact = n.dot(v0 - o) / n.dot(d);
        let size =
            [v0, v1, v2].map(|p| (p - o).abs().max_element()).into_iter().fold(0.0, f64::max);
        let bound = f64::from(gamma(6)) * 3.0 * size / n.dot(d).abs() + 0.5 * ulp(hit.t);
        let error = (f64::from(hit.t) - exact).abs();
        assert!(error <= bound, "ray {i}: t = {} for {exact}, bound {bound:e}", hit.t);
    }
}
