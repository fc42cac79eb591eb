//! Axis-aligned boxes: B1 to B15.

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, SlabQuery};
use glam::{DVec3, Vec3};
use ray_casting::{Intersect, Interval, Ray, ShearedRay, triangle};
use workbench::{Counter, Recorder};

use crate::bits::{self, U, gamma};
use crate::exact::Exact;
use crate::meshes::ball;
use crate::random::Random;
use crate::scenes::toward;
use crate::trial::Trial;
use crate::triangle::{Corners, beside_a_triangle, some_case};

crate::catalogue! {
    B1 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs"
        a_box_is_entered_and_left_where_its_corners_are;
    B2 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs" a_ray_within_a_face_is_inside;
    B3 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs" flat_boxes_and_points_are_met;
    B4 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs" a_ray_within_a_face_is_inside;
    B5 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs"
        a_tiny_component_of_the_direction_counts;
    B6 random/1 a_box_begins_where_its_nearest_plane_is_or_a_little_before;
    B7 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs"
        a_box_around_the_origin_is_entered_at_once_and_one_behind_it_never;
    B8 random/1 a_box_of_one_point_is_met_on_the_line_and_not_beside_it;
    B9 random/2 no_box_is_missed_and_what_is_met_in_vain_is_close;
    B10 random/1 the_largest_and_the_smallest_boxes_are_not_missed;
    B11 random/10 a_ray_that_is_not_finite_meets_nothing_at_no_cost;
    B12 random/1 a_box_around_nothing_is_never_met;
    B13 elsewhere "chapters/04-bv-tree/tests/trees/shapes.rs"
        a_ray_in_the_faces_of_boxes_finds_the_edges_there;
    B14 elsewhere "chapters/04-bv-tree/tests/volumes/boxes.rs"
        a_box_is_entered_and_left_where_its_corners_are;
    B15 random/1 the_ends_of_a_slab_are_off_by_a_few_roundings_outward;
}

fn clip(volume: &Aabb, ray: &Ray) -> Interval {
    volume.clip(&Aabb::query(ray, volume.reach(ray.origin)))
}

fn named(volume: &Aabb, ray: &Ray) -> String {
    let (min, max) = (bits::vec3(volume.min), bits::vec3(volume.max));
    format!("{}\nin Aabb {{ min: {min}, max: {max} }}", bits::ray(ray))
}

/// The largest finite t.
const LAST: f64 = f32::MAX as f64;

/// The t at which the ray enters and leaves each slab, in double precision: a difference and a
/// quotient, 2⁻⁵² off. Along a slab it is inside for ever or never.
fn crossings(volume: &Aabb, ray: &Ray) -> [[f64; 2]; 3] {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (min, max) = (volume.min.as_dvec3(), volume.max.as_dvec3());
    [0, 1, 2].map(|i| {
        if d[i] == 0.0 {
            let inside = min[i] <= o[i] && o[i] <= max[i];
            return if inside { [0.0, f64::INFINITY] } else { [f64::INFINITY, 0.0] };
        }
        let [a, b] = [min[i], max[i]].map(|c| (c - o[i]) / d[i]);
        [a.min(b), a.max(b)]
    })
}

/// The t ≥ 0 for which the ray is inside the box; empty if the first is larger.
fn exact_clip(volume: &Aabb, ray: &Ray) -> [f64; 2] {
    let crossings = crossings(volume, ray);
    let enter = crossings.iter().fold(0.0, |t: f64, c| t.max(c[0]));
    [enter, crossings.iter().fold(f64::INFINITY, |t, c| t.min(c[1]))]
}

/// Whether the ray meets the box, in exact arithmetic where doubles cannot tell.
fn meets(volume: &Aabb, ray: &Ray) -> bool {
    let [enter, leave] = exact_clip(volume, ray);
    if (leave - enter).abs() > 1e-14 * (leave.abs() + enter) {
        return enter < leave;
    }
    // t = p / q for the planes of entry and exit of each axis, q > 0, and 0 for the origin.
    let mut entries = vec![[Exact::default(), Exact::from(1.0)]];
    let mut exits = Vec::new();
    for i in 0..3 {
        let (o, d) = (ray.origin[i], ray.direction[i]);
        let [low, high] = [volume.min[i], volume.max[i]];
        if d == 0.0 && !(low <= o && o <= high) {
            return false;
        }
        if d != 0.0 {
            let ends = if d > 0.0 { [low, high] } else { [high, low] };
            let [entry, exit] = ends.map(|c| {
                let p = &Exact::from(c) - &Exact::from(o);
                [&p * &Exact::from(d.signum()), Exact::from(d.abs())]
            });
            entries.push(entry);
            exits.push(exit);
        }
    }
    let no_later =
        |a: &[Exact; 2], b: &[Exact; 2]| (&(&a[0] * &b[1]) - &(&b[0] * &a[1])).sign().is_le();
    entries.iter().all(|entry| exits.iter().all(|exit| no_later(entry, exit)))
}

