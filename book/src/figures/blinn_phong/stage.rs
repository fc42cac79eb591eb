//! What the stage draws of the teapot: all at once, term by term, with and without shadow rays.

use blinn_phong::Terms;
use blinn_phong::reflection::{Arriving, diffuse, specular};
use ray_casting::{LinearSearch, Rgb};
use workbench::{FilmSettings, Image, Unwatched};

use super::still_life::{PANEL, draw_otherwise, draw_terms, scene, tree};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::table::count;

fn draw_teapot(terms: Terms, settings: &FilmSettings) -> Image {
    let scene = scene("teapot");
    draw_terms(&scene, &tree(&scene), terms, settings)
}

/// The teapot at the scene's own size.
pub(super) fn teapot() -> Drawing {
    let settings = FilmSettings { size: scene("teapot").exposure.size, ..PANEL };
    Picture::from(&draw_teapot(Terms::All, &settings)).into()
}

pub(super) fn ambient() -> Drawing {
    Picture::from(&draw_teapot(Terms::Ambient, &PANEL)).into()
}

pub(super) fn diffuse_term() -> Drawing {
    Picture::from(&draw_teapot(Terms::Diffuse, &PANEL)).into()
}

pub(super) fn specular_term() -> Drawing {
    Picture::from(&draw_teapot(Terms::Specular, &PANEL)).into()
}

/// How far the three pictures are from adding up to the fourth, and the tree from linear search.
pub(super) fn numbers() -> Drawing {
    let mut dark = scene("teapot");
    dark.background = Rgb::ZERO;
    let tree = tree(&dark);
    let coarse = FilmSettings { samples: 4, ..PANEL };
    let [all, ambient, diffuse, specular] =
        [Terms::All, Terms::Ambient, Terms::Diffuse, Terms::Specular]
            .map(|terms| draw_terms(&dark, &tree, terms, &coarse).pixels);
    let sums = ambient.iter().zip(&diffuse).zip(&specular);
    let differences = sums.zip(&all).map(|(((a, d), s), all)| {
        (Rgb::from(*a) + Rgb::from(*d) + Rgb::from(*s) - Rgb::from(*all)).abs().max_element()
    });
    let worst = differences.fold(0.0, f32::max);

    let small = FilmSettings { size: [60, 40], samples: 1, ..PANEL };
    let linear = LinearSearch::new(&dark.geometry, &Unwatched);
    let [by_tree, by_list] = [
        draw_terms(&dark, &tree, Terms::All, &small),
        draw_terms(&dark, &linear, Terms::All, &small),
    ];
    let bits = |pixel: &[f32; 3]| pixel.map(f32::to_bits);
    let pairs = by_tree.pixels.iter().zip(&by_list.pixels);
    let differing = pairs.filter(|(a, b)| bits(a) != bits(b)).count();

    let mut numbers = Numbers::new();
    numbers.add("primitives", count(u64::from(dark.geometry.primitives())));
    numbers.add("largest-difference", format!("{:.1}", 1e7 * worst));
    numbers.add("pixels-compared", count(by_list.pixels.len() as u64));
    numbers.add("pixels-that-differ", differing);
    numbers.into()
}

/// The teapot without and with shadow rays.
pub(super) fn shadows() -> Drawing {
    let scene = scene("teapot");
    let tree = tree(&scene);
    let settings = FilmSettings { size: [300, 200], ..PANEL };
    let unshadowed = draw_otherwise(&scene, &tree, &settings, |surface, material, light| {
        let arriving = Arriving::new(light, surface.position);
        let normal = scene.shading_normal(surface);
        diffuse(material.kd, &arriving, normal)
            + specular(material.ks, material.ns, &arriving, normal, surface.wo)
    });
    let shadowed = draw_terms(&scene, &tree, Terms::All, &settings);
    Picture::side_by_side(&[&unshadowed, &shadowed].map(Picture::from), 16).into()
}
