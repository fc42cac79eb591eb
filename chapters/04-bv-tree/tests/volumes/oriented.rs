//! Oriented boxes: fitted, and around everything.

use bv_tree::{Aabb, BoundingVolume, Obb};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Ray, math};
use workbench::Sampler;

use crate::tools::{Enclosed, in_cube, toward, triangles};

/// The twelve triangles of a box of this `size`, turned about y and moved.
fn turned_box(size: Vec3, angle: f32, center: Vec3) -> Geometry {
    let (sin, cos) = math::sin_cos(angle);
    let corner = |i: u32| {
        let sign = |bit: u32| if i >> bit & 1 == 1 { 0.5 } else { -0.5 };
        let p = size * vec3(sign(0), sign(1), sign(2));
        center + vec3(cos * p.x + sin * p.z, p.y, cos * p.z - sin * p.x)
    };
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Geometry {
        vertices: (0..8).map(corner).collect(),
        triangles: triangles.collect(),
        spheres: Vec::new(),
    }
}

fn check_content(geometry: &Geometry, case: &str) -> Enclosed<Obb> {
    let fitted = Enclosed::<Obb>::all_of(geometry);
    for axis in fitted.volume.axes() {
        let length = axis.as_dvec3().length();
        assert!((length - 1.0).abs() <= 1e-6, "{case}: an axis of length {length}: {axis}");
    }
    for &vertex in &geometry.vertices {
        assert!(
            fitted.volume.contains(vertex),
            "{case}: {vertex} is outside of {fitted:?}",
            fitted = fitted.volume
        );
    }
    fitted
}

/// accuracy O2: a cube on edge is fitted tightly, and met √2/2 before its centre.
#[test]
fn a_turned_cube_is_fitted_tightly() {
    for angle in [0.0, 1e-7, 0.3, std::f32::consts::FRAC_PI_4, 1.2] {
        let cube = turned_box(Vec3::ONE, angle, vec3(3.0, -2.0, 5.0));
        let fitted = check_content(&cube, &format!("turned by {angle}"));
        let area = fitted.volume.surface_area();
        assert!((area - 6.0).abs() <= 1e-4, "turned by {angle}: an area of {area} for 6");
    }
    let cube = turned_box(Vec3::ONE, std::f32::consts::FRAC_PI_4, Vec3::ZERO);
    let fitted = Enclosed::<Obb>::all_of(&cube);
    let inside = fitted.clip(&Ray::new(vec3(0.0, 0.0, -4.0), Vec3::Z));
    let half = 0.5_f32.sqrt();
    for (end, expected) in [(inside.min, 4.0 - half), (inside.max, 4.0 + half)] {
        assert!((end - expected).abs() <= 1e-4, "{inside:?} ends at {end} for {expected}");
    }
    let beside = fitted.clip(&Ray::new(vec3(0.6, 0.0, -4.0), vec3(0.0, 0.0, 1.0)));
    let corner = fitted.clip(&Ray::new(vec3(0.6, 0.0, -4.0), vec3(-0.6, 0.0, 4.0)));
    assert!(!beside.is_empty() && !corner.is_empty(), "rays that meet the cube");
    let aside = fitted.clip(&Ray::new(vec3(0.6, 0.0, -0.6), vec3(1.0, 0.0, 1.0)));
    assert!(aside.is_empty(), "a ray in the corner of the AABB, beside the cube: {aside:?}");
}

/// accuracy O5: a needle's tips.
#[test]
fn a_long_box_is_met_at_its_tips() {
    for angle in [0.0, 0.3, 0.7] {
        let needle = turned_box(vec3(1e6, 1.0, 1.0), angle, vec3(10.0, 20.0, 30.0));
        let fitted = check_content(&needle, &format!("a needle turned by {angle}"));
        for (i, &tip) in needle.vertices.iter().enumerate() {
            let origin = tip + 100.0 * in_cube(&mut Sampler::new(4, i as u64, 0));
            let inside = fitted.clip(&toward(origin, tip));
            let distance = origin.distance(tip);
            assert!(inside.contains(distance), "angle {angle}: {inside:?} for {distance} at {tip}");
        }
    }
}

/// accuracy O6, O7: points, lines, planes and cubes, which leave the frame undetermined.
#[test]
fn degenerate_content_is_enclosed() {
    let (p, d) = (vec3(1.0, 2.0, 3.0), vec3(0.3, -0.2, 0.7));
    let line = |t: f32| p + t * d;
    let plane = |s: f32, t: f32| p + s * d + t * vec3(1.0, 1.0, -0.5);
    let cases = [
        ("a point", triangles(&[[p; 3]])),
        ("the origin", triangles(&[[Vec3::ZERO; 3]])),
        (
            "a line",
            triangles(&[[line(0.0), line(1.0), line(2.0)], [line(5.0), line(5.0), line(7.0)]]),
        ),
        ("a line along x", triangles(&[[Vec3::ZERO, Vec3::X, 2.0 * Vec3::X]])),
        ("a triangle", triangles(&[[plane(0.0, 0.0), plane(1.0, 0.0), plane(0.0, 1.0)]])),
        (
            "a plane",
            triangles(&[
                [plane(0.0, 0.0), plane(1.0, 0.0), plane(0.0, 1.0)],
                [plane(3.0, 0.0), plane(1.0, -2.0), plane(-4.0, 1.0)],
            ]),
        ),
        ("a cube", turned_box(Vec3::ONE, 0.0, p)),
        ("a tiny cube", turned_box(Vec3::splat(1e-20), 0.5, Vec3::ZERO)),
        ("a subnormal triangle", triangles(&[[1e-40 * Vec3::X, 1e-40 * Vec3::Y, 1e-40 * Vec3::Z]])),
        ("a huge triangle", triangles(&[[1e30 * Vec3::X, 1e30 * Vec3::Y, -1e30 * Vec3::Z]])),
    ];
    for (case, geometry) in &cases {
        let fitted = check_content(geometry, case);
        let area = fitted.volume.surface_area();
        assert!(area >= 0.0, "{case}: an area of {area}");
        let [a, b, c] = geometry.corners(0);
        for target in [a, b, c, a.midpoint(b)] {
            let size = fitted.bounds.reach(Vec3::ZERO).clamp(1e-30, 1e30);
            let origin = target + 3.0 * size * vec3(0.1, 0.7, -0.4);
            let ray = toward(origin, target);
            let inside = fitted.clip(&ray);
            assert!(!inside.is_empty(), "{case}: {ray:?} to {target} misses {:?}", fitted.volume);
        }
    }
}

/// The fitted box is never the larger one.
#[test]
fn a_fitted_box_has_at_most_the_area_of_the_axis_aligned_one() {
    for i in 0..2000 {
        let mut sampler = Sampler::new(5, i, 0);
        let stretch = in_cube(&mut sampler);
        let corners: Vec<[Vec3; 3]> =
            (0..6).map(|_| [(); 3].map(|()| stretch * in_cube(&mut sampler))).collect();
        let geometry = triangles(&corners);
        let fitted = check_content(&geometry, &format!("case {i}")).volume.surface_area();
        let aligned = Enclosed::<Aabb>::all_of(&geometry).volume.surface_area();
        assert!(fitted <= aligned * (1.0 + 1e-5), "case {i}: {fitted} instead of {aligned}");
    }
}
