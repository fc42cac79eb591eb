//! Degenerate input makes no deep trees and loses nothing.

use bv_tree::{Aabb, KDop, Obb, Shape};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, Ray, Sphere};
use workbench::Sampler;

use crate::tools::{BUILDERS, check_hits, in_cube, rays, soup, tree, triangles};

/// No tree may be deeper: the traversal's stack would not hold it.
const DEEPEST: usize = 64;

fn check_shape(shape: Shape, primitives: usize, case: &str) {
    let most = 3 * shape.inner_nodes + 1; // each node puts up to four children in place of one
    assert!(shape.inner_nodes < shape.leaves && shape.leaves <= most, "{case}: {shape:?}");
    assert!(shape.leaves <= primitives, "{case}: {shape:?} of {primitives} primitives");
    assert!(shape.depth <= DEEPEST, "{case}: {shape:?}");
}

/// accuracy V2, B12: a tree over nothing, or over nothing that could be hit, tests nothing.
#[test]
fn a_tree_over_nothing_has_no_nodes() {
    let mut nan = soup(3, 1.0);
    nan.vertices.fill(Vec3::NAN);
    for (case, geometry) in [("nothing", Geometry::default()), ("NaN", nan)] {
        for builder in BUILDERS {
            let tree = tree::<Aabb>(&geometry, builder);
            assert_eq!((tree.shape().inner_nodes, tree.shape().leaves), (0, 0), "{case}");
            for ray in rays(100) {
                assert_eq!(tree.intersect(&ray), None, "{case}: {ray:?}");
                assert!(!tree.occluded(&ray), "{case}: {ray:?}");
            }
        }
    }
}

/// accuracy V2.
#[test]
fn one_and_two_primitives_make_trees() {
    for count in [1, 2, 3] {
        let geometry = soup(count, 0.5);
        let rays: Vec<Ray> = rays(2000).collect();
        check_hits(&geometry, &rays, &format!("{count} triangles"));
        for builder in BUILDERS {
            check_shape(tree::<Obb>(&geometry, builder).shape(), count as usize, "a small tree");
        }
    }
}

/// accuracy V3: 10⁵ triangles in the same place; the first one is hit.
#[test]
fn identical_triangles_make_a_shallow_tree() {
    let count: usize = 100_000;
    let geometry = triangles(vec![[Vec3::X, Vec3::Y, Vec3::Z]; count]);
    for builder in BUILDERS {
        let tree = tree::<Aabb>(&geometry, builder);
        let shape = tree.shape();
        check_shape(shape, count, "identical triangles");
        let limit = 2 * count.ilog2() as usize + 2;
        assert!(shape.depth <= limit, "{builder:?}: {shape:?}, deeper than {limit}");
        let hit = tree.intersect(&Ray::new(Vec3::ZERO, Vec3::ONE.normalize()));
        assert_eq!(hit.map(|hit| hit.primitive), Some(0), "{builder:?}: {hit:?}");
    }
}

/// accuracy V4, V8.
#[test]
fn unequal_distances_make_no_deep_tree() {
    let at = |x: f32| [vec3(x, -1.0, -1.0), vec3(x, 1.0, -1.0), vec3(x, 0.0, 2.0)];
    let cases: [(&str, Vec<f32>); 4] = [
        ("powers of two", (-60..=60).map(|i| 2.0_f32.powi(i)).collect()),
        ("all powers of two", (-148..=126).map(|i| 2.0_f64.powi(i) as f32).collect()),
        ("powers of four, thrice", (0..180).map(|i| 4.0_f32.powi(i / 3 - 30)).collect()),
        ("a line", (0..5000_u16).map(f32::from).collect()),
    ];
    for (case, places) in cases {
        let geometry = triangles(places.iter().map(|&x| at(x)));
        for builder in BUILDERS {
            let shape = tree::<Aabb>(&geometry, builder).shape();
            check_shape(shape, places.len(), &format!("{case}, {builder:?}"));
        }
        let aimed: Vec<Ray> = places
            .iter()
            .flat_map(|&x| {
                let beside = Ray::new(vec3(x.next_down(), 0.0, 0.0), Vec3::X);
                [beside, Ray::new(vec3(x.next_up(), 0.1, 0.1), Vec3::NEG_X)]
            })
            .take(400)
            .collect();
        check_hits(&geometry, &aimed, case);
    }
}

