//! Which light reaches a surface, and what it becomes there; counted exactly.

use std::fs;

use blinn_phong::{Picture, Shader, Terms};
use glam::{Vec3, vec3};
use ray_casting::{LinearSearch, Ray, Rgb, Scene};
use workbench::{Counter, Recorder, Unwatched};

/// A white floor, seen from anywhere; its ambient light is ⅛.
const FLOOR: &str = "ambient = [0.125, 0.125, 0.125]\nbackground = [0.25, 0.5, 0.75]\n\
    [camera]\neye = [0, 1, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [4, 3]\n\
    [materials.white]\nkd = [1, 1, 1]\n\
    [materials.shiny]\nks = [1, 1, 1]\nns = 8\n\
    [materials.black]\n\
    [[quad]]\nmaterial = 'white'\nvertices = [[-9, 0, 9], [9, 0, 9], [9, 0, -9], [-9, 0, -9]]\n";

fn scene_with_mesh(records: &str, obj: &str) -> Scene {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("a.obj"), obj).expect("the mesh is written");
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("{FLOOR}{records}")).expect("the scene is written");
    Scene::load(&path).unwrap_or_else(|error| panic!("{error}, for:\n{records}"))
}

fn scene(records: &str) -> Scene {
    scene_with_mesh(records, "")
}

fn light(position: [f32; 3], intensity: f32) -> String {
    format!("[[point_light]]\nposition = {position:?}\nintensity = {:?}\n", [intensity; 3])
}

/// The radiance along a ray, and what was counted on the way.
fn look(scene: &Scene, terms: Terms, ray: Ray) -> (Rgb, Recorder) {
    let recorder = Recorder::new();
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = LinearSearch::new(&scene.geometry, &recorder);
    let radiance =
        Shader::new(scene, &pictures, &geometry, &recorder, terms).incident_radiance(ray);
    (radiance, recorder)
}

/// The same straight down onto (`x`, 0, 0), from below all lights.
fn floor(scene: &Scene, terms: Terms, x: f32) -> (f32, Recorder) {
    let (radiance, recorder) = look(scene, terms, Ray::new(vec3(x, 0.5, 0.0), Vec3::NEG_Y));
    (radiance.x, recorder)
}

/// Traced, facing away, nothing to reflect.
fn shadow_rays(recorder: &Recorder) -> [u64; 3] {
    [Counter::ShadowRays, Counter::ShadowRaysFacingAway, Counter::ShadowRaysNothingToReflect]
        .map(|counter| recorder.get(counter))
}

#[test]
fn a_ray_that_leaves_the_scene_finds_the_background() {
    let scene = scene(&light([0.0, 2.0, 0.0], 4.0));
    let (radiance, recorder) = look(&scene, Terms::All, Ray::new(Vec3::Y, Vec3::Y));
    assert_eq!(radiance, Rgb::new(0.25, 0.5, 0.75), "the background, without ambient light");
    assert_eq!(shadow_rays(&recorder), [0; 3], "shadow rays");
}

/// Two lights at heights 2 and 4 with I = 4 and 8: 4/4 + 8/16, and ⅛ of ambient light.
#[test]
fn the_lights_and_the_ambient_term_add_up() {
    let lights = light([0.0, 2.0, 0.0], 4.0) + &light([0.0, 4.0, 0.0], 8.0);
    let scene = scene(&lights);
    for (terms, expected, rays) in [
        (Terms::All, 1.625, [2, 0, 0]),
        (Terms::Diffuse, 1.5, [2, 0, 0]),
        (Terms::Ambient, 0.125, [0, 0, 2]),
        (Terms::Specular, 0.0, [0, 0, 2]),
    ] {
        let (radiance, recorder) = floor(&scene, terms, 0.0);
        let error = (radiance - expected).abs();
        assert!(error <= 2.0 * f32::EPSILON, "{terms:?}: {radiance} for {expected}");
        assert_eq!(shadow_rays(&recorder), rays, "shadow rays of {terms:?}");
    }
}

/// accuracy BP11: (½ I) / 5^1.5 of a floor 2 beside a light at height 1.
#[test]
fn a_floor_falls_off_with_the_fifth_power_of_the_slant() {
    let scene = scene(&light([0.0, 1.0, 0.0], 0.5));
    let (radiance, _) = floor(&scene, Terms::Diffuse, 2.0);
    let expected = 0.044_721_36;
    let error = (radiance - expected).abs() / expected;
    assert!(error <= 4.0 * f32::EPSILON, "{radiance} for {expected}");
}

#[test]
fn each_light_has_its_own_shadow() {
    let lights = light([-4.0, 4.0, 0.0], 32.0) + &light([4.0, 4.0, 0.0], 64.0);
    let ball = "[[sphere]]\ncenter = [0, 2, 0]\nradius = 0.5\nmaterial = 'white'\n";
    let scene = scene(&format!("{lights}{ball}"));
    let lit = |x: f32, from: f32, intensity: f32| {
        let r_squared = (x - from) * (x - from) + 16.0;
        intensity / r_squared * 4.0 / r_squared.sqrt()
    };
    for (x, first, second) in [(0.0, true, true), (4.0, false, true), (-4.0, true, false)] {
        let (radiance, recorder) = floor(&scene, Terms::Diffuse, x);
        let expected = if first { lit(x, -4.0, 32.0) } else { 0.0 }
            + if second { lit(x, 4.0, 64.0) } else { 0.0 };
        let error = (radiance - expected).abs();
        assert!(error <= 1e-6, "x = {x}: {radiance} for {expected}");
        assert_eq!(shadow_rays(&recorder), [2, 0, 0], "shadow rays at x = {x}");
    }
}

