//! Trees: V1 to V14. The oracle is the search through all primitives.

use std::f32::consts::SQRT_2;

use bv_tree::{Aabb, BoundingVolume, BvTree, Item, KDop, Obb};
use glam::{DVec3, Vec3};
use ray_casting::{Geometry, Intersect, Interval, LinearSearch, Ray, Sphere};
use workbench::{Counter, Recorder, Unwatched};

use crate::bits;
use crate::closed::{AIMS, PLACES, aimed as aimed_at, heart};
use crate::meshes::ball;
use crate::random::Random;
use crate::scenes::{nearest, toward, triangles};
use crate::trial::Trial;
use crate::volumes::{
    AnyTree, VOLUMES, aimed, cluster, content, hit_bits, some_builder, some_frame, some_tree, tree,
};

crate::catalogue! {
    V1 random/64 a_tree_finds_what_a_search_through_everything_finds;
    V2 random/64 a_tree_over_next_to_nothing_works;
    V3 elsewhere "chapters/04-bv-tree/tests/trees/shapes.rs" identical_triangles_make_a_shallow_tree;
    V4 random/128 equal_and_collinear_centres_make_no_deep_tree;
    V5 random/4000 a_bad_triangle_among_ten_thousand_harms_no_other;
    V6 random/64 boxes_without_end_make_a_tree;
    V7 random/64 splits_that_are_equally_good_lose_nothing;
    V8 elsewhere "chapters/04-bv-tree/tests/trees/shapes.rs" unequal_distances_make_no_deep_tree;
    V9 random/32 no_ray_leaves_a_closed_mesh_through_any_volume;
    V10 random/64 something_is_hit_if_and_only_if_something_is_nearest;
    V11 random/256 a_hit_at_the_very_end_of_the_extent_counts;
    V12 random/64 no_ray_tests_more_than_there_is;
    V13 elsewhere "chapters/04-bv-tree/tests/trees/counts.rs"
        a_ray_that_is_not_finite_tests_nothing;
    V14 elsewhere "tests/acceptance/tests/stages/agreement.rs"
        volumes_and_builders_never_change_the_picture;
}

/// Rays for each tree: building it costs as much.
const PER_TREE: u64 = 64;

/// Compares a tree with the search through everything.
fn compare(trial: &mut Trial, geometry: &Geometry, tree: &AnyTree, ray: &Ray) {
    let (expected, found) = (nearest(geometry, ray), tree.search.intersect(ray));
    let occluded = tree.search.occluded(ray);
    let same = hit_bits(found) == hit_bits(expected) && occluded == expected.is_some();
    trial.require(same, || {
        let case = format!("{}: {found:?}, occluded: {occluded}, for {expected:?}", tree.name);
        format!("{case}, {}\n{geometry:?}", bits::ray(ray))
    });
}

/// A scene of up to 60 primitives, some of which are there twice, and its size.
fn scene(random: &mut Random) -> (Geometry, f64) {
    let (count, scale) = (1 + random.below(40), random.magnitude(-6.0, 6.0));
    let mut geometry = cluster(count, scale, random);
    if random.below(4) == 0 {
        geometry.triangles.clear();
    }
    for _ in 0..random.below(20) {
        if let Some(&again) = geometry.triangles.first() {
            geometry.triangles.push(again);
        }
        let center = random.in_cube().as_vec3() * scale as f32 + geometry.vertices[0];
        let radius = (scale * random.magnitude(-3.0, 0.0)) as f32;
        geometry.spheres.push(Sphere { center, radius });
    }
    if geometry.primitives() == 0 {
        geometry.spheres.push(Sphere { center: geometry.vertices[0], radius: scale as f32 });
    }
    (geometry, scale)
}

/// Scenes of any size, up to 10⁷ times as far from the origin as they are large, and rays aimed at
/// corners, edges, faces and the outlines of spheres, along the axes and otherwise: the same primitive,
/// the same bits of t and of the weights; of equally near hits the lowest name.
///
/// Among them are spheres so far from the origin that the exact ends of their boxes are no floats. No
/// hit would be lost if those boxes were one float too small, since a ray widens every box by some more;
/// so they are looked at by themselves.
fn a_tree_finds_what_a_search_through_everything_finds(trial: &mut Trial) {
    for i in 0..trial.rays.div_ceil(PER_TREE) {
        let (geometry, size) =
            if i % 4 == 0 { distant_spheres(&mut trial.random) } else { scene(&mut trial.random) };
        boxes_enclose_spheres(trial, &geometry);
        let tree = some_tree(&geometry, &mut trial.random);
        for _ in 0..PER_TREE {
            let ray = aimed(&geometry, size, &mut trial.random).ray;
            compare(trial, &geometry, &tree, &ray);
        }
    }
}

