//! N directions at every hit: how many rays that makes, and what they are worth.

use bv_tree::{Aabb, Builder, BvTree};
use light_sampling::{LightTracer, Settings};
use path_tracing::{Ending, Roulette};
use ray_casting::{LinearSearch, Scene};
use rendering_equation::{Branching, Density, DistributedTracer, Opaque};
use workbench::{Counter, FilmSettings, Image, Recorder, Sampler, Unwatched, expose};

use super::scenes::{ahead, hollow};
use super::stage::{branching, estimate, scene, settings};
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::plot::{Plot, Series, Style};
use crate::table::{Table, count};

/// The rays that one camera ray becomes in a room without a way out, itself included; counted.
fn rays(directions: u32, depth: u32) -> u64 {
    let scene = hollow(0.5);
    let recorder = Recorder::new();
    let geometry = LinearSearch::new(&scene.geometry, &recorder);
    let branching = branching(directions, depth, Density::Cosine);
    let tracer: DistributedTracer<'_, _, _, Opaque> =
        DistributedTracer::new(&scene, &[], &geometry, &recorder, branching);
    tracer.incident_radiance(ahead(&scene), &mut Sampler::new(0, 0, 0));
    1 + recorder.get(Counter::ScatterRays)
}

/// 1 + N + … + N^D, counted and computed, and the share of the last term.
pub(super) fn counts() -> Drawing {
    let mut table = Table::new(&[
        "$N$",
        "$D$",
        "rays, counted",
        "$1 + N + \\dots + N^D$",
        "of these on the last level",
    ]);
    for (n, depth) in [(1, 5), (2, 5), (4, 5), (8, 5), (1, 10), (2, 10), (4, 10)] {
        let [all, last] = [(0..=depth).map(|k| u64::from(n).pow(k)).sum(), u64::from(n).pow(depth)];
        table.row([
            n.to_string(),
            depth.to_string(),
            count(rays(n, depth)),
            count(all),
            format!("{:.0} %", 100.0 * last as f64 / all as f64),
        ]);
    }
    table.into()
}

/// What one sample a pixel costs and brings.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Price {
    /// Rays, the camera's included.
    pub(crate) rays: f64,
    /// The expected relMSE of a picture of one sample a pixel.
    pub(crate) rel_mse: f64,
}

impl Price {
    /// The expected relative error of a picture of this many samples a pixel.
    pub(crate) fn error(&self, samples: u32) -> f64 {
        (self.rel_mse / f64::from(samples)).sqrt()
    }
}

/// Width and height of the pictures that are compared.
pub(crate) const SIZE: [u32; 2] = [20, 20];

/// The picture that all others tend to, by the way of chapter 7, which has little noise here.
pub(crate) fn reference(scene: &Scene, depth: u32) -> Image {
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let ending = Ending { depth, roulette: Roulette::Off };
    let tracer: LightTracer<'_, _, _, Opaque> =
        LightTracer::new(scene, &[], &tree, &Unwatched, Settings::new(ending));
    expose(&FilmSettings { size: SIZE, samples: 64, seed: 1, threads: None }, |point, sampler| {
        tracer.incident_radiance(scene.camera.ray(point), sampler)
    })
}

/// What a sample is worth, told from this many: their variance, over the square of the reference.
pub(crate) fn price(
    scene: &Scene,
    reference: &Image,
    directions: u32,
    depth: u32,
    samples: u32,
) -> Price {
    let branching = branching(directions, depth, Density::Cosine);
    let estimate = estimate(scene, branching, &settings(SIZE, samples), &Unwatched);
    let variances = estimate.variance_of_mean.pixels.iter().flatten();
    let ratios = variances.zip(reference.pixels.iter().flatten()).map(|(variance, mean)| {
        let mean = f64::from(*mean);
        f64::from(*variance) * f64::from(samples) / (mean * mean + 0.01)
    });
    Price {
        rays: rays_of_sample(scene, branching, samples.min(16)),
        rel_mse: ratios.sum::<f64>() / f64::from(3 * SIZE[0] * SIZE[1]),
    }
}

