//! Lamps behind glass: no shadow ray gets there, so what chance finds must count in full.

use glam::{Vec3, vec3};
use ray_casting::{Ray, Scene};
use statistics::{assert_mean, assert_same_mean};
use workbench::MaterialRecord;

use crate::scenes::{
    ESTIMATORS, add_block, add_quad, add_sphere, at_receiver, dark, endless, glass, lamp, limited,
    matte, radiance, receiver,
};

/// A sphere lamp of radiance 1 at distance 3, inside a body of index 1, which is nothing.
#[test]
fn glass_of_index_1_changes_no_light() {
    let mut in_ball = receiver([lamp(1.0, 0.0), glass(1.0)]);
    add_sphere(&mut in_ball, vec3(0.0, 3.0, 0.0), 1.0, 1);
    add_sphere(&mut in_ball, vec3(0.0, 3.0, 0.0), 1.5, 2);
    let mut behind_block = receiver([lamp(1.0, 0.0), glass(1.0)]);
    add_block(&mut behind_block, vec3(-9.0, 0.5, -9.0), vec3(9.0, 1.0, 9.0), 2);
    add_sphere(&mut behind_block, vec3(0.0, 3.0, 0.0), 1.0, 1);
    // Half of the lamp is behind the glass, half of it in the open: each part counts once.
    let mut half = receiver([lamp(1.0, 0.0), glass(1.0)]);
    add_block(&mut half, vec3(0.0, 0.5, -9.0), vec3(9.0, 1.0, 9.0), 2);
    add_sphere(&mut half, vec3(0.0, 3.0, 0.0), 1.0, 1);
    for (name, scene) in [("ball", in_ball), ("block", behind_block), ("half", half)] {
        for estimator in ESTIMATORS {
            // One event, at the receiver: a face of index 1 is none.
            let samples = radiance(&scene, limited(estimator, 1), at_receiver(), 150_000);
            let bias = assert_mean(&format!("{name}, {estimator:?}"), &samples, 1.0 / 9.0);
            assert!(bias <= 0.06, "{name}, {estimator:?}: only {bias} would be seen");
        }
    }
}

/// A floor under a square lamp, and what `add_body` puts between them.
fn lit_through(add_body: impl FnOnce(&mut Scene), materials: Vec<MaterialRecord>) -> Scene {
    let mut scene = dark([matte(0.8), lamp(3.0, 0.3)].into_iter().chain(materials));
    let square = |size: f32, y: f32| {
        [(-size, size), (size, size), (size, -size), (-size, -size)].map(|(x, z)| vec3(x, y, z))
    };
    add_quad(&mut scene, square(3.0, 0.0), 0);
    let [a, b, c, d] = square(1.5, 2.0);
    add_quad(&mut scene, [d, c, b, a], 1);
    add_body(&mut scene);
    scene
}

/// Nested and touching bodies: wherever the lamp is found by chance only, all estimators agree.
#[test]
fn all_estimators_agree_below_glass_in_glass_and_beside_glass() {
    let eye = vec3(-2.0, 0.3, 0.9);
    let ray = Ray::new(eye, (vec3(0.1, 0.0, 0.2) - eye).normalize());
    let nested = lit_through(
        |scene| {
            add_sphere(scene, vec3(0.0, 1.0, 0.0), 0.6, 2);
            add_sphere(scene, vec3(0.0, 1.0, 0.0), 0.3, 3);
        },
        vec![glass(1.5), glass(2.4)],
    );
    let touching = lit_through(
        |scene| {
            add_block(scene, vec3(-1.0, 0.4, -1.0), vec3(0.1, 0.9, 1.0), 2);
            add_block(scene, vec3(0.1, 0.4, -1.0), vec3(1.0, 0.9, 1.0), 2);
        },
        vec![glass(1.5)],
    );
    for (name, scene) in [("nested", nested), ("touching", touching)] {
        let [scatter, light, mis] =
            ESTIMATORS.map(|estimator| radiance(&scene, endless(estimator), ray, 100_000));
        for (pair, other) in [("light", &light), ("mis", &mis)] {
            let bias = assert_same_mean(&format!("{name}, {pair}"), other, &scatter);
            assert!(bias <= 0.05, "{name}, {pair}: only {bias} would be seen");
        }
        let bias = assert_same_mean(&format!("{name}, both"), &light, &mis);
        assert!(bias <= 0.05, "{name}: only {bias} would be seen");
    }
}

/// A lamp that lies in glass, seen from the eye through one boundary: T = 0.96, once, and radiance
/// is the same again outside.
#[test]
fn a_lamp_in_glass_is_seen_with_what_the_boundary_lets_through() {
    let mut scene = dark([lamp(1.0, 0.0), glass(1.5)]);
    add_block(&mut scene, vec3(-1.0, -1.0, -1.0), vec3(1.0, 1.0, 1.0), 1);
    add_sphere(&mut scene, Vec3::ZERO, 0.5, 0);
    let ray = Ray::new(vec3(0.01, 0.02, 5.0), Vec3::NEG_Z);
    for estimator in ESTIMATORS {
        let samples = radiance(&scene, endless(estimator), ray, 40_000);
        let expected = 0.96 / (1.5 * 1.5);
        assert_mean(&format!("{estimator:?}"), &samples, expected);
    }
}
