//! What the scenes look like in the light of each term.

use std::path::Path;

use blinn_phong::{Picture, Shader, Terms};
use ray_casting::{LinearSearch, Rgb, Scene};
use workbench::{FilmSettings, Image, Unwatched, expose};

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    let path = folder.join(name).with_extension("toml");
    Scene::load(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn picture(scene: &Scene, terms: Terms, settings: &FilmSettings) -> Image {
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let shader = Shader::new(scene, &pictures, &geometry, &Unwatched, terms);
    expose(settings, |point, _| shader.incident_radiance(scene.camera.ray(point)))
}

const fn settings(size: [u32; 2], samples: u32) -> FilmSettings {
    FilmSettings { size, samples, seed: 0, threads: None }
}

/// Draws the scene by all terms together and by each alone.
fn check(name: &str, settings: &FilmSettings) {
    let scene = load(name);
    for (terms, way) in [
        (Terms::All, "all"),
        (Terms::Ambient, "ambient"),
        (Terms::Diffuse, "diffuse"),
        (Terms::Specular, "specular"),
    ] {
        let image = picture(&scene, terms, settings);
        picture_snapshots::assert_picture!(&format!("{name}-{way}"), &image);
    }
}

#[test]
fn whitted() {
    check("whitted", &settings([96, 64], 4));
}

#[test]
fn teapot() {
    check("teapot", &settings([60, 40], 1));
}

#[test]
fn cornell_box() {
    let image = picture(&load("cornell-box"), Terms::All, &settings([64, 64], 4));
    picture_snapshots::assert_picture!("cornell-box", &image);
}

/// Equation 3. Without a background, which each of the four would show.
#[test]
fn the_whole_is_the_sum_of_its_terms() {
    for (name, size) in [("whitted", [48, 32]), ("teapot", [30, 20]), ("cornell-box", [32, 32])] {
        let scene = Scene { background: Rgb::ZERO, ..load(name) };
        let draw = |terms| picture(&scene, terms, &settings(size, 1)).pixels;
        let [all, ambient, diffuse, specular] =
            [Terms::All, Terms::Ambient, Terms::Diffuse, Terms::Specular].map(draw);
        for (i, whole) in all.into_iter().enumerate() {
            let sum: Rgb = [ambient[i], diffuse[i], specular[i]].map(Rgb::from_array).iter().sum();
            let error = (Rgb::from_array(whole) - sum).abs().max_element();
            let bound = 8.0 * f32::EPSILON * sum.max_element();
            assert!(error <= bound, "{name}, pixel {i}: {whole:?} for {sum}");
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let scene = load("whitted");
    let hashes = [1, 2, 5].map(|threads| {
        let settings = FilmSettings { threads: Some(threads), ..settings([37, 29], 3) };
        picture(&scene, Terms::All, &settings).hash()
    });
    assert_eq!(hashes, [hashes[0]; 3], "1, 2, 5 threads");
}
