//! What the review's first listing draws, as it is printed: without f cos θ.

use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::{LinearSearch, Scene};
use rendering_equation::monte_carlo::integrate;
use rendering_equation::{Density, DistributedTracer, Opaque};
use workbench::{Sampler, Unwatched, expose};

use super::scenes::{ahead, lamp_in_hollow};
use super::stage::{branching, draw, settings};
use crate::figures::Drawing;
use crate::figures::path_tracing::as_printed::AsPrinted;
use crate::figures::path_tracing::rooms::closed_box;
use crate::picture::Picture;
use crate::table::{Table, count};

/// The closed Cornell box by the first listing with D = 1, 2, 3, divided by (2π)ᴰ, and by the stage.
pub(super) fn pictures() -> Drawing {
    let scene = closed_box();
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let film = settings([72, 72], 36);
    let mut panels: Vec<Picture> = [1, 2, 3]
        .map(|depth| {
            let listing = AsPrinted::new(&scene, &geometry, Density::Uniform, depth);
            let much = (0..depth).map(|_| std::f32::consts::TAU).product::<f32>();
            let image = expose(&film, |point, sampler| {
                listing.first(scene.camera.ray(point), 0, 1, sampler) / much
            });
            Picture::from(&image).enlarged(2)
        })
        .into();
    let right = draw(&scene, branching(1, 8, Density::Cosine), &film);
    panels.push(Picture::from(&right).enlarged(2));
    Picture::side_by_side(&panels, 8).into()
}

const SAMPLES: u64 = 100_000;

/// The mean of the listing, seen from the wall's side of the lamp.
fn listing(scene: &Scene, directions: u32, depth: u32, samples: u64) -> f64 {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let listing = AsPrinted::new(scene, &geometry, Density::Uniform, depth);
    let value = |s: &mut Sampler| f64::from(listing.first(ahead(scene), 0, directions, s).x);
    integrate(samples, &mut Sampler::new(0, 0, 0), value, |_| 1.0, |v| v).mean
}

/// The mean of the stage.
fn stage(scene: &Scene, depth: u32) -> f64 {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let branching = branching(1, depth, Density::Cosine);
    let tracer: DistributedTracer<'_, _, _, Opaque> =
        DistributedTracer::new(scene, &[], &geometry, &Unwatched, branching);
    let value = |s: &mut Sampler| f64::from(tracer.incident_radiance(ahead(scene), s).x);
    integrate(SAMPLES, &mut Sampler::new(0, 0, 0), value, |_| 1.0, |v| v).mean
}

/// The hollow sphere with a lamp in it, whose wrong answers have a closed form, too.
pub(super) fn growth() -> Drawing {
    let mut table = Table::new(&[
        "$D$",
        "as printed",
        "with $N = 3$",
        "black wall",
        "$\\Omega \\sum_{k<D} (2\\pi - \\Omega)^k$",
        "corrected",
        "exact",
    ]);
    let [grey, black] = [0.5, 0.0].map(lamp_in_hollow);
    let omega = std::f64::consts::TAU * (1.0 - libm::sqrt(0.75));
    for depth in [1_u32, 2, 3, 5, 8] {
        let powers = (0..depth).map(f64::from);
        let printed: f64 =
            powers.clone().map(|k| omega * libm::pow(std::f64::consts::TAU - omega, k)).sum();
        let exact: f64 = powers.map(|k| 0.125 * libm::pow(0.375, k)).sum();
        let few = SAMPLES / 3_u64.pow(depth.min(5));
        let digits = |x: f64| if x < 100.0 { format!("{x:.2}") } else { count(x.round() as u64) };
        table.row([
            depth.to_string(),
            digits(listing(&grey, 1, depth, SAMPLES)),
            if depth > 5 { "–".to_owned() } else { digits(listing(&grey, 3, depth, few)) },
            digits(listing(&black, 1, depth, SAMPLES)),
            digits(printed),
            format!("{:.3}", stage(&grey, depth)),
            format!("{exact:.3}"),
        ]);
    }
    table.into()
}