/// accuracy V5: one bad triangle among many does not harm the others.
#[test]
fn a_triangle_of_nan_harms_no_other() {
    let mut geometry = soup(2000, 0.05);
    let sound = tree::<Aabb>(&geometry, BUILDERS[1]).shape();
    geometry.vertices[3001].y = f32::NAN;
    check_hits(&geometry, &rays(2000).collect::<Vec<_>>(), "a NaN among 2000");
    let shape = tree::<Aabb>(&geometry, BUILDERS[1]).shape();
    let growth = shape.depth.abs_diff(sound.depth);
    assert!(growth <= 3, "{shape:?} with a NaN, {sound:?} without");
}

/// accuracy V6: areas overflow; nothing else may.
#[test]
fn the_largest_numbers_make_a_tree() {
    let mut geometry = soup(200, 0.3);
    for i in 0..10 {
        let sign = if i % 2 == 0 { f32::MAX } else { f32::MIN };
        geometry.vertices[30 * i] = Vec3::splat(sign);
    }
    check_hits(&geometry, &rays(1000).collect::<Vec<_>>(), "triangles to the end of the world");
    for builder in BUILDERS {
        check_shape(tree::<Aabb>(&geometry, builder).shape(), 200, "the largest numbers");
        check_shape(tree::<Obb>(&geometry, builder).shape(), 200, "the largest numbers");
        check_shape(tree::<KDop<13>>(&geometry, builder).shape(), 200, "the largest numbers");
    }
}

/// accuracy B13: rays along the common faces of many boxes, through triangles' edges on those
/// faces.
#[test]
fn a_ray_in_the_faces_of_boxes_finds_the_edges_there() {
    let tent = |x: f32, y: f32, z: f32| {
        let corner = vec3(x, y, z);
        [corner, corner + Vec3::Y, corner + vec3(-0.5, 0.5, 0.25)]
    };
    let cells =
        (0..6_u8).flat_map(|x| (0..6_u8).flat_map(move |y| (0..6_u8).map(move |z| [x, y, z])));
    let geometry = triangles(cells.map(|cell| {
        let [x, y, z] = cell.map(f32::from);
        tent(x, y, z)
    }));
    let mut aimed = Vec::new();
    for (x, y) in (0..6_u8).flat_map(|x| (0..6_u8).map(move |y| (f32::from(x), f32::from(y)))) {
        for zero in [0.0, -0.0] {
            aimed.push(Ray::new(vec3(x, y + 0.25, -1.0), vec3(zero, zero, 1.0)));
            aimed.push(Ray::new(vec3(x, y, 7.0), vec3(zero, -zero, -1.0)));
        }
    }
    for ray in &aimed {
        let hit = tree::<Aabb>(&geometry, BUILDERS[1]).intersect(ray);
        assert!(hit.is_some(), "{ray:?} misses the edges on its way");
    }
    check_hits(&geometry, &aimed, "rays along faces");
}

/// accuracy V3 for spheres, and leaves of one kind.
#[test]
fn triangles_and_spheres_in_one_place_are_kept_apart() {
    let mut geometry = triangles(vec![[Vec3::X, Vec3::Y, Vec3::Z]; 5]);
    let sphere = Sphere { center: Vec3::splat(1.0 / 3.0), radius: 0.4 };
    geometry.spheres = vec![sphere; 5];
    check_hits(&geometry, &rays(2000).collect::<Vec<_>>(), "five and five");
    let mut sampler = Sampler::new(3, 0, 0);
    let cloud = |_| Sphere { center: in_cube(&mut sampler), radius: 0.05 };
    let spheres = Geometry { spheres: (0..500).map(cloud).collect(), ..Geometry::default() };
    check_hits(&spheres, &rays(2000).collect::<Vec<_>>(), "a cloud of spheres");
}