/// Requires the box around each sphere to contain it, in double precision.
fn boxes_enclose_spheres(trial: &mut Trial, geometry: &Geometry) {
    for Item { bounds, primitive } in Item::all(geometry) {
        let Some(sphere) = geometry.sphere(primitive) else { continue };
        let (center, radius) = (sphere.center.as_dvec3(), f64::from(sphere.radius));
        let low = bounds.min.as_dvec3().cmple(center - radius);
        let high = bounds.max.as_dvec3().cmpge(center + radius);
        trial.require(low.all() && high.all(), || format!("{sphere:?} in {bounds:?}"));
    }
}

/// Spheres of a tenth to ten times the distance between floats at their place, and their spread.
fn distant_spheres(random: &mut Random) -> (Geometry, f64) {
    let place = (random.magnitude(0.0, 7.0) * random.direction()).as_vec3();
    let step = bits::ulp(place.abs().max_element());
    let sphere = |random: &mut Random| {
        let center = (place.as_dvec3() + 16.0 * step * random.in_cube()).as_vec3();
        Sphere { center, radius: (step * random.magnitude(-1.0, 1.0)) as f32 }
    };
    let spheres = (0..2 + random.below(12)).map(|_| sphere(random)).collect();
    (Geometry { spheres, ..Geometry::default() }, 16.0 * step)
}

/// No to three primitives.
fn a_tree_over_next_to_nothing_works(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let random = &mut trial.random;
        let full = content(random);
        let mut geometry = full.clone();
        geometry.triangles.truncate(random.below(3) as usize);
        geometry.spheres.truncate(random.below(2) as usize);
        let tree = some_tree(&geometry, random);
        let [leaves, inner] = [tree.shape.leaves, tree.shape.inner_nodes];
        let n = geometry.primitives() as usize;
        trial.require(leaves <= n && inner < n.max(1), || {
            format!("{}: {:?} over {n} primitives", tree.name, tree.shape)
        });
        for _ in 0..PER_TREE {
            let ray = aimed(&full, 1.0, &mut trial.random).ray;
            compare(trial, &geometry, &tree, &ray);
        }
    }
}

/// The most nodes on a way down, by the builders' own limit: 31 splits by area, 32 halvings and one by
/// kind, and the leaf itself. What a search puts off always has room.
const DEEPEST: usize = 65;

/// Up to 200 triangles whose boxes all have the same middle, or middles on a line at distances of any
/// magnitude. In the first case no plane divides them, so they are halved by count: no way down is
/// longer than log₂ n and a leaf.
fn equal_and_collinear_centres_make_no_deep_tree(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let random = &mut trial.random;
        let n = 2 + random.below(199);
        let how =
            [Aligned::Equal, Aligned::Concentric, Aligned::Scattered][random.below(3) as usize];
        let geometry = aligned(n, how, random);
        let tree = some_tree(&geometry, random);
        // Of boxes that nothing tells apart, the tree halves the number at every step.
        let limit = if how == Aligned::Equal { n.ilog2() as usize + 2 } else { DEEPEST };
        trial.require(tree.shape.depth <= limit, || {
            format!("{}: {:?} over {n} triangles, at most {limit}", tree.name, tree.shape)
        });
        for _ in 0..PER_TREE {
            let ray = aimed(&geometry, 1.0, &mut trial.random).ray;
            compare(trial, &geometry, &tree, &ray);
        }
    }
}

/// Where the middles of boxes are, and how large these are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Aligned {
    /// All at the origin, and of one size.
    Equal,
    /// All at the origin, of any size.
    Concentric,
    /// Anywhere on a line, of any size.
    Scattered,
}

