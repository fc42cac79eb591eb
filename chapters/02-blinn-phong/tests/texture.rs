//! How a picture is read between its texels.

use std::fs;
use std::path::PathBuf;

use blinn_phong::Picture;
use glam::{Vec2, vec2};
use ray_casting::{Rgb, Scene};
use workbench::{Image, srgb};

const WIDTH: u32 = 4;
const HEIGHT: u32 = 2;

/// sRGB red of the texel in this column and row; each is another.
fn code(column: u32, row: u32) -> u8 {
    (20 + 29 * (row * WIDTH + column)) as u8
}

/// Its linear value.
fn red(column: u32, row: u32) -> f32 {
    srgb::decode(code(column, row))
}

/// A picture of 4 × 2 texels, all different.
fn picture() -> Picture {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| -> PathBuf { folder.path().join(name) };
    let texels = (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (column, row)));
    let bytes: Vec<u8> = texels.flat_map(|(column, row)| [code(column, row), 0, 255]).collect();
    let saved = Image::from_srgb8(WIDTH, HEIGHT, &bytes).save(&path("texture.png"));
    saved.unwrap_or_else(|error| panic!("{error}"));
    let text = "[camera]\neye = [0, 1, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [4, 3]\n\
                [materials.floor]\nkd = [1, 1, 1]\nmap_kd = 'texture.png'\n";
    fs::write(path("scene.toml"), text).expect("the scene is written");
    let scene = Scene::load(&path("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    let pictures = Picture::load_all(&scene).unwrap_or_else(|error| panic!("{error}"));
    pictures.into_iter().next().expect("the scene has one texture")
}

/// The coordinates of a place counted in texels from the upper left corner.
fn at(x: f32, y: f32) -> Vec2 {
    vec2(x / WIDTH as f32, 1.0 - y / HEIGHT as f32)
}

fn check(picture: &Picture, coordinates: Vec2, expected: f32, what: &str) {
    let got = picture.sample(coordinates);
    let error = (got.x - expected).abs();
    assert!(error <= 1e-6, "{what}: {got} at {coordinates} for a red of {expected}");
    assert_eq!((got.y, got.z), (0.0, 1.0), "{what}: green and blue");
}

#[test]
fn the_centre_of_a_texel_has_exactly_its_colour() {
    let picture = picture();
    for (column, row) in (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (column, row))) {
        let got = picture.sample(at(column as f32 + 0.5, row as f32 + 0.5));
        let expected = Rgb::new(red(column, row), 0.0, 1.0);
        assert_eq!(got, expected, "texel ({column}, {row}), rows from the top");
    }
}

#[test]
fn between_two_texels_lies_their_mean_in_linear_light() {
    let picture = picture();
    check(&picture, at(1.0, 0.5), red(0, 0).midpoint(red(1, 0)), "between columns 0 and 1");
    check(&picture, at(2.5, 1.0), red(2, 0).midpoint(red(2, 1)), "between rows 0 and 1");
    let four = [red(1, 0), red(2, 0), red(1, 1), red(2, 1)].iter().sum::<f32>() / 4.0;
    check(&picture, at(2.0, 1.0), four, "between four texels");
    let quarter = 0.75 * red(0, 1) + 0.25 * red(1, 1);
    check(&picture, at(0.75, 1.5), quarter, "a quarter of the way");
}

#[test]
fn a_picture_repeats_in_both_directions() {
    let picture = picture();
    check(&picture, at(0.0, 0.5), red(3, 0).midpoint(red(0, 0)), "over the left edge");
    check(&picture, at(4.0, 1.5), red(3, 1).midpoint(red(0, 1)), "over the right edge");
    check(&picture, at(1.5, 0.0), red(1, 0).midpoint(red(1, 1)), "over the upper edge");
    for (u, v) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -3.0), (5.0, -2.0)] {
        let moved = at(2.5, 0.5) + vec2(u, v);
        check(&picture, moved, red(2, 0), "whole repetitions aside");
    }
}

/// Just below 0 and just above, and where a wrapped coordinate rounds up to 1.
#[test]
fn no_coordinate_reads_beside_the_picture() {
    let picture = picture();
    let mut edges = vec![0.0, 1.0, -1e-30, 1e-30, -1e-9, 1e9, -1e9, 3e38, -3e38, f32::MIN_POSITIVE];
    edges.extend([1.0_f32.next_down(), 1.0_f32.next_up(), (-1.0_f32).next_up(), -f32::EPSILON]);
    let range = 0.0..=1.0;
    for (u, v) in edges.iter().flat_map(|&u| edges.iter().map(move |&v| (u, v))) {
        let got = picture.sample(vec2(u, v));
        assert!(range.contains(&got.x), "a red of {} at ({u}, {v})", got.x);
    }
}
