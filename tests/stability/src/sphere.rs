//! Rays and spheres: S1 to S17.

use glam::{DVec3, Vec3, vec3};
use ray_casting::{Ray, Scene, Sphere, SurfacePoint};

use crate::bits::{self, U, ulp, ulps};
use crate::random::Random;
use crate::scenes::{nearest, scene, spheres, surface, toward};
use crate::trial::Trial;

crate::catalogue! {
    S1 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        a_head_on_hit_is_exact_for_directions_of_any_length;
    S2 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        a_head_on_hit_is_exact_for_directions_of_any_length;
    S3 random/1 a_distant_sphere_is_hit_to_the_last_place;
    S4 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        grazing_rays_hit_inside_and_miss_outside;
    S5 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        grazing_rays_hit_inside_and_miss_outside;
    S6 random/1 the_ground_is_hit_to_the_last_place_from_just_above_it;
    S7 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        rays_from_inside_and_from_the_surface_find_the_other_side;
    S8 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        rays_from_inside_and_from_the_surface_find_the_other_side;
    S9 random/1 from_the_centre_every_direction_is_a_radius_away;
    S10 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        rays_from_inside_and_from_the_surface_find_the_other_side;
    S11 random/2 no_ray_meets_again_the_sphere_that_it_leaves;
    S12 random/2 a_ray_starts_within_a_few_units_of_the_sphere_that_it_leaves;
    S13 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        what_is_not_a_sphere_or_not_a_ray_is_never_hit;
    S14 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        what_is_not_a_sphere_or_not_a_ray_is_never_hit;
    S15 elsewhere "chapters/01-ray-casting/src/sphere.rs"
        very_large_and_very_small_spheres_are_hit;
    S16 random/2 the_point_of_a_hit_lies_on_the_sphere;
    S17 random/4 spheres_in_one_another_are_hit_in_their_order;
}

/// The t of both roots in double precision, for a sphere at the origin, from its centre's distance
/// computed as a product: (|o| − r)(|o| + r) does not cancel.
fn exact_roots(ray: &Ray, radius: f32) -> Option<[f64; 2]> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let r = f64::from(radius);
    let (a, b) = (d.dot(d), -o.dot(d));
    let c = (o.length() - r) * (o.length() + r);
    let nearest = o + (b / a) * d;
    let rest = r * r - nearest.length_squared();
    let q = b + (a * rest).sqrt().copysign(b);
    (rest >= 0.0).then(|| [c / q, q / a])
}

/// o = (x, y, −D) with x² + y² ≤ 1/4 and D from 10 to 10⁷, d = +z: t = D − √(1 − x² − y²), where the
/// school formula is off by hundreds of units. The stable one rounds once: half a unit, and 1 is asked.
fn a_distant_sphere_is_hit_to_the_last_place(trial: &mut Trial) {
    let unit = Sphere { center: Vec3::ZERO, radius: 1.0 };
    for _ in 0..trial.rays {
        let distance = trial.random.magnitude(1.0, 7.0) as f32;
        let beside = (0.5 * trial.random.in_cube()).as_vec3();
        let ray = Ray::new(vec3(beside.x, beside.y, -distance), Vec3::Z);
        let [x, y] = [f64::from(beside.x), f64::from(beside.y)];
        let exact = f64::from(distance) - (1.0 - x * x - y * y).sqrt();
        let error = unit.intersect(&ray).map_or(f64::INFINITY, |t| ulps(t, exact));
        trial.within(error, 1.0, || bits::ray(&ray));
    }
}

/// r from 10² to 10⁷, an eye 0.1 to 3.1 above, 3° to 86° below the horizon. Within 2 ULP; a formula
/// in single precision cannot do better than 2·10⁻⁴ of t.
fn the_ground_is_hit_to_the_last_place_from_just_above_it(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let ground = Sphere { center: Vec3::ZERO, radius: random.magnitude(2.0, 7.0) as f32 };
        let eye = f64::from(ground.radius) + random.between(0.1, 3.1);
        let below = random.between(3.0, 86.0).to_radians();
        let (sin, cos) = libm::sincos(below);
        let direction = DVec3::new(cos, -sin, 0.0).as_vec3();
        let ray = Ray::new(vec3(0.0, eye as f32, 0.0), direction);
        // At 10⁷ the eye may be rounded onto the ground, and the angle may lead past the horizon.
        let roots = exact_roots(&ray, ground.radius);
        let Some([exact, _]) = roots.filter(|_| ray.origin.y > ground.radius) else { continue };
        let error = ground.intersect(&ray).map_or(f64::INFINITY, |t| ulps(t, exact));
        trial.within(error, 2.0, || format!("{ground:?}, {}", bits::ray(&ray)));
    }
}

/// 8 decades of radius, 6 of the direction's length: t = r / ‖d‖ to 3 u, the roundings of d·d, of its
/// root and of the quotient if they were made in single precision. Error in u.
fn from_the_centre_every_direction_is_a_radius_away(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let center = (100.0 * random.direction()).as_vec3();
        let radius = random.magnitude(-4.0, 4.0) as f32;
        let direction = (random.magnitude(-3.0, 3.0) * random.direction()).as_vec3();
        let ray = Ray::new(center, direction);
        let exact = f64::from(radius) / direction.as_dvec3().length();
        let t = Sphere { center, radius }.intersect(&ray);
        let error = t.map_or(f64::INFINITY, |t| (f64::from(t) / exact - 1.0).abs() / U);
        trial.within(error, 3.0, || format!("radius {}, {}", bits::float(radius), bits::ray(&ray)));
    }
}