/// A point of the cube from −1 to 1, times 10⁻⁶ to 10⁶.
fn point(random: &mut Random) -> Vec3 {
    (random.magnitude(-6.0, 6.0) * random.in_cube()).as_vec3()
}

/// A box: between two such points, around a point and small beside its coordinates, or flat.
fn some_box(random: &mut Random) -> Aabb {
    let a = point(random);
    let mut b = point(random);
    match random.below(4) {
        0 => {
            let size = random.magnitude(-7.0, 0.0) * f64::from(a.abs().max_element());
            b = (a.as_dvec3() + size * random.in_cube()).as_vec3();
        }
        1 => {
            let axis = random.below(3) as usize;
            b[axis] = a[axis];
        }
        _ => {}
    }
    Aabb { min: a.min(b), max: a.max(b) }
}

/// A point of the box, half of them on a face, an edge or a corner.
fn point_of(volume: &Aabb, random: &mut Random) -> Vec3 {
    let on_border = random.below(2) == 0;
    Vec3::from_array([0, 1, 2].map(|i| {
        let (low, high) = (volume.min[i], volume.max[i]);
        match random.below(4) {
            0 if on_border => low,
            1 if on_border => high,
            _ => {
                let x = f64::from(low) + random.unit() * (f64::from(high) - f64::from(low));
                (x as f32).clamp(low, high)
            }
        }
    }))
}

/// A ray to a point of the box: from anywhere, from the box itself, or along an axis or a face.
fn some_ray(volume: &Aabb, random: &mut Random) -> Option<Ray> {
    let mut target = point_of(volume, random);
    if random.below(4) == 0 {
        // Past the box, by about as much as it is widened.
        let reach = f64::from(volume.reach(target).max(target.abs().max_element()));
        target = (target.as_dvec3() + random.between(0.0, 40.0) * U * reach * random.direction())
            .as_vec3();
    }
    let origin = if random.below(4) == 0 { point_of(volume, random) } else { point(random) };
    let kind = random.below(4);
    if kind > 1 {
        return toward(origin, target);
    }
    // One component of the direction is zero or tiny, or two are.
    let mut origin = origin;
    for _ in 0..=kind {
        let axis = random.below(3) as usize;
        origin[axis] = random.beside(target[axis]);
    }
    let mut ray = toward(origin, target)?;
    let axis = random.below(3) as usize;
    if ray.origin[axis] == target[axis] && random.below(2) == 0 {
        let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
        ray.direction[axis] = sign * random.magnitude(-45.0, -20.0) as f32;
    }
    Some(ray)
}

/// tmax at the entry finds the box, and well before the entry it does not. The catalogue asks for a
/// miss already at tEntry (1 − 2 u); but boxes are widened by γ(12) of their reach for what the
/// test of a triangle rounds, by γ(2) |o|, and by γ(6) of t, so that much has to be left out.
fn a_box_begins_where_its_nearest_plane_is_or_a_little_before(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let volume = some_box(&mut trial.random);
        let Some(ray) = some_ray(&volume, &mut trial.random) else { continue };
        let [enter, leave] = exact_clip(&volume, &ray);
        if !(0.0 < enter && enter <= leave && enter <= LAST) {
            continue;
        }
        let got = clip(&volume, &ray);
        let crossings = crossings(&volume, &ray);
        let early =
            (0..3).filter(|&i| crossings[i][0] == enter && ray.direction[i] != 0.0).map(|i| {
                let o = f64::from(ray.origin[i].abs());
                let widened =
                    gamma(13) * f64::from(volume.reach(ray.origin)) + gamma(4) * o + 1e-44;
                enter * gamma(11) + widened / f64::from(ray.direction[i].abs())
            });
        let bound = early.fold(f64::INFINITY, f64::min);
        let begins = f64::from(got.min);
        let is_found = got.min <= enter as f32 && begins <= enter;
        let error = if is_found { (enter - begins) / bound } else { f64::INFINITY };
        // From next to the box, the interval begins at the origin: that is early enough.
        let error = if is_found && begins == 0.0 { 0.0 } else { error };
        trial.within(error, 1.0, || format!("{got:?} for {enter}: {}", named(&volume, &ray)));
    }
}

