//! Scenes that are odd and not wrong: a picture without a sample that is not finite.

use acceptance::{Folder, STAGES};
use serde_json::Value;

use crate::scenes::{BALL, scene};

fn check(case: &str, folder: &Folder, name: &str) {
    for stage in STAGES.into_iter().filter(|&stage| stage != "workbench") {
        let arguments = format!("{name} --size 32x24 --samples 4 --quiet --stats - -o a.png");
        let output = folder.run(stage, &arguments, 0);
        let all: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        assert_eq!(all["non_finite_samples"], 0, "{case}, {stage}: {all}");
    }
}

#[test]
fn every_scene_of_the_course_is_sound() {
    let folder = Folder::with(&[]);
    for name in [
        "whitted",
        "cornell-box",
        "cornell-spheres",
        "furnace",
        "nested-glass",
        "touching-glass",
        "glass-slab",
        "two-mirrors",
    ] {
        check(name, &folder, name);
    }
}

#[test]
fn odd_scenes_are_sound() {
    let sphere = |center: [f32; 3], radius: f32, material: &str| {
        format!("[[sphere]]\ncenter = {center:?}\nradius = {radius}\nmaterial = '{material}'\n")
    };
    let light = "[[point_light]]\nposition = [0, 0, 0]\nintensity = [9, 9, 9]\n";
    let quad = "[[quad]]\nmaterial = 'white'\n\
                vertices = [[-2, -2, -1], [2, -2, -1], [2, 2, -1], [-2, 2, -1]]\n";
    let glass_quad = quad.replace("white", "glass");
    let lamp = "[materials.lamp]\nke = [5, 5, 5]\n";
    let cases = [
        ("the camera inside glass", sphere([0.0, 0.0, 5.0], 2.0, "glass") + BALL),
        ("the camera inside a white ball", sphere([0.0, 0.0, 5.0], 2.0, "white")),
        ("the camera on a surface", sphere([0.0, 0.0, 6.0], 1.0, "glass") + BALL),
        ("a light inside a surface", format!("{light}{BALL}")),
        ("a light on a surface", format!("{}{BALL}", light.replace("0, 0, 0", "0, 0, 1"))),
        ("coincident spheres", format!("{BALL}{BALL}{}", sphere([0.0; 3], 1.0, "glass"))),
        ("coincident glass", sphere([0.0; 3], 1.0, "glass").repeat(3)),
        ("coincident quads", format!("{quad}{quad}{glass_quad}")),
        (
            "the camera inside a lamp",
            lamp.to_owned() + &sphere([0.0, 0.0, 5.0], 1.0, "lamp") + BALL,
        ),
        ("a lamp inside glass", {
            lamp.to_owned() + &sphere([0.0; 3], 0.5, "lamp") + &sphere([0.0; 3], 1.0, "glass")
        }),
        ("a ball of 10⁷ and the eye on it", sphere([0.0, -1e7, 0.0], 1e7, "white")),
        ("a ball of 10⁻³⁰", sphere([0.0; 3], 1e-30, "glass")),
        ("a ball as large as numbers go", sphere([0.0; 3], 1e38, "glass")),
        ("nothing", String::new()),
    ];
    for (case, records) in cases {
        check(case, &Folder::with(&[("s.toml", &scene(&records))]), "s.toml");
    }
}

/// Refraction that bends nothing, and a glass that is thinner than the air around it.
#[test]
fn odd_glass_is_sound() {
    for ni in ["1", "0.5", "1e-3", "1e3", "1e30"] {
        let text = scene(&format!(
            "[materials.odd]\nsurface = 'glass'\nni = {ni}\n{}",
            BALL.replace("white", "odd")
        ));
        check(&format!("ni = {ni}"), &Folder::with(&[("s.toml", &text)]), "s.toml");
    }
}
