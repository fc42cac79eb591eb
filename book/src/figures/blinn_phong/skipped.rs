//! Shadow rays that were not cast, counted.

use blinn_phong::reflection::{Arriving, diffuse, specular};
use blinn_phong::{Shader, Terms};
use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::Rgb;
use workbench::{Counter, FilmSettings, Recorder, expose};

use super::still_life::{draw, draw_otherwise, scene, textures, tree};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::table::{Table, count};

/// Exact counts of one small render.
struct Saving {
    lights: usize,
    camera: u64,
    facing_away: u64,
    nothing_to_reflect: u64,
    traced: u64,
}

impl Saving {
    /// Renders the scene with 120 pixels a row and 4 samples a pixel.
    ///
    /// The tree of chapter 4 finds what a linear search finds, so these counts are the stage's.
    fn of(name: &str) -> Self {
        let scene = scene(name);
        let recorder = Recorder::new();
        let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::default(), &recorder);
        let textures = textures(&scene);
        let shader = Shader::new(&scene, &textures, &tree, &recorder, Terms::All);
        let [width, height] = scene.exposure.size;
        let size = [120, 120 * height / width];
        let settings = FilmSettings { size, samples: 4, seed: 0, threads: None };
        expose(&settings, |point, _| shader.incident_radiance(scene.camera.ray(point)));
        Self {
            lights: scene.lights.len(),
            camera: 4 * u64::from(size[0]) * u64::from(size[1]),
            facing_away: recorder.get(Counter::ShadowRaysFacingAway),
            nothing_to_reflect: recorder.get(Counter::ShadowRaysNothingToReflect),
            traced: recorder.get(Counter::ShadowRays),
        }
    }

    /// One for each light at each visible point.
    fn wanted(&self) -> u64 {
        self.facing_away + self.nothing_to_reflect + self.traced
    }

    fn skipped_percent(&self) -> f64 {
        100.0 * (self.facing_away + self.nothing_to_reflect) as f64 / self.wanted() as f64
    }
}

/// The scenes of the table.
const SCENES: [&str; 5] = ["whitted", "teapot", "cornell-box", "sphereflake", "furnace"];

/// Shadow rays cast and not cast, scene by scene.
pub(super) fn skipped() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "lights",
        "camera rays",
        "light asked for",
        "faces away",
        "nothing to reflect",
        "shadow rays cast",
        "skipped",
    ]);
    for name in SCENES {
        let saving = Saving::of(name);
        let skipped = if saving.wanted() == 0 {
            "–".to_owned()
        } else {
            format!("{:.1} %", saving.skipped_percent())
        };
        table.row([
            format!("`{name}`"),
            saving.lights.to_string(),
            count(saving.camera),
            count(saving.wanted()),
            count(saving.facing_away),
            count(saving.nothing_to_reflect),
            count(saving.traced),
            skipped,
        ]);
    }
    table.into()
}

/// The same for sentences.
pub(super) fn numbers() -> Drawing {
    let mut numbers = Numbers::new();
    numbers.add("teapot-percent", format!("{:.0}", Saving::of("teapot").skipped_percent()));
    numbers.add("cornell-percent", format!("{:.0}", Saving::of("cornell-box").skipped_percent()));
    numbers.add("flake-percent", format!("{:.0}", Saving::of("sphereflake").skipped_percent()));
    numbers.add("cornell-differ", differing_pixels("cornell-box"));
    numbers.into()
}

/// How many pixels of a flat, untextured scene change if every shadow ray is cast.
fn differing_pixels(name: &str) -> usize {
    let scene = scene(name);
    let settings = FilmSettings { size: [120, 120], samples: 4, seed: 0, threads: None };
    let tree = tree(&scene);
    let asking = draw_otherwise(&scene, &tree, &settings, |surface, material, light| {
        let visible = light.is_visible_from(surface, &tree);
        let arriving = Arriving::new(light, surface.position);
        let (n, p) = (surface.facing_normal(), material.ns);
        let reflected =
            diffuse(material.kd, &arriving, n) + specular(material.ks, p, &arriving, n, surface.wo);
        if visible { reflected } else { Rgb::ZERO }
    });
    let skipping = draw(&scene, &settings);
    let bits = |pixel: &[f32; 3]| pixel.map(f32::to_bits);
    let pairs = asking.pixels.iter().zip(&skipping.pixels);
    pairs.filter(|(a, b)| bits(a) != bits(b)).count()
}
