//! One bounce under an even sky, with one mistake at a time.

use std::f32::consts::PI;

use bv_tree::{Aabb, Builder, BvTree};
use glam::{Vec3, vec3};
use ray_casting::{Intersect, Ray, Rgb, Scene};
use rendering_equation::directions::{
    cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere, uniform_hemisphere_pdf,
};
use rendering_equation::{Density, Frame, Material, Materials};
use workbench::{Sampler, Unwatched, expose};

use super::directions::unsigned;
use super::scenes::{add_floor, add_sphere, ahead, eclipse, empty, matte};
use super::stage::{scene, settings};
use crate::figures::Drawing;
use crate::figures::path_tracing::rooms::closed_box;
use crate::picture::Picture;
use crate::table::Table;

/// The steps of the estimate, one of which may be wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mistake {
    Nothing,
    Cosine,
    Pi,
    Density,
    OtherDensity,
}

/// A mistake, with the density that the directions really have.
struct Case {
    name: &'static str,
    mistake: Mistake,
    drawn: Density,
    /// What the furnace and the floor below the ball then have, in units of the albedo.
    exact: [f64; 2],
}

/// cos 30°.
const EDGE: f64 = 0.866_025_403_784_438_6;

const CASES: [Case; 6] = [
    Case { name: "nothing", mistake: Mistake::Nothing, drawn: Density::Cosine, exact: [1.0, 0.75] },
    Case {
        name: "no $\\cos\\theta$",
        mistake: Mistake::Cosine,
        drawn: Density::Uniform,
        exact: [2.0, 2.0 * EDGE],
    },
    Case {
        name: "no $1/\\pi$ in $f$",
        mistake: Mistake::Pi,
        drawn: Density::Uniform,
        exact: [std::f64::consts::PI, 0.75 * std::f64::consts::PI],
    },
    Case {
        name: "no $1/p$",
        mistake: Mistake::Density,
        drawn: Density::Uniform,
        exact: [0.5 / std::f64::consts::PI, 0.375 / std::f64::consts::PI],
    },
    Case {
        name: "drawn by cosine, divided by $1/2\\pi$",
        mistake: Mistake::OtherDensity,
        drawn: Density::Cosine,
        exact: [4.0 / 3.0, 4.0 / 3.0 * EDGE * EDGE * EDGE],
    },
    Case {
        name: "drawn uniformly, divided by $\\cos\\theta/\\pi$",
        mistake: Mistake::OtherDensity,
        drawn: Density::Uniform,
        exact: [1.0, EDGE],
    },
];

// ANCHOR: reflected
/// The share of the sky's light that one direction at a matte surface brings, before anything is
/// known to be in the way.
fn weight(albedo: f32, case: &Case, u: [f32; 2]) -> (Vec3, f32) {
    let wi = match case.drawn {
        Density::Uniform => uniform_hemisphere(u),
        Density::Cosine => cosine_hemisphere(u),
    };
    let densities = [uniform_hemisphere_pdf(wi.z), cosine_hemisphere_pdf(wi.z)];
    let [right, other] = match case.drawn {
        Density::Uniform => densities,
        Density::Cosine => [densities[1], densities[0]],
    };
    let (f, cos, pdf) = (albedo / PI, wi.z, right);
    let weight = match case.mistake {
        Mistake::Nothing => f * cos / pdf,
        Mistake::Cosine => f / pdf,
        Mistake::Pi => albedo * cos / pdf,
        Mistake::Density => f * cos,
        Mistake::OtherDensity => f * cos / other,
    };
    (wi, weight)
}
// ANCHOR_END: reflected

/// One sample of one bounce.
fn one_bounce<G: Intersect>(
    scene: &Scene,
    geometry: &G,
    case: &Case,
    ray: Ray,
    sampler: &mut Sampler,
) -> Rgb {
    let Some(hit) = geometry.intersect(&ray) else { return scene.background };
    let surface = scene.surface(&ray, &hit);
    let albedo = scene.materials[surface.material as usize].kd[0];
    let (wi, weight) = weight(albedo, case, sampler.next_2d());
    let wi = Frame::around(surface.facing_normal()).to_world(wi);
    if geometry.occluded(&surface.spawn(wi)) { Rgb::ZERO } else { weight * scene.background }
}

