//! What is a light, and what is none.

use std::fs;

use glam::{Vec3, vec3};
use light_sampling::{Light, Lights};
use ray_casting::{Rgb, Scene};
use workbench::Sampler;

use crate::scenes::{
    LAMP, MATTE, add_point_light, add_quad, add_sphere, add_triangle, empty, viewer,
};

/// A scene from text, with a lamp and a matte material.
fn from_text(records: &str) -> Result<Scene, String> {
    let camera = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [4, 3]\n\
                  [materials.white]\nkd = [1, 1, 1]\n[materials.lamp]\nke = [1, 2, 4]\n\
                  [materials.off]\nke = [0, 0, 0]\n";
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("{camera}{records}")).expect("the scene is written");
    Scene::load(&path).map_err(|error| error.to_string())
}

#[test]
fn what_is_black_is_no_light() {
    let mut scene = empty();
    add_triangle(&mut scene, [Vec3::ZERO, Vec3::X, Vec3::Y], MATTE);
    add_sphere(&mut scene, Vec3::ONE, 0.5, LAMP);
    add_point_light(&mut scene, Vec3::ONE, 0.0);
    let lights = Lights::new(&scene);
    assert_eq!(lights.all().len(), 1, "{:?}", lights.all());

    let off = from_text("[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"off\"\n");
    let lights = Lights::new(&off.expect("a scene"));
    assert!(lights.all().is_empty(), "{:?}", lights.all());
    let nothing = lights.sample(&viewer(Vec3::ZERO, Vec3::Z), &mut Sampler::new(0, 0, 0));
    assert!(nothing.is_none(), "{nothing:?} without a light");
}

/// A quad of which one half, or all, has no area: the loader drops it, or says what is wrong.
#[test]
fn a_lamp_without_area_is_dropped() {
    let half = "[[quad]]\nvertices = [[0,0,0], [1,0,0], [1,0,0], [0,0,1]]\nmaterial = \"lamp\"\n";
    let line = "[[quad]]\nvertices = [[0,0,0], [1,0,0], [2,0,0], [3,0,0]]\nmaterial = \"lamp\"\n";
    for (records, most) in [(half, 1), (line, 0)] {
        let Ok(scene) = from_text(records) else { continue };
        let lights = Lights::new(&scene);
        assert!(lights.all().len() <= most, "{records}: {:?}", lights.all());
    }
}

#[test]
fn a_scene_made_by_hand_may_have_lamps_without_area() {
    let line = [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X];
    let mut scene = empty();
    add_triangle(&mut scene, line, LAMP);
    add_triangle(&mut scene, [vec3(0.0, 0.0, 1.0), Vec3::X, Vec3::Y], LAMP);
    let lights = Lights::new(&scene);
    let mut sampler = Sampler::new(0, 0, 0);
    for _ in 0..1000 {
        let sample =
            lights.sample(&viewer(vec3(2.0, 2.0, 2.0), Vec3::NEG_ONE.normalize()), &mut sampler);
        let Some(sample) = sample else { continue };
        let sound = sample.wi.is_finite() && sample.pdf_solid_angle.is_finite();
        assert!(sound && sample.pdf_solid_angle > 0.0, "{sample:?}");
    }
}

/// The order in which they are numbered, and what each sends out: π A Lₑ, 4π I, and the sky
/// through the disk around the scene.
#[test]
fn lights_send_what_physics_says() {
    let mut scene = empty();
    add_triangle(&mut scene, [Vec3::ZERO, 2.0 * Vec3::X, 2.0 * Vec3::Y], LAMP);
    add_sphere(&mut scene, vec3(0.0, 0.0, 9.0), 0.5, LAMP);
    add_point_light(&mut scene, Vec3::ONE, 1.0);
    scene.background = Rgb::ONE;
    let lights = Lights::new(&scene);
    let pi = std::f64::consts::PI;
    let radius = 3.0;
    let expected = [3.0 * pi * 2.0, 3.0 * pi * pi, 3.0 * 4.0 * pi * pi, 3.0 * 4.0 * pi * pi * 9.0];
    let powers: Vec<f64> = lights.all().iter().map(|light| light.power(radius)).collect();
    assert_eq!(powers.len(), 4, "{:?}", lights.all());
    for (power, expected) in powers.iter().zip(expected) {
        assert!((power / expected - 1.0).abs() < 1e-6, "{powers:?}, expected {expected}");
    }
    assert!(matches!(lights.all()[3], Light::Sky { .. }), "the sky comes last");
}

/// A quad of the scene file is two triangles, and one light if it is a parallelogram of one material.
#[test]
fn the_two_halves_of_a_parallelogram_are_one_light() {
    let corners = [Vec3::ZERO, Vec3::X, vec3(1.5, 0.5, 0.25), vec3(0.5, 0.5, 0.25)];
    let mut bent = corners;
    bent[2].y += 0.125;
    for (name, corners, lights) in [("parallelogram", corners, 1), ("bent", bent, 2)] {
        let mut scene = empty();
        add_quad(&mut scene, corners, LAMP);
        assert_eq!(Lights::new(&scene).all().len(), lights, "{name}: {corners:?}");
        scene.attributes.materials[1] = MATTE;
        assert_eq!(Lights::new(&scene).all().len(), 1, "{name}, one half matte");
    }
    // Three triangles in a row of which any two are halves: the first two are, the third is alone.
    let mut scene = empty();
    add_quad(&mut scene, corners, LAMP);
    scene.geometry.triangles.push([0, 3, 1]);
    scene.attributes.materials.push(LAMP);
    let lights = Lights::new(&scene);
    assert_eq!(lights.all().len(), 2, "{:?}", lights.all());

    // Its area and its power are those of both, and a path that meets either half is told so.
    let area = Vec3::X.cross(corners[3]).length();
    let power = 3.0 * std::f64::consts::PI * f64::from(area);
    let mut scene = empty();
    add_quad(&mut scene, corners, LAMP);
    let lights = Lights::new(&scene);
    assert!((lights.all()[0].power(1.0) / power - 1.0).abs() < 1e-6, "{:?}", lights.all());
    let from = vec3(0.75, -20.0, 30.0);
    for (half, point) in
        [(0, (corners[1] + corners[2]) / 3.0), (1, (corners[2] + corners[3]) / 3.0)]
    {
        let wi = (point - from).normalize();
        let lamp = crate::scenes::seen(half, point, Vec3::Z, wi);
        let pdf = lights.pdf_of_lamp(from, Vec3::NEG_Z, &lamp);
        let normal = Vec3::X.cross(corners[3]).normalize();
        let expected = point.distance_squared(from) / (area * -normal.dot(wi));
        assert!((pdf / expected - 1.0).abs() < 1e-5, "half {half}: {pdf}, expected {expected}");
    }
}