/// Rays of a sample, the camera's included. Counting makes them slow, so there are few.
fn rays_of_sample(scene: &Scene, branching: Branching, samples: u32) -> f64 {
    let recorder = Recorder::new();
    estimate(scene, branching, &settings(SIZE, samples), &recorder);
    let paths = f64::from(samples * SIZE[0] * SIZE[1]);
    1.0 + recorder.get(Counter::ScatterRays) as f64 / paths
}

/// Samples a pixel for somewhat less than a million rays, so that all entries are as certain.
fn samples(directions: u32, depth: u32) -> u32 {
    match (directions, depth) {
        (1, 1) => 640,
        (1, _) => 384,
        (2, 1 | 2) => 384,
        (2, 3) => 144,
        (2, _) => 96,
        (_, 1) => 256,
        (_, 2) => 96,
        (_, 3) => 32,
        (_, _) => 12,
    }
}

/// What N = 2 and 4 cost and gain at several depths.
pub(super) fn gains() -> Drawing {
    let scene = scene("cornell-box");
    let mut table = Table::new(&[
        "$D$",
        "rays a sample, $N = 1$",
        "$N = 2$",
        "$N = 4$",
        "gain of $N = 2$",
        "of $N = 4$",
    ]);
    for depth in 1..=4 {
        let reference = &reference(&scene, depth);
        let prices = [1, 2, 4].map(|n| price(&scene, reference, n, depth, samples(n, depth)));
        let cost = prices.map(|price| price.rays * price.rel_mse);
        let rays = prices.map(|price| format!("{:.1}", price.rays));
        // They are uncertain by some percent.
        let digits = |x: f64| if x < 0.1 { format!("{x:.2}") } else { format!("{x:.1}") };
        let gains = [1, 2].map(|i| digits(cost[0] / cost[i]));
        table.row([depth.to_string()].into_iter().chain(rays).chain(gains));
    }
    table.into()
}

/// The depth of the plots of errors.
pub(crate) const DEPTH: u32 = 3;

/// N, and the samples a pixel of each point of its curve.
pub(crate) const CURVES: [(u32, &[u32]); 4] =
    [(8, &[2, 8]), (4, &[2, 8, 32]), (2, &[2, 8, 32, 128]), (1, &[2, 8, 32, 128, 512])];

/// What the pictures of each curve say of a sample, point by point.
pub(crate) fn prices() -> [Vec<Price>; 4] {
    let scene = scene("cornell-box");
    let reference = reference(&scene, DEPTH);
    CURVES.map(|(n, samples)| {
        let price = |&samples: &u32| price(&scene, &reference, n, DEPTH, samples);
        samples.iter().map(price).collect()
    })
}

/// Curves of the errors; `x` is told the place of the curve in [`CURVES`], a price, and samples.
pub(crate) fn curves(prices: &[Vec<Price>], x: impl Fn(usize, &Price, u32) -> f64) -> Vec<Series> {
    let numbered = CURVES.iter().zip(prices).enumerate();
    let curve = numbered.map(|(i, ((n, samples), prices))| {
        let pairs = samples.iter().zip(prices);
        let points = pairs.map(|(&samples, price)| [x(i, price, samples), price.error(samples)]);
        Series { name: format!("N = {n}"), points: points.collect(), style: Style::LineAndMarks }
    });
    curve.collect()
}

/// Errors against rays a pixel.
pub(super) fn errors() -> Drawing {
    let series = curves(&prices(), |_, price, samples| f64::from(samples) * price.rays);
    plot("rays a pixel", series).into()
}

pub(crate) fn plot(x: &str, series: Vec<Series>) -> Plot {
    Plot {
        description: format!(
            "The error of a picture against {x}: parallel falling lines, the lowest for N = 1 and \
             the highest for N = 8"
        ),
        x: Axis::log(x),
        y: Axis::log("relative error"),
        series,
    }
}