/// Triangles whose boxes have their middles on a line.
fn aligned(n: u64, how: Aligned, random: &mut Random) -> Geometry {
    let way = random.direction();
    let only = random.magnitude(-3.0, 3.0) * random.direction();
    let triangle = |random: &mut Random| {
        let far = if how == Aligned::Scattered { random.magnitude(-18.0, 18.0) } else { 0.0 };
        let a = random.magnitude(-3.0, 3.0) * random.direction();
        let a = if how == Aligned::Equal { only } else { a };
        let b = a * random.in_cube();
        // a and −a are opposite corners of the box, b lies within.
        [a, -a, b].map(|p| (far * way).as_vec3() + p.as_vec3())
    };
    triangles(&(0..n).map(|_| triangle(random)).collect::<Vec<_>>())
}

/// One coordinate of one of 10⁴ triangles is NaN or ∞: the tree finds what linear search finds in the
/// other 9999.
fn a_bad_triangle_among_ten_thousand_harms_no_other(trial: &mut Trial) {
    let random = &mut trial.random;
    let some = |random: &mut Random| {
        let center = random.in_cube();
        [(); 3].map(|()| (center + 0.1 * random.in_cube()).as_vec3())
    };
    let corners: Vec<[Vec3; 3]> = (0..10_000).map(|_| some(random)).collect();
    let (mut broken, mut sound) = (triangles(&corners), triangles(&corners));
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY][random.below(3) as usize];
    let (triangle, axis) = (random.below(10_000) as usize, random.below(3) as usize);
    broken.vertices[3 * triangle + random.below(3) as usize][axis] = bad;
    // A point is never hit.
    sound.triangles[triangle] = [0; 3];
    let tree = some_tree(&broken, random);
    for _ in 0..trial.rays {
        let ray = aimed(&sound, 1.0, &mut trial.random).ray;
        compare(trial, &sound, &tree, &ray);
    }
}

/// Of some dozens of primitives, ten triangles and spheres reach to ±MAX, flat ones among them, and ten
/// to ±∞. Neither the cost of a split nor a search may become NaN: answers and depth are those of any
/// other scene, and the area of a box is a number, if perhaps ∞.
fn boxes_without_end_make_a_tree(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let random = &mut trial.random;
        let sound = cluster(30, 1.0, random);
        let mut geometry = sound.clone();
        for _ in 0..10 {
            endless(f32::MAX, &mut geometry, random);
            endless(f32::INFINITY, &mut geometry, random);
        }
        let tree = some_tree(&geometry, random);
        let sign = random.direction().as_vec3().signum();
        trial.require(tree.shape.depth <= DEEPEST, || format!("{}: {:?}", tree.name, tree.shape));
        let flat = f32::MAX * sign.with_x(0.0);
        let area = Aabb { min: flat.min(-flat), max: flat.max(-flat) }.surface_area();
        trial.require(area >= 0.0, || format!("the area of a box to ±{flat} is {area}"));
        for _ in 0..PER_TREE {
            let ray = aimed(&sound, 1.0, &mut trial.random).ray;
            compare(trial, &geometry, &tree, &ray);
        }
    }
}

/// Adds a triangle that reaches to ±`end`, or a sphere to half of that: one whose box reaches beyond
/// the largest number is left out of trees.
fn endless(end: f32, geometry: &mut Geometry, random: &mut Random) {
    if random.below(4) == 0 {
        let center = random.in_cube().as_vec3();
        geometry.spheres.push(Sphere { center, radius: 0.5 * end });
        return;
    }
    let first = geometry.vertices.len() as u32;
    let axis = random.below(3) as usize;
    for _ in 0..3 {
        let mut corner = random.in_cube().as_vec3();
        corner[axis] = end.copysign(corner[axis]);
        // Flat, so that a product of its sides may be 0 · ∞.
        corner[(axis + 1) % 3] = 0.5;
        geometry.vertices.push(corner);
    }
    geometry.triangles.push([first, first + 1, first + 2]);
}

