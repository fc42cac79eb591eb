//! A lamp in a ball of glass: what η² is for.

use glam::Vec3;
use mirror_refraction::{Boundaries, Media, split};
use ray_casting::{Intersect, LinearSearch, Ray, Rgb, Scene};
use rendering_equation::{Density, Material, Materials};
use workbench::{FilmSettings, Image, MaterialRecord, Sampler, SurfaceKind, Unwatched, expose};

use super::scenes::{add_sphere, empty, matte};
use super::stage::{branching, draw, settings};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;

/// The radius of the lamp; the glass has radius 1.
const RADIUS: f32 = 0.4;

const FILM: FilmSettings = settings([160, 160], 16);

/// A black lamp of radiance 0.9, alone or in the middle of a glass ball, seen from far away.
fn lamp(in_glass: bool) -> Scene {
    let mut scene = empty(Vec3::new(0.0, 0.0, 60.0), Vec3::ZERO, 2.2, FILM.size, 0.0);
    add_sphere(&mut scene, Vec3::ZERO, RADIUS, matte(0.0, 0.9));
    if in_glass {
        let glass = MaterialRecord { surface: SurfaceKind::Glass, ..MaterialRecord::new("glass") };
        add_sphere(&mut scene, Vec3::ZERO, 1.0, MaterialRecord { ni: 1.5, kt: [1.0; 3], ..glass });
    }
    scene
}

fn by_stage(in_glass: bool) -> Image {
    draw(&lamp(in_glass), branching(1, 64, Density::Cosine), &FILM)
}

// ANCHOR: without
/// The glass of the chapter without η²: one way by chance, every weight 1.
fn without<G: Intersect>(
    scene: &Scene,
    geometry: &G,
    boundaries: &Boundaries<'_>,
    mut ray: Ray,
    sampler: &mut Sampler,
) -> Rgb {
    let materials: Materials<'_> = Materials::new(scene, &[]);
    let mut media = Media::OUTSIDE;
    for _ in 0..64 {
        let Some(hit) = geometry.intersect(&ray) else { return scene.background };
        let surface = scene.surface(&ray, &hit);
        let Material::Glass = materials.at(&surface) else { return materials.emitted(&surface) };
        let crossing = boundaries.crossing(&ray, &surface, &media);
        let split = split(scene, &surface, crossing.eta);
        match split.refracted {
            Some(refracted) if sampler.next_1d() >= split.reflectance => {
                media = crossing.beyond;
                ray = crossing.far.spawn(refracted);
            }
            _ => ray = crossing.near.spawn(split.reflected),
        }
    }
    Rgb::ZERO
}
// ANCHOR_END: without

fn naive() -> Image {
    let scene = lamp(true);
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let boundaries = Boundaries::new(&scene);
    expose(&FILM, |point, sampler| {
        without(&scene, &geometry, &boundaries, scene.camera.ray(point), sampler)
    })
}

/// The bare lamp, the lamp in glass without η², and with.
pub(super) fn picture() -> Drawing {
    let panels = [by_stage(false), naive(), by_stage(true)].map(|image| Picture::from(&image));
    Picture::side_by_side(&panels, 8).into()
}

/// How much light leaves, seen from one side, which is the same from all.
pub(super) fn numbers() -> Drawing {
    let light = |image: &Image| image.mean()[0];
    let bare = light(&by_stage(false));
    let mut numbers = Numbers::new();
    numbers.add("without", format!("{:.2}", light(&naive()) / bare));
    numbers.add("with", format!("{:.2}", light(&by_stage(true)) / bare));
    numbers.into()
}
