//! Rays and spheres, against double precision.

use glam::{Vec3, vec3};
use ray_casting::sphere::intersect_naive;
use ray_casting::{Geometry, Ray, Sphere};
use workbench::Sampler;

use crate::tools::{direction, magnitude, nearest, scene, sphere, surface, toward, ulp, ulps};

/// accuracy S6: an eye a little above a ground sphere. The oracle's c = (o_y − r)(o_y + r) does not
/// cancel.
#[test]
fn the_ground_sphere_is_hit_to_the_last_place_and_the_school_formula_is_not() {
    let mut naive: f64 = 0.0;
    for exponent in 2..=7 {
        let ground = Sphere { center: Vec3::ZERO, radius: 10.0_f32.powi(exponent) };
        for i in 0..20_000 {
            let mut sampler = Sampler::new(9, i, 0);
            let height = 0.1 + 3.0 * sampler.next_1d();
            let below = (3.0 + 83.0 * sampler.next_1d()).to_radians();
            let ray = Ray::new(
                vec3(0.0, ground.radius + height, 0.0),
                vec3(below.cos(), -below.sin(), 0.0),
            );
            let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
            let r = f64::from(ground.radius);
            let (a, b, c) = (d.dot(d), -o.dot(d), (o.y - r) * (o.y + r));
            let discriminant = b * b - a * c;
            if discriminant < 0.0 || o.y <= r {
                continue;
            }
            let exact = c / (b + discriminant.sqrt());
            let t = ground.intersect(&ray);
            let error = t.map(|t| ulps(t, exact));
            assert!(error.is_some_and(|e| e <= 2.0), "r = {r}, ray {i}: {t:?} for {exact}");
            let school = intersect_naive(&ground, &ray).map_or(1.0, f64::from);
            naive = naive.max((school - exact).abs() / exact);
        }
    }
    assert!(naive > 0.1, "the school formula is only {naive} off, relative to t");
}

/// accuracy S9.
#[test]
fn from_the_centre_every_direction_is_a_radius_away() {
    for i in 0..10_000 {
        let mut sampler = Sampler::new(10, i, 0);
        let center = 100.0 * direction(&mut sampler);
        let radius = magnitude(&mut sampler, -4.0, 4.0);
        let d = magnitude(&mut sampler, -3.0, 3.0) * direction(&mut sampler);
        let t = Sphere { center, radius }.intersect(&Ray::new(center, d));
        let exact = f64::from(radius) / d.as_dvec3().length();
        let error = t.map(|t| (f64::from(t) - exact).abs() / exact);
        let bound = 1.5 * f64::from(f32::EPSILON);
        assert!(error.is_some_and(|e| e <= bound), "r = {radius}: {t:?} for {exact}");
    }
}

/// accuracy S16: points are pulled back onto the sphere, at every size and distance.
#[test]
fn the_point_of_a_hit_lies_on_the_sphere() {
    let mut hits = 0;
    for i in 0..100_000 {
        let mut sampler = Sampler::new(11, i, 0);
        let radius = magnitude(&mut sampler, -4.0, 4.0);
        let center = magnitude(&mut sampler, -8.0, 8.0) * direction(&mut sampler);
        let eye = center + magnitude(&mut sampler, 0.1, 4.0) * radius * direction(&mut sampler);
        let target = center + 0.9 * radius * direction(&mut sampler);
        if !(target - eye).is_normalized() && (target - eye).length() == 0.0 {
            continue;
        }
        let scene = scene(sphere(center, radius));
        let Some(surface) = surface(&scene, &toward(eye, target)) else { continue };
        hits += 1;
        let (c, r) = (center.as_dvec3(), f64::from(radius));
        let error = (surface.position.as_dvec3().distance(c) - r).abs();
        let bound = 2.0 * ulp(radius.max(center.length()));
        assert!(error <= bound, "sphere {i} at {center} of radius {radius}: {error:e} > {bound:e}");
    }
    assert!(hits > 50_000, "only {hits} rays hit");
}

/// accuracy S17: one sphere in another, 4 · 10⁻⁵ apart.
#[test]
fn concentric_spheres_are_hit_in_their_order() {
    let spheres = [1.0, 1.0 + 4e-5].map(|radius| Sphere { center: Vec3::ZERO, radius });
    let both = Geometry { spheres: spheres.to_vec(), ..Geometry::default() };
    for i in 0..10_000 {
        let mut sampler = Sampler::new(12, i, 0);
        let ray = toward(3.0 * direction(&mut sampler), 0.99 * direction(&mut sampler));
        let (mut rest, mut found) = (ray, Vec::new());
        while let Some(hit) = nearest(&both, &rest) {
            found.push((hit.primitive, hit.t));
            rest.extent.min = hit.t;
        }
        let order: Vec<u32> = found.iter().map(|hit| hit.0).collect();
        assert_eq!(order, [1, 0, 0, 1], "ray {i}: {found:?}");
    }
}