/// Four triangles a, b, c, d at the corners of a square, so that ab|cd and ad|bc cost the same to the
/// last bit, each there once or several times, in any order, along any two axes: every one of them is
/// found, by the lowest name of its place.
fn splits_that_are_equally_good_lose_nothing(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let random = &mut trial.random;
        let axes = [[0, 1, 2], [1, 2, 0], [2, 0, 1]][random.below(3) as usize];
        let order = shuffled(4 * (1 + random.below(12)), random);
        let triangle = |&i: &u64| {
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)].map(|(x, y)| on_square(i, [x, y, 0.0], axes))
        };
        let geometry = triangles(&order.iter().map(triangle).collect::<Vec<_>>());
        let tree = some_tree(&geometry, random);
        let mut down = Vec3::ZERO;
        down[axes[2]] = -1.0;
        for i in 0..4 {
            let ray = Ray::new(on_square(i, [0.25, -0.25, 3.0], axes), down);
            let first = order.iter().position(|&place| place == i).map(|name| name as u32);
            let found = tree.search.intersect(&ray).map(|hit| hit.primitive);
            trial.require(found == first, || {
                format!("{}: {found:?} instead of {first:?} at {i} of {order:?}", tree.name)
            });
        }
        for _ in 0..PER_TREE {
            let ray = aimed(&geometry, 2.0, &mut trial.random).ray;
            compare(trial, &geometry, &tree, &ray);
        }
    }
}

/// 0, 1, 2, 3, again and again, `count` of them, in any order.
fn shuffled(count: u64, random: &mut Random) -> Vec<u64> {
    let mut order: Vec<u64> = (0..count).map(|i| i % 4).collect();
    for i in (1..order.len()).rev() {
        order.swap(i, random.below(i as u64 + 1) as usize);
    }
    order
}

/// A point beside the corner `i` of a square of side 4 in the plane of the first two `axes`.
fn on_square(i: u64, beside: [f32; 3], axes: [usize; 3]) -> Vec3 {
    let corner = [i & 1, i & 2].map(|bit| if bit == 0 { -2.0 } else { 2.0 });
    let mut point = Vec3::ZERO;
    point[axes[0]] = corner[0] + beside[0];
    point[axes[1]] = corner[1] + beside[1];
    point[axes[2]] = beside[2];
    point
}

/// Rays from the heart of a closed mesh, where each has but one triangle to hit, near the origin and at
/// two places where coordinates are coarse; anywhere, at corners and at edges; through every volume.
/// None gets out, neither of the search for the nearest hit nor of that for any.
fn no_ray_leaves_a_closed_mesh_through_any_volume(trial: &mut Trial) {
    let rays = trial.rays.div_ceil(PLACES.len() as u64);
    for center in PLACES {
        let mesh = ball(center, &mut trial.random);
        let origin = heart(&mesh, center, &mut trial.random);
        trial.require(origin.is_some(), || format!("the ball at {center} has no heart: {mesh:?}"));
        let Some(origin) = origin else { continue };
        let builder = some_builder(&mut trial.random);
        let trees: Vec<AnyTree> = (0..VOLUMES).map(|v| tree(&mesh, v, builder)).collect();
        for i in 0..rays {
            let aim = AIMS[(i % 3) as usize];
            let ray = aimed_at(&mesh, origin, aim, &mut trial.random);
            for AnyTree { name, search, .. } in &trees {
                let is_hit = search.intersect(&ray).is_some() && search.occluded(&ray);
                trial.require(is_hit, || {
                    format!("{name}: aimed {aim:?} at {center}, {}\n{mesh:?}", bits::ray(&ray))
                });
            }
        }
    }
}

/// Extents that begin and end anywhere about the hits of a ray: any hit is found if and only if there is
/// a nearest one, by the tree and by linear search.
fn something_is_hit_if_and_only_if_something_is_nearest(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let (geometry, size) = scene(&mut trial.random);
        let tree = some_tree(&geometry, &mut trial.random);
        let linear = LinearSearch::new(&geometry, &Unwatched);
        for _ in 0..PER_TREE {
            let mut ray = aimed(&geometry, size, &mut trial.random).ray;
            let whole = linear.intersect(&ray).map_or(size as f32, |hit| hit.t);
            let random = &mut trial.random;
            let mut end =
                || random.beside(whole) * [0.0, 0.5, 1.0, SQRT_2][random.below(4) as usize];
            ray.extent = Interval::new(end(), end());
            let nearest = tree.search.intersect(&ray);
            let any = [tree.search.occluded(&ray), linear.occluded(&ray)];
            trial.require(any == [nearest.is_some(); 2], || {
                let name = &tree.name;
                format!("{name}: {any:?} for {nearest:?}, {}\n{geometry:?}", bits::ray(&ray))
            });
        }
    }
}

