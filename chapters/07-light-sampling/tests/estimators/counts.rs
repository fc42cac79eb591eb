//! Rays that are cast, and rays that are not, counted by hand.

use glam::{Vec3, vec3};
use light_sampling::{Estimator, Settings};
use ray_casting::{Ray, Rgb, Scene};
use workbench::{Counter, MaterialRecord, Recorder};

use crate::scenes::{
    add_quad, add_sphere, dark, glass, lamp, limited, matte, mirror, point_light, watched,
};

/// How many paths are followed.
const N: u32 = 100;

/// A floor of this material, alone in the dark.
fn floor(material: MaterialRecord) -> Scene {
    let mut scene = dark([material, lamp(1.0, 0.0)]);
    let corners = [(-9.0, 9.0), (9.0, 9.0), (9.0, -9.0), (-9.0, -9.0)];
    add_quad(&mut scene, corners.map(|(x, z)| vec3(x, 0.0, z)), 0);
    scene
}

fn down() -> Ray {
    Ray::new(vec3(0.3, 1.0, 0.2), Vec3::NEG_Y)
}

/// Asserts the counts that are not 0, of N paths. Tests do not count, nor does that no surface here
/// wears a picture.
fn assert_counts(name: &str, scene: &Scene, settings: Settings, expected: &[(Counter, u64)]) {
    let recorder = Recorder::new();
    watched(scene, settings, down(), N, &recorder);
    for counter in Counter::ALL {
        let others = [Counter::VolumeTests, Counter::PrimitiveTests, Counter::TextureCoordinates];
        if others.contains(&counter) {
            continue;
        }
        let count = expected.iter().find(|(which, _)| *which == counter).map_or(0, |(_, n)| *n);
        assert_eq!(recorder.get(counter), count, "{name}: {counter:?}");
    }
}

const ALL: u64 = N as u64;

/// Every path: one shadow ray from the floor, one ray that is scattered into the void. The floor is a
/// wall, and throws no shadow.
#[test]
fn one_shadow_ray_leaves_each_hit() {
    let mut scene = floor(matte(0.5));
    scene.lights.push(point_light(vec3(1.0, 2.0, 1.0), Rgb::ONE));
    let counts = [Counter::ShadowRays, Counter::WallsLeftOut, Counter::ScatterRays];
    let counts = counts.map(|counter| (counter, ALL));
    for estimator in [Estimator::Light, Estimator::Mis] {
        assert_counts("above", &scene, limited(estimator, 9), &counts);
    }
    let counts = [(Counter::ScatterRays, ALL)];
    assert_counts("chance", &scene, limited(Estimator::Scatter, 9), &counts);
    let counts = [(Counter::PathsEndedByDepth, ALL)];
    assert_counts("depth 0", &scene, limited(Estimator::Mis, 0), &counts);
}

#[test]
fn no_shadow_ray_goes_to_a_light_behind_the_surface() {
    let mut scene = floor(matte(0.5));
    scene.lights.push(point_light(vec3(1.0, -2.0, 1.0), Rgb::ONE));
    let counts = [(Counter::ShadowRaysFacingAway, ALL), (Counter::ScatterRays, ALL)];
    assert_counts("below", &scene, limited(Estimator::Mis, 9), &counts);
}

#[test]
fn no_shadow_ray_goes_to_the_back_of_a_lamp() {
    let mut scene = floor(matte(0.5));
    let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    // Faces up; far beside the floor, so that no scattered ray meets it.
    add_quad(&mut scene, corners.map(|(x, z)| vec3(1e6 + x, 1.0, z)), 1);
    let counts = [(Counter::ShadowRaysFacingAway, ALL), (Counter::ScatterRays, ALL)];
    assert_counts("back", &scene, limited(Estimator::Mis, 1), &counts);
}

#[test]
fn no_shadow_ray_leaves_the_inside_of_a_lamp() {
    let mut scene = floor(matte(0.5));
    add_sphere(&mut scene, Vec3::ZERO, 5.0, 1);
    let counts = [
        (Counter::ShadowRaysFacingAway, ALL),
        (Counter::ScatterRays, ALL),
        (Counter::PathsEndedByDepth, ALL),
    ];
    assert_counts("inside", &scene, limited(Estimator::Mis, 1), &counts);
}

/// A red floor under a green light.
#[test]
fn no_shadow_ray_is_cast_where_nothing_could_be_reflected() {
    let mut scene = floor(MaterialRecord { kd: [0.5, 0.0, 0.0], ..matte(0.0) });
    scene.lights.push(point_light(vec3(1.0, 2.0, 1.0), vec3(0.0, 1.0, 0.0)));
    let counts = [(Counter::ShadowRaysNothingToReflect, ALL), (Counter::ScatterRays, ALL)];
    assert_counts("red", &scene, limited(Estimator::Mis, 9), &counts);

    let mut scene = floor(matte(0.0));
    scene.lights.push(point_light(vec3(1.0, 2.0, 1.0), Rgb::ONE));
    let counts = [(Counter::PathsEndedByBlack, ALL)];
    assert_counts("black", &scene, limited(Estimator::Mis, 9), &counts);
}

#[test]
fn mirrors_and_glass_ask_no_lamp() {
    let mut scene = floor(mirror(0.5));
    scene.lights.push(point_light(vec3(1.0, 2.0, 1.0), Rgb::ONE));
    let counts = [(Counter::ShadowRaysDelta, ALL), (Counter::ReflectionRays, ALL)];
    assert_counts("mirror", &scene, limited(Estimator::Mis, 9), &counts);

    // One event: 4 % are reflected, the others go down.
    let mut scene = floor(glass(1.5));
    scene.lights.push(point_light(vec3(1.0, 2.0, 1.0), Rgb::ONE));
    let recorder = Recorder::new();
    watched(&scene, limited(Estimator::Mis, 9), down(), N, &recorder);
    assert_eq!(recorder.get(Counter::ShadowRaysDelta), ALL, "glass: rays not cast");
    assert_eq!(recorder.get(Counter::ShadowRays), 0, "glass: rays cast");
    let ways = recorder.get(Counter::ReflectionRays) + recorder.get(Counter::RefractionRays);
    assert_eq!(ways, ALL, "glass: one way on for each path");
}

/// A body of index 1 is no event at all.
#[test]
fn index_1_is_no_event() {
    let scene = floor(glass(1.0));
    let counts = [(Counter::FresnelSplits, ALL)];
    assert_counts("air", &scene, limited(Estimator::Mis, 9), &counts);
}

#[test]
fn without_a_light_nothing_is_asked() {
    let scene = floor(matte(0.5));
    let counts = [(Counter::ShadowRaysFacingAway, ALL), (Counter::ScatterRays, ALL)];
    assert_counts("no light", &scene, limited(Estimator::Mis, 9), &counts);
}
