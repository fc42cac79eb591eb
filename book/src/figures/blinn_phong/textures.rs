//! Textures: inside equation 1, and decoded before they are mixed.

use glam::{Vec2, vec2};
use ray_casting::{Rgb, Scene};
use workbench::{FilmSettings, Image, expose};

use super::still_life::{draw, scene, textures};
use crate::figures::Drawing;
use crate::picture::Picture;

/// The stage's own picture, as its command without options makes it.
pub(super) fn whitted() -> Drawing {
    let scene = scene("whitted");
    let samples = scene.exposure.samples.unwrap_or(16);
    let settings = FilmSettings { size: scene.exposure.size, samples, seed: 0, threads: None };
    Picture::from(&draw(&scene, &settings)).into()
}

/// Three texels around the corner of four tiles, on each side.
const WINDOW: f32 = 6.0;

/// The corner of four tiles, enlarged: mixed in linear light; mixed as codes and then decoded;
/// codes taken for light.
pub(super) fn codes() -> Drawing {
    let scene = scene("whitted");
    let texture = &textures(&scene)[0];
    let file = codes_of(&scene);
    let settings = FilmSettings { size: [240, 240], samples: 4, seed: 0, threads: None };
    let place = |x: f32, y: f32| {
        let texel = 1.0 / file.width as f32;
        Vec2::splat(0.5) + WINDOW * texel * vec2(x / 240.0 - 0.5, 0.5 - y / 240.0)
    };
    let panels = [
        expose(&settings, |point, _| texture.sample(place(point.x, point.y))),
        expose(&settings, |point, _| decode(mixed(&file, place(point.x, point.y)))),
        expose(&settings, |point, _| mixed(&file, place(point.x, point.y))),
    ];
    Picture::side_by_side(&panels.each_ref().map(Picture::from), 8).into()
}

/// The bytes of the scene's first texture, as fractions of 255.
fn codes_of(scene: &Scene) -> Image {
    let file = Image::load_png(&scene.textures[0].path).unwrap_or_else(|error| panic!("{error}"));
    let bytes = file.to_srgb8();
    let pixels = bytes.as_chunks::<3>().0.iter().map(|rgb| rgb.map(|c| f32::from(c) / 255.0));
    Image { pixels: pixels.collect(), ..file }
}

/// Mixes the four texels around a place inside the picture, whatever their numbers mean.
fn mixed(image: &Image, place: Vec2) -> Rgb {
    let place = vec2(place.x, 1.0 - place.y) * vec2(image.width as f32, image.height as f32) - 0.5;
    let (x, y, weight) = (place.x as u32, place.y as u32, place - place.floor());
    let texel = |dx: u32, dy: u32| Rgb::from_array(image.pixel(x + dx, y + dy));
    let above = texel(0, 0).lerp(texel(1, 0), weight.x);
    let below = texel(0, 1).lerp(texel(1, 1), weight.x);
    above.lerp(below, weight.y)
}

/// The sRGB curve, read backwards.
fn decode(codes: Rgb) -> Rgb {
    Rgb::from_array(
        codes
            .to_array()
            .map(|c| if c <= 0.04045 { c / 12.92 } else { libm::powf((c + 0.055) / 1.055, 2.4) }),
    )
}