/// An extent is closed at its far end: with that at the nearest hit the same hit is found, and one float
/// before it none at all. With the near end there, the tree answers as linear search does.
fn a_hit_at_the_very_end_of_the_extent_counts(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let (geometry, size) = scene(&mut trial.random);
        let tree = some_tree(&geometry, &mut trial.random);
        for _ in 0..PER_TREE {
            let ray = aimed(&geometry, size, &mut trial.random).ray;
            let Some(hit) = tree.search.intersect(&ray) else { continue };
            let ending = |max| Ray { extent: Interval::new(ray.extent.min, max), ..ray };
            let at = tree.search.intersect(&ending(hit.t));
            let before = tree.search.intersect(&ending(hit.t.next_down()));
            let holds = hit_bits(at) == hit_bits(Some(hit)) && before.is_none();
            trial.require(holds && tree.search.occluded(&ending(hit.t)), || {
                let found = format!("{hit:?}, {at:?} and {before:?}");
                format!("{}: {found}, {}\n{geometry:?}", tree.name, bits::ray(&ray))
            });
            for min in [hit.t.next_down(), hit.t, hit.t.next_up()] {
                let behind = Ray { extent: Interval::new(min, f32::INFINITY), ..ray };
                compare(trial, &geometry, &tree, &behind);
            }
        }
    }
}

/// A ray tests each child of a node and each primitive at most once; one that passes outside of
/// everything, by far more than rounding, the children of the root alone.
fn no_ray_tests_more_than_there_is(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_TREE) {
        let (geometry, size) = scene(&mut trial.random);
        match trial.random.below(VOLUMES) {
            0 => count::<Aabb>(trial, &geometry, size),
            1 => count::<Obb>(trial, &geometry, size),
            2 => count::<KDop<3>>(trial, &geometry, size),
            3 => count::<KDop<7>>(trial, &geometry, size),
            4 => count::<KDop<9>>(trial, &geometry, size),
            _ => count::<KDop<13>>(trial, &geometry, size),
        }
    }
}

fn count<V: BoundingVolume>(trial: &mut Trial, geometry: &Geometry, size: f64) {
    let recorder = Recorder::new();
    let builder = some_builder(&mut trial.random);
    let tree = BvTree::<V, _>::build(geometry, builder, &recorder);
    let shape = tree.shape();
    // Each node but the root is a child.
    let most = [shape.inner_nodes + shape.leaves - 1, geometry.primitives() as usize];
    let counts = || {
        [Counter::VolumeTests, Counter::PrimitiveTests]
            .map(|counter| recorder.get(counter) as usize)
    };
    for i in 0..PER_TREE {
        let mut ray = aimed(geometry, size, &mut trial.random).ray;
        let is_beside = i % 4 == 0 && shape.inner_nodes > 0;
        if is_beside {
            ray = beside(geometry, size, &mut trial.random);
        }
        for is_search in [true, false] {
            let before = counts();
            if is_search {
                tree.intersect(&ray);
            } else {
                tree.occluded(&ray);
            }
            let after = counts();
            let tested = [after[0] - before[0], after[1] - before[1]];
            let most = if is_beside { [4, 0] } else { most };
            trial.require(tested[0] <= most[0] && tested[1] <= most[1], || {
                let found = format!("{tested:?} tests, at most {most:?}, beside: {is_beside}");
                format!("{builder:?}: {found}, {}\n{geometry:?}", bits::ray(&ray))
            });
        }
    }
}

/// A ray that passes everything at a distance, along a tangent of a ball around it.
fn beside(geometry: &Geometry, size: f64, random: &mut Random) -> Ray {
    let items = Item::all(geometry);
    let bounds = items.iter().fold(Aabb::EMPTY, |all, item| all.union(&item.bounds));
    let center = bounds.min.midpoint(bounds.max).as_dvec3();
    let radius = (bounds.max - bounds.min).as_dvec3().length().max(size);
    let [out, along, _]: [DVec3; 3] = some_frame(random);
    let start = center + 4.0 * radius * out - random.between(-4.0, 4.0) * radius * along;
    let ray = Ray::new(start.as_vec3(), along.as_vec3());
    toward(ray.origin, (start + radius * along).as_vec3()).unwrap_or(ray)
}
