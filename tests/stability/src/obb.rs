//! Oriented boxes: O1 to O8.
//!
//! A box of the course is never turned: it is fitted anew to content that has been. It is widened on
//! purpose, by γ(40) of its reach (see `bv_tree::Obb`), so its interval contains the exact one and is
//! not the exact one: what the cases ask of its size is that it is no larger than that explains.

use bv_tree::{Aabb, BoundingVolume, Obb};
use glam::{DMat3, DQuat, DVec3, Mat3, Vec3, dvec3, vec3};
use ray_casting::{Geometry, Interval, Ray};

use crate::bits::{self, U, gamma};
use crate::closed::brick;
use crate::random::Random;
use crate::scenes::toward;
use crate::trial::Trial;
use crate::volumes::{Enclosed, aimed, content, encloses, hits};

crate::catalogue! {
    O1 random/8 a_box_along_the_axes_clips_as_its_corners_say;
    O2 exact a_cube_on_edge_is_met_where_it_is;
    O3 random/8 a_cube_turned_by_hardly_anything_is_never_missed;
    O4 random/1 a_cube_turned_over_and_over_stays_inside_of_a_right_angled_box;
    O5 elsewhere "chapters/04-bv-tree/tests/volumes/oriented.rs" a_long_box_is_met_at_its_tips;
    O6 elsewhere "chapters/04-bv-tree/tests/volumes/oriented.rs" degenerate_content_is_enclosed;
    O7 elsewhere "chapters/04-bv-tree/tests/volumes/oriented.rs" degenerate_content_is_enclosed;
    O8 random/8 no_ray_to_a_point_inside_misses_an_oriented_box;
}

/// Rays for each box: fitting one costs as much.
const PER_BOX: u64 = 16;

/// The t ≥ 0 for which the ray is inside of the box, widened by `padding` on each side, in double
/// precision; empty if it misses.
fn exact_clip(bounds: &Aabb, padding: f64, ray: &Ray) -> [f64; 2] {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    // Relative to the origin first: beside a large coordinate a small padding would vanish.
    let (min, max) = (bounds.min.as_dvec3() - o - padding, bounds.max.as_dvec3() - o + padding);
    let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
    for i in 0..3 {
        if d[i] == 0.0 {
            if min[i] > 0.0 || max[i] < 0.0 {
                return [f64::INFINITY, f64::NEG_INFINITY];
            }
            continue;
        }
        let (a, b) = (min[i] / d[i], max[i] / d[i]);
        (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
    }
    [enter, leave]
}

/// Whether `inner` lies in `outer`; what is empty lies in everything.
fn lies_in([min, max]: [f64; 2], outer: [f64; 2]) -> bool {
    let is_empty = min > max;
    is_empty || (outer[0] <= min && max <= outer[1])
}

fn ends(interval: Interval) -> [f64; 2] {
    [f64::from(interval.min), f64::from(interval.max)]
}

/// Boxes along the axes, of any size and proportions, up to 10⁷ times their size away. The catalogue
/// asks for the bits of an AABB; those it cannot have, since the AABB is widened by γ(12) of its
/// reach and by γ(2) of its distance from the origin. Instead the interval contains the exact one,
/// and lies in that of a box widened by γ(64): the padding, the extents' own rounding, and γ(16) for
/// that of t. Next to zero, where roundings are not relative, 64 of the smallest floats are added.
fn a_box_along_the_axes_clips_as_its_corners_say(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_BOX) {
        let random = &mut trial.random;
        let scale = random.magnitude(-6.0, 6.0);
        let far = [0.0, random.magnitude(-1.0, 7.0)][random.below(2) as usize];
        let center = scale * far * random.direction();
        let size = scale * DVec3::from_array([(); 3].map(|()| random.magnitude(-3.0, 0.0)));
        let mesh = brick(|side| (center + size * side).as_vec3());
        let fitted = Enclosed::<Obb>::all_of(&mesh);
        for _ in 0..PER_BOX {
            let ray = aimed(&mesh, scale, &mut trial.random).ray;
            let inside = ends(fitted.clip(&ray));
            let reach = f64::from(fitted.bounds.reach(ray.origin));
            let exact = exact_clip(&fitted.bounds, 0.0, &ray);
            let padding = gamma(64) * reach + f64::from(f32::from_bits(64));
            let [enter, leave] = exact_clip(&fitted.bounds, padding, &ray);
            let widest = [enter * (1.0 - gamma(16)), leave * (1.0 + gamma(16))];
            let holds = lies_in(exact, inside) && lies_in(inside, widest);
            trial.require(holds && !inside[0].is_nan(), || {
                let axes = fitted.volume.axes();
                format!(
                    "{inside:?}, not from {exact:?} to {widest:?}: {axes:?}, {}",
                    bits::ray(&ray)
                )
            });
        }
    }
}