/// Two balls on a floor, under an even sky.
fn still_life() -> Scene {
    let mut scene = empty(vec3(0.0, 2.4, 6.0), vec3(0.0, 0.7, 0.0), 34.0, [1, 1], 0.8);
    add_floor(&mut scene, matte(0.6, 0.0));
    add_sphere(&mut scene, vec3(-0.55, 0.9, 0.0), 0.9, matte(0.6, 0.0));
    add_sphere(&mut scene, vec3(0.85, 0.5, 0.7), 0.5, matte(0.6, 0.0));
    scene
}

/// All cases in the furnace (above) and with things in each other's light (below).
pub(super) fn pictures() -> Drawing {
    let mut furnace = scene("furnace");
    furnace.background = Rgb::splat(0.8);
    let rows = [furnace, still_life()].map(|scene| {
        let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
        let panels = CASES.each_ref().map(|case| {
            Picture::from(&expose(&settings([104, 104], 32), |point, sampler| {
                one_bounce(&scene, &geometry, case, scene.camera.ray(point), sampler)
            }))
        });
        Picture::side_by_side(&panels, 8)
    });
    Picture::stacked(&rows, 8).into()
}

/// The same as numbers: the furnace of albedo ½, and the floor of albedo 0.6 below a black ball.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&[
        "what is wrong",
        "furnace, measured",
        "exact",
        "below the ball, measured",
        "exact",
    ]);
    let furnace = {
        let mut scene = empty(vec3(0.0, 0.0, 4.0), Vec3::ZERO, 40.0, [1, 1], 1.0);
        add_sphere(&mut scene, Vec3::ZERO, 1.0, matte(0.5, 0.0));
        scene
    };
    let scenes = [(furnace, 0.5), (eclipse(0.6), 0.6)];
    for case in &CASES {
        let mut cells = vec![case.name.to_owned()];
        for ((scene, albedo), exact) in scenes.iter().zip(case.exact) {
            let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
            let samples = 250_000;
            let sum: f64 = (0..samples)
                .map(|i| {
                    let sampler = &mut Sampler::new(0, 0, i);
                    f64::from(one_bounce(scene, &geometry, case, ahead(scene), sampler).x)
                })
                .sum();
            cells.push(format!("{:.2}", sum / samples as f64));
            cells.push(format!("{:.2}", albedo * exact));
        }
        table.row(cells);
    }
    table.into()
}

/// The closed Cornell box with the frame that has no sign, and as it is.
pub(super) fn pole() -> Drawing {
    let scene = closed_box();
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let materials = Materials::new(&scene, &[]);
    let panels = [unsigned, Frame::around].map(|around: fn(Vec3) -> Frame| {
        Picture::from(&expose(&settings([96, 96], 36), |point, sampler| {
            path(&scene, &geometry, &materials, around, scene.camera.ray(point), sampler)
        }))
        .enlarged(2)
    });
    Picture::side_by_side(&panels, 8).into()
}

/// The chapter's estimate with N = 1 and D = 8 for matte surfaces, and a frame of one's own.
fn path<G: Intersect>(
    scene: &Scene,
    geometry: &G,
    materials: &Materials<'_>,
    around: fn(Vec3) -> Frame,
    mut ray: Ray,
    sampler: &mut Sampler,
) -> Rgb {
    let (mut radiance, mut throughput) = (Rgb::ZERO, Rgb::ONE);
    for _ in 0..=8 {
        let Some(hit) = geometry.intersect(&ray) else { break };
        let surface = scene.surface(&ray, &hit);
        radiance += throughput * materials.emitted(&surface);
        let Material::Matte { kd, map_kd, lobe } = materials.at(&surface) else { break };
        let brdf = materials.brdf(&surface, kd, map_kd, lobe);
        let wi = around(brdf.normal).to_world(cosine_hemisphere(sampler.next_2d()));
        if brdf.is_black() || !brdf.is_above(wi) {
            break;
        }
        throughput *= brdf.lambert.albedo;
        ray = surface.spawn(wi);
    }
    radiance
}