/// A sphere with a radius of 10⁻⁴ to 10⁴, up to 10⁸ from the origin, and a ray that may hit it.
fn some_sphere(random: &mut Random) -> (Scene, Option<Ray>) {
    let radius = random.magnitude(-4.0, 4.0);
    let center = random.magnitude(-8.0, 8.0) * random.direction();
    let eye = center + random.magnitude(0.1, 4.0) * radius * random.direction();
    let target = center + 0.9 * radius * random.direction();
    let ball = Sphere { center: center.as_vec3(), radius: radius as f32 };
    (scene(spheres(&[ball])), toward(eye.as_vec3(), target.as_vec3()))
}

/// Spawned rays for each hit.
const PER_HIT: u64 = 16;

/// Calls `leave` with points on spheres and directions that lead outward from them, half of them
/// close to the tangent plane.
fn leaving(trial: &mut Trial, mut leave: impl FnMut(&mut Trial, &Scene, &SurfacePoint, Vec3)) {
    for _ in 0..trial.rays.div_ceil(PER_HIT) {
        let (scene, ray) = some_sphere(&mut trial.random);
        let Some(surface) = ray.and_then(|ray| surface(&scene, &ray)) else { continue };
        let normal = surface.geometric_normal;
        for i in 0..PER_HIT {
            let mut direction = trial.random.direction();
            if i % 2 == 0 {
                let n = normal.as_dvec3();
                let along =
                    (direction - direction.dot(n) * n).normalize_or(n.any_orthonormal_vector());
                direction = (along + trial.random.magnitude(-8.0, -1.0) * n).normalize();
            }
            let direction = direction.as_vec3();
            let outward = if direction.dot(normal) < 0.0 { -direction } else { direction };
            leave(trial, &scene, &surface, outward);
        }
    }
}

/// 16 decades of distance, 8 of radius: no outgoing ray meets the sphere that it leaves.
fn no_ray_meets_again_the_sphere_that_it_leaves(trial: &mut Trial) {
    leaving(trial, |trial, scene, surface, outward| {
        let ray = surface.spawn(outward);
        let again = nearest(&scene.geometry, &ray);
        trial.require(again.is_none(), || {
            format!("{:?} is met at {again:?} by {}", scene.geometry.spheres, bits::ray(&ray))
        });
    });
}

/// The same rays start at most 32 units in the last place of max |p| from the point that they leave.
/// Error in those units.
fn a_ray_starts_within_a_few_units_of_the_sphere_that_it_leaves(trial: &mut Trial) {
    leaving(trial, |trial, scene, surface, outward| {
        let ray = surface.spawn(outward);
        let way = ray.origin.as_dvec3().distance(surface.position.as_dvec3());
        let unit = ulp(surface.position.abs().max_element());
        trial.within(way / unit, 32.0, || {
            format!("{:?} is left by {}", scene.geometry.spheres, bits::ray(&ray))
        });
    });
}

/// Points are pulled back onto the sphere: |‖p − c‖ − r| ≤ 2 ULP of max(r, ‖c‖), three roundings of
/// numbers of that size. Error in those units.
fn the_point_of_a_hit_lies_on_the_sphere(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let (scene, ray) = some_sphere(&mut trial.random);
        let Some(surface) = ray.and_then(|ray| surface(&scene, &ray)) else { continue };
        let Sphere { center, radius } = scene.geometry.spheres[0];
        let distance = surface.position.as_dvec3().distance(center.as_dvec3());
        let error = (distance - f64::from(radius)).abs() / ulp(radius.max(center.length()));
        trial.within(error, 2.0, || format!("{:?}, {surface:?}", scene.geometry.spheres));
    }
}

/// Radii 1 and 1 + 4·10⁻⁵: a ray through both meets outer, inner, inner, outer, and a ray that leaves
/// the outer one inward meets the inner one. A constant offset of 10⁻³ jumps over it.
fn spheres_in_one_another_are_hit_in_their_order(trial: &mut Trial) {
    let both = spheres(&[1.0, 1.0 + 4e-5].map(|radius| Sphere { center: Vec3::ZERO, radius }));
    let both = scene(both);
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let (eye, target) = (3.0 * random.direction(), 0.99 * random.direction());
        let Some(ray) = toward(eye.as_vec3(), target.as_vec3()) else { continue };
        let (mut rest, mut order) = (ray, Vec::new());
        while let Some(hit) = nearest(&both.geometry, &rest) {
            order.push(hit.primitive);
            rest.extent.min = hit.t;
        }
        let outer = surface(&both, &ray);
        let next = outer.and_then(|outer| nearest(&both.geometry, &outer.spawn(ray.direction)));
        let holds = order == [1, 0, 0, 1] && next.is_some_and(|hit| hit.primitive == 0);
        trial.require(holds, || format!("{order:?}, then {next:?}: {}", bits::ray(&ray)));
    }
}
