//! Rays that leave a surface: from as near as the error bound allows.

use glam::Vec3;
use ray_casting::surface_point::offset_by_epsilon;
use ray_casting::{Geometry, Sphere, SurfacePoint};
use workbench::Sampler;

use crate::tools::{
    direction, exact_normal, in_cube, magnitude, nearest, scene, sphere, surface, toward,
    triangles, ulp,
};

/// A hit on a random sphere: radius 10⁻⁴ to 10⁴, centre 10⁻⁸ to 10⁸ away from the origin.
fn on_a_sphere(i: u64) -> Option<(SurfacePoint, Vec3)> {
    let mut sampler = Sampler::new(13, i, 0);
    let radius = magnitude(&mut sampler, -4.0, 4.0);
    let center = magnitude(&mut sampler, -8.0, 8.0) * direction(&mut sampler);
    let eye = center + 3.0 * radius * direction(&mut sampler);
    let target = center + 0.9 * radius * direction(&mut sampler);
    let surface = surface(&scene(sphere(center, radius)), &toward(eye, target))?;
    Some((surface, direction(&mut sampler)))
}

/// accuracy S12.
#[test]
fn a_ray_starts_within_32_last_places_of_its_surface() {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for (surface, direction) in (0..100_000).filter_map(on_a_sphere) {
        let moved = surface.spawn(direction).origin.as_dvec3() - surface.position.as_dvec3();
        let n = surface.geometric_normal.as_dvec3();
        let side = f64::from(direction.dot(surface.geometric_normal)).signum();
        let bound = n.abs().dot(surface.position_error.as_dvec3());
        // The unit normal is off by its own rounding.
        let along = side * moved.dot(n) * (1.0 + f64::from(f32::EPSILON));
        assert!(along >= bound, "moved {along:e} of {bound:e}: {surface:?} along {direction}");
        worst = worst.max(moved.length() / ulp(surface.position.abs().max_element()));
        count += 1;
    }
    assert!(count > 50_000, "only {count} rays hit");
    assert!(worst <= 32.0, "a ray starts {worst} units in the last place away");
}

/// accuracy T14: the box around a point of a triangle reaches the plane of the triangle.
#[test]
fn the_error_box_of_a_point_reaches_the_surface() {
    for i in 0..100_000 {
        let mut sampler = Sampler::new(14, i, 0);
        let scale = magnitude(&mut sampler, -8.0, 8.0);
        let offset = magnitude(&mut sampler, -3.0, 3.0) * direction(&mut sampler);
        let corners = [(); 3].map(|()| scale * (offset + in_cube(&mut sampler)));
        let target = (corners[0] + corners[1] + corners[2]) / 3.0;
        let eye = target + 4.0 * scale * direction(&mut sampler);
        let whole = scene(triangles(&[corners]));
        let Some(surface) = surface(&whole, &toward(eye, target)) else { continue };
        let n = exact_normal(corners);
        let distance = n.dot(surface.position.as_dvec3() - corners[0].as_dvec3()).abs();
        let reach = n.abs().dot(surface.position_error.as_dvec3());
        assert!(
            distance <= reach,
            "case {i}: {distance:e} from the plane, the box reaches {reach:e}"
        );
    }
}

/// accuracy S17: from the outer of two close spheres, a ray reaches the inner one; one that starts
/// by a constant of 10⁻³ passes through it.
#[test]
fn a_ray_does_not_jump_over_what_lies_close_by() {
    let spheres = [1.0, 1.0 + 4e-5].map(|radius| Sphere { center: Vec3::ZERO, radius });
    let scene = scene(Geometry { spheres: spheres.to_vec(), ..Geometry::default() });
    let mut jumped = 0;
    for i in 0..10_000 {
        let mut sampler = Sampler::new(15, i, 0);
        let ray = toward(3.0 * direction(&mut sampler), 0.5 * direction(&mut sampler));
        let surface = surface(&scene, &ray).unwrap_or_else(|| panic!("ray {i} misses"));
        let next = nearest(&scene.geometry, &surface.spawn(ray.direction));
        let distance = next.map(|hit| (hit.primitive, hit.t < 1e-3));
        assert_eq!(distance, Some((0, true)), "ray {i}: behind {surface:?} comes {next:?}");
        let constant = offset_by_epsilon(&surface, ray.direction, 1e-3);
        let next = nearest(&scene.geometry, &constant);
        jumped += usize::from(next.is_none_or(|hit| hit.t > 0.1));
    }
    assert_eq!(jumped, 10_000, "rays by a constant that jump over the inner sphere");
}

/// A ray to a light ends at the light, so nothing behind it casts a shadow, and neither does the
/// surface itself.
#[test]
fn a_ray_to_a_target_ends_there() {
    for (surface, direction) in (0..20_000).filter_map(on_a_sphere) {
        let size = surface.position.abs().max_element();
        let target = surface.position + 2.0 * size * direction;
        let ray = surface.spawn_to(target);
        assert_eq!(ray.extent.min, 0.0, "where it starts");
        let end = ray.at(ray.extent.max).as_dvec3();
        let error = (end - target.as_dvec3()).abs().max_element() / ulp(size);
        assert!(error <= 16.0, "ends {error} units in the last place beside {target}");
    }
}