/// o, d and t are small whole numbers times powers of two, so p = o + t d is exact: on the line.
/// Beside it by 64 u of the reach, in the direction of an axis across the ray, the point is missed.
fn a_box_of_one_point_is_met_on_the_line_and_not_beside_it(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let whole = |random: &mut Random, end: f64| random.between(-end - 0.5, end + 0.5).round();
        let mut vector = |end: f64| DVec3::from_array([(); 3].map(|()| whole(random, end)));
        let (o, d) = (vector(1023.0), vector(63.0));
        if d == DVec3::ZERO {
            continue;
        }
        let t = (1 + random.below(8191)) as f64;
        let scale = libm::exp2(whole(random, 60.0));
        let ray = Ray::new((scale * o).as_vec3(), d.as_vec3());
        let p = (scale * (o + t * d)).as_vec3();
        let on_line = clip(&Aabb { min: p, max: p }, &ray);
        let t = (scale * t) as f32;
        trial.require(on_line.contains(t), || {
            format!("{on_line:?} for {t}: {} to {p}", bits::ray(&ray))
        });

        let across = d.abs().min_position();
        let reach = (p - ray.origin).abs().max_element().max(p.abs().max_element());
        let mut beside = p;
        beside[across] +=
            (1.0 + (d[across] / d.abs().max_element()).abs() as f32) * 64.0 * U as f32 * reach;
        let got = clip(&Aabb { min: beside, max: beside }, &ray);
        trial.require(got.is_empty(), || {
            format!("{got:?} beside {p}: {} to {beside}", bits::ray(&ray))
        });
    }
}

/// Boxes and rays over twelve orders of magnitude, rays to corners, edges and faces, along axes and
/// faces, from within. A box that the exact ray meets is met, for all the t of which it is inside;
/// one that it misses is met only if the ray comes as close as the box is widened, 24 u of reach
/// and |o|: 12 for the test of a triangle, 10 for roundings along the ray, 2 for those of o. Error
/// in u of that sum. And what a triangle in the box reports lies inside.
fn no_box_is_missed_and_what_is_met_in_vain_is_close(trial: &mut Trial) {
    for i in 0..trial.rays {
        let volume = some_box(&mut trial.random);
        if let Some(ray) = some_ray(&volume, &mut trial.random) {
            check_box(trial, &volume, &ray);
        }
        let random = &mut trial.random;
        let case = if i % 2 == 0 { some_case(random) } else { beside_a_triangle(random) };
        if let Some((corners, ray)) = case {
            check_content(trial, &corners, &ray);
        }
    }
}

fn check_box(trial: &mut Trial, volume: &Aabb, ray: &Ray) {
    let got = clip(volume, ray);
    let [enter, leave] = exact_clip(volume, ray);
    if meets(volume, ray) {
        let contains = f64::from(got.min) <= enter && leave.min(LAST) <= f64::from(got.max);
        let contains = contains || enter > LAST;
        return trial.require(contains, || {
            format!("{got:?}, not {enter:e} to {leave:e}: {}", named(volume, ray))
        });
    }
    if got.is_empty() {
        return;
    }
    let unit = U as f32 * (Vec3::splat(volume.reach(ray.origin)) + ray.origin.abs());
    let is_met_at = |width: &f32| {
        let pad = width * unit + 1e-44;
        let [enter, leave] =
            exact_clip(&Aabb { min: volume.min - pad, max: volume.max + pad }, ray);
        enter <= leave
    };
    // A box that is padded in single precision is off by a unit of its own.
    let width = [0.25, 1.0, 4.0, 8.0, 12.0, 16.0, 20.0, 24.0].into_iter().find(is_met_at);
    trial.within(width.map_or(f64::INFINITY, f64::from), 24.0, || named(volume, ray));
}

fn check_content(trial: &mut Trial, corners: &Corners, ray: &Ray) {
    let Some(hit) = triangle::intersect(&ShearedRay::new(ray), corners, 0) else { return };
    let volume = Aabb::around(corners);
    let got = clip(&volume, ray);
    trial.require(got.contains(hit.t), || {
        format!("{hit:?} outside of {got:?}: {}, {corners:?}", named(&volume, ray))
    });
}

/// Boxes from 10⁻⁴⁴ to the largest floats: not missed, and no ∞ − ∞.
fn the_largest_and_the_smallest_boxes_are_not_missed(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let scale = random.magnitude(-44.0, 38.53).min(LAST);
        let other =
            if random.below(2) == 0 { scale } else { random.magnitude(-44.0, 38.53).min(LAST) };
        let point = |scale: f64, random: &mut Random| (scale * random.in_cube()).as_vec3();
        let (a, b) = (point(scale, random), point(scale, random));
        let volume = Aabb { min: a.min(b), max: a.max(b) };
        let origin = point(other, random);
        let target = point_of(&volume, random);
        let Some(ray) = toward(origin, target) else { continue };
        let got = clip(&volume, &ray);
        let [enter, leave] = exact_clip(&volume, &ray);
        let is_met = enter <= leave && enter <= LAST && meets(&volume, &ray);
        let contains = f64::from(got.min) <= enter && leave.min(LAST) <= f64::from(got.max);
        trial.require(!got.min.is_nan() && !got.max.is_nan() && (contains || !is_met), || {
            format!("{got:?}, not {enter:e} to {leave:e}: {}", named(&volume, &ray))
        });
    }
}