/// accuracy BP12: a surface reflects on both sides, and each sees its own light.
#[test]
fn a_light_below_the_floor_casts_no_shadow_ray() {
    let scene = scene(&(light([0.0, -2.0, 0.0], 4.0) + &light([0.0, 2.0, 0.0], 4.0)));
    let (radiance, recorder) = floor(&scene, Terms::Diffuse, 0.0);
    assert_eq!(radiance, 1.0, "the light above alone");
    assert_eq!(shadow_rays(&recorder), [1, 1, 0], "shadow rays from above");
    let below = Ray::new(vec3(1.0, -0.5, 0.0), Vec3::Y);
    let (radiance, recorder) = look(&scene, Terms::Diffuse, below);
    let expected = 4.0 / 5.0 * 2.0 / 5.0_f32.sqrt();
    assert!((radiance.x - expected).abs() <= 1e-6, "{} for {expected}", radiance.x);
    assert_eq!(shadow_rays(&recorder), [1, 1, 0], "shadow rays from below");
}

#[test]
fn a_black_surface_asks_for_no_shadow() {
    let lights = light([0.0, 4.0, 0.0], 4.0) + &light([1.0, 4.0, 0.0], 4.0);
    let table = "[[quad]]\nmaterial = 'black'\n\
                 vertices = [[-1, 1, 1], [1, 1, 1], [1, 1, -1], [-1, 1, -1]]\n";
    let scene = scene(&format!("{lights}{table}"));
    let ray = Ray::new(vec3(0.0, 2.0, 0.0), Vec3::NEG_Y);
    let (radiance, recorder) = look(&scene, Terms::All, ray);
    assert_eq!(radiance, Rgb::splat(0.125), "ambient light alone");
    assert_eq!(shadow_rays(&recorder), [0, 0, 2], "shadow rays");
}

/// A surface with nothing but a highlight, drawn with it and without.
#[test]
fn a_term_that_is_not_drawn_asks_for_no_shadow() {
    let table = "[[quad]]\nmaterial = 'shiny'\n\
                 vertices = [[-1, 1, 1], [1, 1, 1], [1, 1, -1], [-1, 1, -1]]\n";
    let scene = scene(&format!("{}{table}", light([0.0, 3.0, 0.0], 4.0)));
    let ray = Ray::new(vec3(0.0, 2.0, 0.0), Vec3::NEG_Y);
    let (radiance, recorder) = look(&scene, Terms::All, ray);
    assert_eq!(radiance, Rgb::splat(1.125), "I / r² in the mirror direction, and ambient light");
    assert_eq!(shadow_rays(&recorder), [1, 0, 0], "shadow rays of the highlight");
    let (radiance, recorder) = look(&scene, Terms::Diffuse, ray);
    assert_eq!(radiance, Rgb::ZERO, "its diffuse part");
    assert_eq!(shadow_rays(&recorder), [0, 0, 1], "shadow rays without the highlight");
}

/// A triangle whose vertex normals lean far to one side: they shade it, but whether a light is in
/// front is asked of the triangle itself.
#[test]
fn interpolated_normals_shade_and_geometric_ones_decide_visibility() {
    let obj = "v -1 1 1\nv 1 1 1\nv 0 1 -1\nvn 0.8 0.6 0\nf 1//1 2//1 3//1\n";
    let mesh = "[[mesh]]\nfile = 'a.obj'\nmaterial = 'white'\n";
    let radiance = |position: [f32; 3]| {
        let scene = scene_with_mesh(&(light(position, 4.0) + mesh), obj);
        look(&scene, Terms::Diffuse, Ray::new(vec3(0.0, 1.5, 0.0), Vec3::NEG_Y))
    };
    let (above, recorder) = radiance([0.0, 3.0, 0.0]);
    assert!((above.x - 0.6).abs() <= 1e-6, "n·l by the interpolated normal is {}", above.x);
    assert_eq!(shadow_rays(&recorder), [1, 0, 0], "shadow rays to the light above");

    let (aside, recorder) = radiance([2.0, 0.9, 0.0]);
    assert_eq!(aside, Rgb::ZERO, "a light below the triangle, in front of the leaning normal");
    assert_eq!(shadow_rays(&recorder), [0, 1, 0], "shadow rays to the light below");

    let (behind, recorder) = radiance([-3.0, 1.5, 0.0]);
    assert_eq!(behind, Rgb::ZERO, "a light above the triangle, behind the leaning normal");
    assert_eq!(shadow_rays(&recorder), [0, 0, 1], "shadow rays to the light behind");
}

/// accuracy BP8: a light on the surface itself.
#[test]
fn a_light_on_the_surface_leaves_no_trace() {
    let scene = scene(&light([1.0, 0.0, 0.0], 4.0));
    for x in [1.0, 1.0 + f32::EPSILON, 1.001, 0.0] {
        let (radiance, _) = floor(&scene, Terms::All, x);
        assert_eq!(radiance, 0.125, "at x = {x}: ambient light alone");
    }
}

/// Without a probe nothing else changes: the radiance of a watched render is that of an unwatched
/// one.
#[test]
fn watching_changes_no_bit() {
    let scene = scene(&(light([-4.0, 4.0, 0.0], 32.0) + &light([4.0, 4.0, 0.0], 64.0)));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let shader = Shader::new(&scene, &[], &geometry, &Unwatched, Terms::All);
    for i in -20..20_i16 {
        let ray = Ray::new(vec3(f32::from(i) / 3.0, 0.5, 0.0), Vec3::NEG_Y);
        let (watched, _) = look(&scene, Terms::All, ray);
        assert_eq!(shader.incident_radiance(ray), watched, "along {ray:?}");
    }
}
