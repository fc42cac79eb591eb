//! The plates under the lamps, one highlight at a time.

use light_sampling::{Heuristic, Lights};
use ray_casting::{Intersect, LinearSearch, Scene};
use rendering_equation::{Brdf, Density, Material, Materials};
use workbench::{FilmPoint, Sampler, Unwatched};

use super::stage::scene;
use crate::figures::Drawing;
use crate::table::Table;

/// Width and height of the picture that is measured; a quarter of it is plates.
const SIZE: [u32; 2] = [64, 48];

/// Directions a pixel, by each way.
const SAMPLES: u32 = 64;

/// The names of the lamps' materials, and of the plates', as in the scene's file.
const LAMPS: [&str; 4] = ["lamp1", "lamp2", "lamp3", "lamp4"];
const PLATES: [&str; 4] = ["plate1", "plate2", "plate3", "plate4"];

/// Integrals over all directions of what depends on F = f L cos θ V and on the two densities.
///
/// A variance told from samples is blind to what they have not met: chance meets the smallest lamp
/// once in a million paths. But it is an integral like any other, and both ways together find it.
#[derive(Default)]
struct Integrals {
    /// ∫ F, the mean.
    mean: f64,
    /// ∫ F²/p for scattering and for the lamp: what the squares of their samples are on average.
    squares: [f64; 2],
    /// ∫ w F and ∫ w² F²/p, the same with the weights of both.
    weighted: [f64; 2],
    weighted_squares: [f64; 2],
}

impl Integrals {
    /// Adds a direction that has been drawn by one of the two ways with the densities `pdfs`.
    fn add(&mut self, value: f32, pdfs: [f32; 2]) {
        let share = 1.0 / (f64::from(pdfs[0]) + f64::from(pdfs[1])) / f64::from(SAMPLES);
        let value = f64::from(value);
        self.mean += share * value;
        for way in 0..2 {
            let (own, other) = (pdfs[way], pdfs[1 - way]);
            if own > 0.0 {
                let w = f64::from(Heuristic::Power.weight(own, other));
                let square = value * value / f64::from(own);
                self.squares[way] += share * square;
                self.weighted[way] += share * w * value;
                self.weighted_squares[way] += share * w * w * square;
            }
        }
    }

    /// The relative variances of a sample by chance, by the lamp, and by both: v / (μ² + 0.01).
    fn variances(&self) -> [f64; 3] {
        let square = |x: f64| x * x;
        let [chance, lamp] = self.squares.map(|squares| squares - square(self.mean));
        let both = [0, 1].map(|way| self.weighted_squares[way] - square(self.weighted[way]));
        [chance, lamp, both[0] + both[1]].map(|v| v.max(0.0) / (square(self.mean) + 0.01))
    }
}

/// The integrals for one pixel's middle, if that is a plate, and the number of the plate.
fn integrals<G: Intersect>(
    scene: &Scene,
    geometry: &G,
    lights: &Lights,
    pixel: [u32; 2],
) -> Option<(usize, Integrals)> {
    let ray = scene.camera.ray(FilmPoint::in_pixel(pixel, [0.5; 2], SIZE));
    let surface = scene.surface(&ray, &geometry.intersect(&ray)?);
    let name = &scene.materials[surface.material as usize].name;
    let plate = PLATES.iter().position(|plate| plate == name)?;
    let materials: Materials<'_> = Materials::new(scene, &[]);
    let Material::Matte { kd, map_kd, lobe } = materials.at(&surface) else { return None };
    let brdf: Brdf = materials.brdf(&surface, kd, map_kd, lobe);
    let pdf = |wi| brdf.pdf(Density::Cosine, wi);

    let mut integrals = Integrals::default();
    let mut sampler = Sampler::new(0, u64::from(pixel[1] * SIZE[0] + pixel[0]), 0);
    for _ in 0..SAMPLES {
        if let Some(light) = lights.sample(&surface, &mut sampler)
            && brdf.is_above(light.wi)
            && !geometry.occluded(&light.shadow_ray(&surface))
        {
            let value = brdf.eval(light.wi) * brdf.cos_theta(light.wi) * light.radiance;
            integrals.add(value.x, [pdf(light.wi), light.pdf_solid_angle]);
        }
        if let Some(scattered) = brdf.sample(Density::Cosine, &mut sampler) {
            let ray = surface.spawn(scattered.wi);
            let Some(hit) = geometry.intersect(&ray) else { continue };
            let met = scene.surface(&ray, &hit);
            let value = scattered.weight * scattered.pdf_solid_angle * materials.emitted(&met);
            let of_lamp = lights.pdf_of_lamp(surface.position, brdf.facing, &met);
            if value.x > 0.0 {
                integrals.add(value.x, [scattered.pdf_solid_angle, of_lamp]);
            }
        }
    }
    Some((plate, integrals))
}

/// The relative variance of a sample by each of the three ways, the mean over the pixels of each
/// plate, with one lamp alone.
fn variances(lamp: &str) -> [[f64; 3]; 4] {
    let mut scene = scene("veach-plates");
    for material in &mut scene.materials {
        if material.name != lamp {
            material.ke = [0.0; 3];
        }
    }
    let (geometry, lights) = (LinearSearch::new(&scene.geometry, &Unwatched), Lights::new(&scene));
    let mut sums = [[0.0; 3]; 4];
    let mut pixels = [0.0; 4];
    let all = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
    for (plate, integrals) in all.filter_map(|pixel| integrals(&scene, &geometry, &lights, pixel)) {
        pixels[plate] += 1.0;
        for (sum, variance) in sums[plate].iter_mut().zip(integrals.variances()) {
            *sum += variance;
        }
    }
    std::array::from_fn(|plate| sums[plate].map(|sum| sum / pixels[plate]))
}

/// A row for each lamp and each plate.
pub(super) fn table() -> Drawing {
    let scene = scene("veach-plates");
    let exponents = PLATES.map(|plate| {
        let material = scene.materials.iter().find(|material| material.name == plate);
        material.expect("the plate").ns
    });
    let columns = ["lamp of radius", "plate of exponent", "by chance", "lights", "both"];
    let mut table = Table::new(&columns);
    for (sphere, lamp) in scene.geometry.spheres.iter().zip(LAMPS) {
        for (exponent, variances) in exponents.iter().zip(variances(lamp)) {
            let cells = variances.map(|v| match v {
                10.0.. => format!("{v:.0}"),
                0.1.. => format!("{v:.2}"),
                0.01.. => format!("{v:.3}"),
                _ => format!("{v:.4}"),
            });
            let first = [sphere.radius.to_string(), exponent.to_string()];
            table.row(first.into_iter().chain(cells));
        }
    }
    table.into()
}