/// One component or more of origin or direction is NaN or ±∞, the others are anything at all: the
/// tree reports no hit and tests no box, so such a ray costs less than any other; and a box by
/// itself answers with an interval that is not NaN.
fn a_ray_that_is_not_finite_meets_nothing_at_no_cost(trial: &mut Trial) {
    let recorder = Recorder::new();
    let ball = ball(Vec3::ZERO, &mut trial.random);
    let tree = BvTree::<Aabb, _>::build(&ball, Builder::Sah, &recorder);
    for _ in 0..trial.rays {
        let volume = some_box(&mut trial.random);
        let random = &mut trial.random;
        let any = random.below(2) == 0;
        let mut coordinates = [(); 6].map(|()| if any { random.finite() } else { random.u() });
        for _ in 0..=random.below(3) {
            let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY][random.below(3) as usize];
            coordinates[random.below(6) as usize] = bad;
        }
        let [ox, oy, oz, dx, dy, dz] = coordinates;
        let ray = Ray::new(Vec3::new(ox, oy, oz), Vec3::new(dx, dy, dz));
        let (hit, occluded) = (tree.intersect(&ray), tree.occluded(&ray));
        let tests = recorder.get(Counter::VolumeTests) + recorder.get(Counter::PrimitiveTests);
        let got = clip(&volume, &ray);
        let is_sound = hit.is_none() && !occluded && tests == 0;
        trial.require(is_sound && !got.min.is_nan() && !got.max.is_nan(), || {
            format!("{hit:?}, {occluded}, {tests} tests, {got:?}: {}", named(&volume, &ray))
        });
    }
}

/// (+∞, −∞) is met by no ray of finite numbers, whatever they are, in a tree of any finite reach.
fn a_box_around_nothing_is_never_met(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let mut vector = || Vec3::from_array([(); 3].map(|()| random.finite()));
        let (origin, mut direction) = (vector(), vector());
        if random.below(2) == 0 {
            direction = random.direction().as_vec3();
        }
        if random.below(2) == 0 {
            direction[random.below(3) as usize] = [0.0, -0.0][random.below(2) as usize];
        }
        let ray = Ray::new(origin, direction);
        let reach = random.finite().abs();
        for reach in [0.0, reach, f32::MAX] {
            let got = Aabb::EMPTY.clip(&Aabb::query(&ray, reach));
            trial
                .require(got.is_empty(), || format!("{got:?}, reach {reach}: {}", bits::ray(&ray)));
        }
    }
}

/// A slab without padding, its ends against double precision: never inside of the true ones (nor of
/// those rounded to `f32`, as a hit's t is), and outside by at most γ(10) of t, the catalogue's
/// γ(3) for the test itself, γ(6) for the correction and one for applying it; and by what γ(2) |o|,
/// rounded once, is along the ray. Error in that bound.
fn the_ends_of_a_slab_are_off_by_a_few_roundings_outward(trial: &mut Trial) {
    for i in 0..trial.rays {
        let random = &mut trial.random;
        let mut number = |low: f64, high: f64| {
            let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
            (sign * random.magnitude(low, high)) as f32
        };
        let (a, b, d) = (number(-6.0, 6.0), number(-6.0, 6.0), number(-6.0, 0.0));
        // Without an origin the roundings are relative to t alone.
        let o = if i % 2 == 0 { 0.0 } else { number(-6.0, 6.0) };
        let slab = Interval::new(a.min(b), a.max(b));
        let got = SlabQuery::new(o, d, 0.0).clip(slab);
        let [near, far] = if d > 0.0 { [slab.min, slab.max] } else { [slab.max, slab.min] };
        for (end, plane, outward) in [(got.min, near, -1.0), (got.max, far, 1.0)] {
            let exact = (f64::from(plane) - f64::from(o)) / f64::from(d);
            let beyond = outward * (f64::from(end) - exact);
            let beyond_rounded = outward * (f64::from(end) - f64::from(exact as f32));
            let offset = (gamma(4) * f64::from(o.abs()) + 1e-44) / f64::from(d.abs());
            // Nothing behind the origin is asked for, and there the correction goes the other way.
            let is_right = exact < 0.0 || beyond >= 0.0 && beyond_rounded >= 0.0;
            let error =
                if is_right { beyond.abs() / (gamma(10) * exact.abs() + offset) } else { f64::NAN };
            trial.within(error, 1.0, || {
                let numbers = [o, d, slab.min, slab.max].map(bits::float).join(", ");
                format!("{end} for {exact}: o, d, slab = {numbers}")
            });
        }
    }
}
