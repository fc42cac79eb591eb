//! No ray meets again the surface that it leaves, at any scale.

use glam::Vec3;
use ray_casting::surface_point::offset_by_epsilon;
use ray_casting::{Ray, Scene, Sphere, SurfacePoint};
use workbench::Sampler;

use crate::tools::{direction, in_cube, nearest, scene, sphere, surface, toward, triangles};

/// Rays at each scale, from a hundredth as many hits.
const RAYS: u64 = 100_000;
const PER_HIT: u64 = 100;

/// The powers of ten at which the tests are made.
const SCALES: std::ops::RangeInclusive<i32> = -8..=8;

/// A triangle of about this size, beside the origin, and a ray that hits it.
fn triangle_case(scale: f32, sampler: &mut Sampler) -> (Scene, Ray) {
    let offset = in_cube(sampler);
    let corners = [(); 3].map(|()| scale * (offset + in_cube(sampler)));
    let [b1, b2] = sampler.next_2d().map(|u| 0.5 * u);
    let target = corners[0] + b1 * (corners[1] - corners[0]) + b2 * (corners[2] - corners[0]);
    let eye = target + 4.0 * scale * direction(sampler);
    (scene(triangles(&[corners])), toward(eye, target))
}

/// Likewise with a sphere.
fn sphere_case(scale: f32, sampler: &mut Sampler) -> (Scene, Ray) {
    let center = scale * in_cube(sampler);
    let radius = scale * (0.01 + sampler.next_1d());
    let eye = center + 4.0 * scale * direction(sampler);
    let target = center + 0.9 * radius * direction(sampler);
    (scene(sphere(center, radius)), toward(eye, target))
}

/// How many rays hit the surface that they leave.
fn self_hits(
    scale: f32,
    case: fn(f32, &mut Sampler) -> (Scene, Ray),
    leave: impl Fn(&SurfacePoint, Vec3) -> Ray,
) -> usize {
    let (mut hits, mut rays) = (0, 0);
    for i in 0.. {
        let mut sampler = Sampler::new(16, i, u64::from(scale.to_bits()));
        let (scene, ray) = case(scale, &mut sampler);
        let Some(surface) = surface(&scene, &ray) else { continue };
        for _ in 0..PER_HIT {
            let mut direction = direction(&mut sampler);
            // A ray that enters a sphere rightly meets its other side.
            if !scene.geometry.spheres.is_empty() {
                let outward = direction.dot(surface.geometric_normal).signum();
                direction *= outward;
            }
            let again = nearest(&scene.geometry, &leave(&surface, direction));
            hits += usize::from(again.is_some());
            rays += 1;
        }
        if rays >= RAYS {
            break;
        }
    }
    hits
}

/// accuracy T13, P6.
#[test]
fn no_ray_hits_the_triangle_that_it_leaves() {
    for exponent in SCALES {
        let scale = 10.0_f32.powi(exponent);
        let hits = self_hits(scale, triangle_case, SurfacePoint::spawn);
        assert_eq!(hits, 0, "of {RAYS} rays at scale {scale:e}");
    }
}

/// accuracy S11.
#[test]
fn no_ray_hits_the_sphere_that_it_leaves() {
    for exponent in SCALES {
        let scale = 10.0_f32.powi(exponent);
        let hits = self_hits(scale, sphere_case, SurfacePoint::spawn);
        assert_eq!(hits, 0, "of {RAYS} rays at scale {scale:e}");
    }
}

/// The folklore constant is too small for a large scene.
#[test]
fn rays_by_a_constant_hit_the_large_spheres_that_they_leave() {
    let by_constant = |surface: &SurfacePoint, d: Vec3| offset_by_epsilon(surface, d, 1e-3);
    let hits = self_hits(1e8, sphere_case, by_constant);
    assert!(hits > 1000, "only {hits} of {RAYS} rays hit the sphere that they leave");
}

/// accuracy P6 at grazing angles: down to 10⁻⁶ of the plane, on a floor a million wide.
#[test]
fn grazing_rays_leave_a_wide_floor_on_their_side() {
    let corners = [Vec3::new(-1e6, 0.0, 1e6), Vec3::new(2e6, 0.0, 1e6), Vec3::new(0.0, 0.0, -2e6)];
    let scene = scene(triangles(&[corners]));
    for i in 0..RAYS {
        let mut sampler = Sampler::new(17, i, 0);
        let d = in_cube(&mut sampler);
        let slope = 10.0_f32.powf(-6.0 * sampler.next_1d());
        let grazing = Vec3::new(d.x, -slope, d.z).normalize();
        let target = Vec3::new(1e5 * d.z, 0.0, 1e5 * d.y);
        let ray = Ray::new(target - grazing, grazing);
        let Some(surface) = surface(&scene, &ray) else { continue };
        for direction in [grazing, grazing * Vec3::new(1.0, -1.0, 1.0)] {
            let next = surface.spawn(direction);
            let again = nearest(&scene.geometry, &next);
            assert_eq!(again, None, "slope {slope:e}: {next:?} from {surface:?}");
            let side = next.origin.y * direction.y;
            assert!(side >= 0.0, "slope {slope:e}: {next:?} starts on the wrong side");
        }
    }
}

/// The same in any plane, for directions so close to it that rounding decides on which side they lead.
#[test]
fn rays_along_a_tilted_triangle_do_not_meet_it() {
    let mut ambiguous = 0;
    for i in 0..RAYS {
        let mut sampler = Sampler::new(19, i, 0);
        let (scene, ray) = triangle_case(10.0_f32.powi((i % 9) as i32 - 4), &mut sampler);
        let Some(surface) = surface(&scene, &ray) else { continue };
        let normal = surface.geometric_normal;
        let along = normal.cross(direction(&mut sampler)).normalize();
        let slope = 10.0_f32.powf(-4.0 - 5.0 * sampler.next_1d());
        let slope = if i % 2 == 0 { slope } else { -slope };
        let grazing = (along + slope * normal).normalize();
        ambiguous += usize::from((grazing.dot(normal) < 0.0) != (slope < 0.0));
        let next = surface.spawn(grazing);
        let again = nearest(&scene.geometry, &next);
        assert_eq!(again, None, "slope {slope:e}: {next:?} from {surface:?}");
    }
    assert!(ambiguous > 1000, "only {ambiguous} directions were close enough to the plane");
}

/// Inside a sphere every ray finds the opposite wall, none the wall that it leaves.
#[test]
fn a_ray_that_enters_a_sphere_meets_its_other_side() {
    let ball = Sphere { center: Vec3::new(3.0, -2.0, 5.0), radius: 2.0 };
    let scene = scene(sphere(ball.center, ball.radius));
    for i in 0..RAYS {
        let mut sampler = Sampler::new(18, i, 0);
        let ray = toward(Vec3::ZERO, ball.center + 1.9 * direction(&mut sampler));
        let Some(surface) = surface(&scene, &ray) else { continue };
        let d = direction(&mut sampler);
        let cos_theta = surface.geometric_normal.dot(d).abs();
        let inward = if surface.geometric_normal.dot(d) < 0.0 { d } else { -d };
        let hit = nearest(&scene.geometry, &surface.spawn(inward));
        let expected = 2.0 * ball.radius * cos_theta;
        let error = hit.map_or(f32::INFINITY, |hit| (hit.t - expected).abs());
        // The start is off by a few units in the last place of 7, and so the chord by that and by
        // as much divided by the cosine.
        let bound = 16.0 * f32::EPSILON * (4.0 + 4.0 / cos_theta);
        assert!(error <= bound || cos_theta < 1e-3, "chord {hit:?} for {expected}");
    }
}