/// The unit cube, turned by 45° about y, and a ray along z through its centre: t lies √½ before and
/// behind it. Each end may be off by the padding γ(40) of the reach, seen at 45°, and γ(16) of t for
/// the rest. Error in units of that.
fn a_cube_on_edge_is_met_where_it_is(trial: &mut Trial) {
    let half = 0.5_f64.sqrt();
    let cube = brick(|side| {
        let p = 0.5 * side;
        dvec3(half * (p.x + p.z), p.y, half * (p.z - p.x)).as_vec3()
    });
    let fitted = Enclosed::<Obb>::all_of(&cube);
    for distance in [0.75_f32, 1.0, 4.0, 100.0, 1e4, 1e6] {
        let ray = Ray::new(vec3(0.0, 0.0, -distance), Vec3::Z);
        let [enter, leave] = ends(fitted.clip(&ray));
        let reach = f64::from(fitted.bounds.reach(ray.origin));
        let limit = (gamma(40) / half + gamma(16)) * reach;
        let center = f64::from(distance);
        for (excess, which) in [(center - half - enter, "entry"), (leave - center - half, "exit")] {
            // The corners are rounded, so even an exact box would be off by as much as u.
            let case = || format!("{which} from {distance}: {enter} to {leave}");
            trial.require(excess >= -U, case);
            trial.within(excess / limit, 1.0, case);
        }
    }
}

/// A rotation by `angle`, small, about an axis of any direction: 1 + ½ angle, made a unit quaternion.
fn small_rotation(angle: f64, random: &mut Random) -> DMat3 {
    let half = 0.5 * angle * random.direction();
    DMat3::from_quat(DQuat::from_xyzw(half.x, half.y, half.z, 1.0).normalize())
}

/// A cube turned by 10⁻⁹ to 10⁻⁴ radians, for most of which its corners hardly move by one float, so
/// that edges and normals of its faces disagree. Whatever the ray hits of it lies inside.
fn a_cube_turned_by_hardly_anything_is_never_missed(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_BOX) {
        let random = &mut trial.random;
        let angle = random.magnitude(-9.0, -4.0);
        let rotation = small_rotation(angle, random);
        let center = random.magnitude(-3.0, 5.0) * random.direction();
        let cube = brick(|side| (center + rotation * side).as_vec3());
        let fitted = Enclosed::<Obb>::all_of(&cube);
        for _ in 0..PER_BOX {
            let aimed = aimed(&cube, 1.0, &mut trial.random);
            encloses(trial, &cube, &fitted, &aimed, &hits(&cube, &aimed.ray));
        }
    }
}

/// Rotations for each box.
const PER_FIT: u64 = 16;

/// Rotations by up to a radian, multiplied in single precision without ever being corrected, turn a
/// brick: the axes of the box around it are of unit length and at right angles to 8 u, and every corner
/// is inside, as the box says in double precision and as a ray that starts there says. Error in u.
fn a_cube_turned_over_and_over_stays_inside_of_a_right_angled_box(trial: &mut Trial) {
    let mut all = Mat3::IDENTITY;
    for i in 0..trial.rays {
        let random = &mut trial.random;
        let angle = random.unit();
        all = small_rotation(angle, random).as_mat3() * all;
        if i % PER_FIT > 0 {
            continue;
        }
        let size = DVec3::from_array([(); 3].map(|()| random.magnitude(-3.0, 0.0)));
        let center = (random.magnitude(-3.0, 3.0) * random.direction()).as_vec3();
        let mesh = brick(|side| center + all * (size * side).as_vec3());
        check_fit(trial, &mesh);
    }
}

fn check_fit(trial: &mut Trial, mesh: &Geometry) {
    let fitted = Enclosed::<Obb>::all_of(mesh);
    let [a, b, c] = fitted.volume.axes().map(Vec3::as_dvec3);
    let lengths = [a, b, c].map(|axis| axis.length() - 1.0);
    for error in lengths.into_iter().chain([a.dot(b), b.dot(c), c.dot(a)]) {
        trial.within(error.abs() / U, 8.0, || format!("{a}, {b}, {c} around {mesh:?}"));
    }
    for &corner in &mesh.vertices {
        let ray = Ray::new(corner, trial.random.direction().as_vec3());
        let inside = fitted.volume.contains(corner) && fitted.clip(&ray).contains(0.0);
        trial.require(inside, || format!("{} of {mesh:?}", bits::vec3(corner)));
    }
    let from_afar = toward(fitted.bounds.max + Vec3::ONE, mesh.vertices[0]);
    let is_met = from_afar.is_some_and(|ray| !fitted.clip(&ray).is_empty());
    let area = fitted.volume.surface_area();
    trial.require(is_met && area > 0.0, || format!("{from_afar:?} misses {mesh:?}, area {area}"));
}

/// Content of any shape, and rays aimed at it: no hit, and no point that a ray passes as near as
/// rounding can tell, is outside.
fn no_ray_to_a_point_inside_misses_an_oriented_box(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_BOX) {
        let geometry = content(&mut trial.random);
        let fitted = Enclosed::<Obb>::all_of(&geometry);
        let size = f64::from((fitted.bounds.max - fitted.bounds.min).max_element());
        for _ in 0..PER_BOX {
            let aimed = aimed(&geometry, size, &mut trial.random);
            encloses(trial, &geometry, &fitted, &aimed, &hits(&geometry, &aimed.ray));
        }
    }
}
