//! How often a line that meets a box meets a smaller box inside of it.

use bv_tree::{Aabb, BoundingVolume};
use glam::{Vec3, vec3};
use ray_casting::{Ray, math};
use workbench::Sampler;

use crate::figures::Drawing;
use crate::table::{Table, count};

/// How many lines are drawn through the ball around the outer box.
const LINES: u64 = 400_000;

/// A line that is as likely as any other to pass through the ball of `radius` around `center`: a
/// uniform direction, and a uniform point of the disk at right angles to it. It starts outside.
pub(super) fn line(sampler: &mut Sampler, center: Vec3, radius: f32) -> Ray {
    let [u, v] = sampler.next_2d();
    let (z, across) = (1.0 - 2.0 * u, 2.0 * (u * (1.0 - u)).sqrt());
    let (sin, cos) = math::sin_cos(std::f32::consts::TAU * v);
    let direction = vec3(across * cos, across * sin, z);
    let (right, up) = direction.any_orthonormal_pair();

    let [u, v] = sampler.next_2d();
    let (sin, cos) = math::sin_cos(std::f32::consts::TAU * v);
    let offset = radius * u.sqrt() * (cos * right + sin * up);
    Ray::new(center + offset - 2.0 * radius * direction, direction)
}

fn enters(boxed: &Aabb, ray: &Ray) -> bool {
    !boxed.clip(&Aabb::query(ray, boxed.reach(ray.origin))).is_empty()
}

/// Boxes in a unit cube: what area promises, what lines do, what volume would have promised.
pub(super) fn table() -> Drawing {
    let boxes = [
        ("half a cube, ½ × 1 × 1", Vec3::ZERO, vec3(0.5, 1.0, 1.0)),
        ("cube of side ½, in the middle", Vec3::splat(0.25), Vec3::splat(0.75)),
        ("cube of side ½, in a corner", Vec3::ZERO, Vec3::splat(0.5)),
        ("plate, 1 × 1 × 0.02", vec3(0.0, 0.0, 0.49), vec3(1.0, 1.0, 0.51)),
        ("rod, 1 × 0.02 × 0.02", vec3(0.0, 0.49, 0.49), vec3(1.0, 0.51, 0.51)),
    ];
    let cube = Aabb { min: Vec3::ZERO, max: Vec3::ONE };
    let lines: Vec<_> = (0..LINES)
        .map(|i| line(&mut Sampler::new(7, i, 0), Vec3::splat(0.5), 0.867))
        .filter(|line| enters(&cube, line))
        .collect();
    let met = format!("met by {} lines", count(lines.len() as u64));
    let mut table = Table::new(&["box inside the unit cube", "a / A", &met, "share of the volume"]);
    for (name, min, max) in boxes {
        let inner = Aabb { min, max };
        let met = lines.iter().filter(|line| enters(&inner, line)).count();
        let percent = |share: f64| format!("{:.1}\u{a0}%", 100.0 * share);
        table.row([
            name.to_owned(),
            percent(f64::from(inner.surface_area() / cube.surface_area())),
            percent(met as f64 / lines.len() as f64),
            percent(f64::from((max - min).element_product())),
        ]);
    }
    table.into()
}
