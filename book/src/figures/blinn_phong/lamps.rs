//! Lamps, for which point lights stand in.

use workbench::FilmSettings;

use super::still_life::{PANEL, draw, scene};
use crate::figures::Drawing;
use crate::picture::Picture;

/// The Cornell box, as `blinn-phong cornell-box` draws it.
pub(super) fn cornell_box() -> Drawing {
    let scene = scene("cornell-box");
    let settings = FilmSettings { size: scene.exposure.size, ..PANEL };
    Picture::from(&draw(&scene, &settings)).into()
}

/// The Cornell box with a lamp that casts a shadow of its own, and as the stage draws it.
pub(super) fn lamps() -> Drawing {
    let settings = FilmSettings { size: [200, 200], ..PANEL };
    let panels = [true, false].map(|in_its_own_light| {
        let mut scene = scene("cornell-box");
        if in_its_own_light {
            scene.lights.iter_mut().for_each(|light| light.lamp = 0..0);
        }
        Picture::from(&draw(&scene, &settings))
    });
    Picture::side_by_side(&panels, 16).into()
}
