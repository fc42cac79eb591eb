//! What the review's listings draw, as they are printed.

use ray_casting::{LinearSearch, Rgb};
use rendering_equation::{Density, Opaque};
use workbench::{Image, Sampler, Unwatched, expose};

use super::as_printed::AsPrinted;
use super::rooms::{closed_box, down, furnace};
use super::stage::{ROULETTE, draw, settings};
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::plot::{Plot, Series, Style};

const SIZE: [u32; 2] = [64, 64];

/// The mean green of the closed box, drawn by the first listing to this depth.
fn first(depth: u32, samples: u32) -> f64 {
    let scene = closed_box();
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let review = AsPrinted::new(&scene, &geometry, Density::Uniform, depth);
    let image = expose(&settings([24, 24], samples), |point, sampler| {
        review.first(scene.camera.ray(point), 0, 1, sampler)
    });
    image.mean()[1]
}

/// The picture of the second listing to this depth.
fn second(depth: u32, samples: u32) -> Image {
    let scene = closed_box();
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let review = AsPrinted::new(&scene, &geometry, Density::Cosine, depth);
    expose(&settings(SIZE, samples), |point, sampler| {
        review.second(scene.camera.ray(point), 0, sampler)
    })
}

fn right(samples: u32) -> Image {
    draw(&closed_box(), ROULETTE, &settings(SIZE, samples))
}

/// The mean of the picture against the depth: first listing, second listing, and the right one.
pub(super) fn growth() -> Drawing {
    let depths = [1, 2, 3, 4, 5, 6, 8, 10];
    let first = depths.map(|depth| [f64::from(depth), first(depth, 12)]);
    let second = depths.map(|depth| [f64::from(depth), second(depth, 2).mean()[1]]);
    let truth = right(16).mean()[1];
    let series = |name: &str, points: &[[f64; 2]], style| Series {
        name: name.to_owned(),
        points: points.to_vec(),
        style,
    };
    Plot {
        description: "The first listing's mean grows exponentially with the depth, the second's \
                      levels off at the lamp's radiance"
            .to_owned(),
        x: Axis::linear("D").within(1.0, 10.0),
        y: Axis::log("mean of the picture"),
        series: vec![
            series("first listing", &first, Style::LineAndMarks),
            series("second listing", &second, Style::LineAndMarks),
            series("right", &[[1.0, truth], [10.0, truth]], Style::Line),
        ],
    }
    .into()
}

/// The second listing at depths 1, 4 and 64, and the right picture.
pub(super) fn constant() -> Drawing {
    let images = [second(1, 64), second(4, 40), second(64, 24), right(128)];
    let panels = images.map(|image| Picture::from(&image).enlarged(2));
    Picture::side_by_side(&panels, 8).into()
}

/// The furnace of albedo 0.5 and of 0.8, as printed and right, darkened so that 5 is white.
pub(super) fn lamps() -> Drawing {
    let field = |radiance: f32| {
        let image = Image { width: 1, height: 1, pixels: vec![[radiance / 5.0; 3]] };
        Picture::from(&image).enlarged(96)
    };
    let pairs = [0.5, 0.8].map(|albedo| {
        let [printed, right] = in_the_furnace(albedo);
        Picture::side_by_side(&[field(printed), field(right)], 0)
    });
    Picture::side_by_side(&pairs, 24).into()
}

/// What the second listing and the chapter's loop find, with a depth of 100.
fn in_the_furnace(albedo: f32) -> [f32; 2] {
    use path_tracing::{Ending, PathTracer, Roulette};
    let scene = furnace(albedo);
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let review = AsPrinted::new(&scene, &geometry, Density::Cosine, 100);
    let ending = Ending { depth: 100, roulette: Roulette::Off };
    let tracer: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(&scene, &[], &geometry, &Unwatched, Density::Cosine, ending);
    let printed: Rgb = review.second(down(), 0, &mut Sampler::new(0, 0, 0));
    [printed.x, tracer.incident_radiance(down(), &mut Sampler::new(0, 0, 0)).x]
}

pub(super) fn numbers() -> Drawing {
    let mut numbers = Numbers::new();
    let truth = right(16).mean()[1];
    numbers.add("right", format!("{truth:.2}"));
    for (name, depth) in [("first-4", 4), ("first-8", 8)] {
        numbers.add(name, format!("{:.0}", first(depth, 12)));
    }
    let mean = second(64, 8).mean();
    numbers.add("constant", format!("{:.1}", 100.0 * mean[1] / 0.75));
    for (printed, right, albedo) in
        [("printed-half", "right-half", 0.5), ("printed-four-fifths", "right-four-fifths", 0.8)]
    {
        let found = in_the_furnace(albedo);
        numbers.add(printed, found[0]);
        numbers.add(right, format!("{:.2}", found[1]));
    }
    numbers.into()
}
