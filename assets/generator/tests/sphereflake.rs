//! Facts about the sphereflake.

use generator::{Sphere, sphereflake, write_sphereflake};

fn distance(a: Sphere, b: Sphere) -> f64 {
    let squares = [0, 1, 2].map(|k| (f64::from(a.center[k]) - f64::from(b.center[k])).powi(2));
    squares.iter().sum::<f64>().sqrt()
}

#[test]
fn depth_d_has_an_eighth_of_9_to_the_d_plus_1_minus_1_spheres() {
    for (depth, count) in [(0, 1), (1, 10), (2, 91), (3, 820), (4, 7381)] {
        assert_eq!(sphereflake(depth).len(), count, "spheres of depth {depth}");
    }
}

/// Depth-first order: a sphere's parent is the last one before it that is larger.
#[test]
fn every_sphere_touches_its_parent() {
    let flake = sphereflake(4);
    for (i, &child) in flake.iter().enumerate().skip(1) {
        let parents = flake[..i].iter().rev();
        let parent = *parents.clone().find(|s| s.radius > child.radius).expect("a larger one");
        let gap = distance(parent, child) - f64::from(parent.radius + child.radius);
        assert!(gap.abs() < 2e-7, "sphere {i} is {gap} off its parent");
        let shrink = child.radius / parent.radius;
        assert!((shrink - 1.0 / 3.0).abs() < 1e-6, "sphere {i} is {shrink} of its parent");
    }
}

/// Haines' arrangement in words: six around the waist, three above, none below.
#[test]
fn six_children_lie_on_the_equator_and_three_above() {
    let flake = sphereflake(1);
    let heights: Vec<f32> = flake[1..].iter().map(|child| child.center[2]).collect();
    let above = 2.0 / 3.0 * (2.0_f32 / 3.0).sqrt();
    assert!(heights[..6].iter().all(|&z| z == 0.0), "on the equator: {heights:?}");
    assert!(heights[6..].iter().all(|z| (z - above).abs() < 1e-6), "above: {heights:?}");
    for a in 1..10 {
        for b in a + 1..10 {
            let gap = distance(flake[a], flake[b]) - 1.0 / 3.0;
            assert!(gap > 0.2, "children {a} and {b} are {gap} apart");
        }
    }
}

#[test]
fn the_flake_rests_on_the_ground_and_fits_into_the_unit_sphere() {
    for Sphere { center: [x, y, z], radius } in sphereflake(5) {
        assert!(z - radius >= -0.5, "a sphere at ({x}, {y}, {z}) reaches below the ground");
        let reach = (x * x + y * y + z * z).sqrt() + radius;
        assert!(reach <= 1.0, "a sphere at ({x}, {y}, {z}) reaches out to {reach}");
    }
}

#[test]
fn the_scene_file_holds_every_sphere_bit_for_bit() {
    let mut text = Vec::new();
    write_sphereflake(&mut text, 3).expect("a Vec takes everything");
    let text = String::from_utf8(text).expect("the file is UTF-8");
    let scene = workbench::SceneFile::parse("flake.toml".as_ref(), &text).expect("a scene");
    let read = scene.spheres.iter().map(|s| Sphere { center: s.center, radius: s.radius });
    assert_eq!(read.collect::<Vec<_>>(), sphereflake(3), "spheres of depth 3");
}
