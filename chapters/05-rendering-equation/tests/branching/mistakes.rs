//! What the closed forms are worth: one-bounce estimators with one mistake each, over E8.

use std::f32::consts::{PI, TAU};

use crate::scenes::gather;
use crate::sky::{down, eclipse};
use glam::Vec3;
use ray_casting::{Intersect, LinearSearch, Rgb};
use rendering_equation::directions::{cosine_hemisphere, uniform_hemisphere};
use rendering_equation::measures::pdf_area;
use rendering_equation::{Density, Frame};
use statistics::{Moments, check_mean};
use workbench::Unwatched;

/// The steps of the estimate, one of which may be wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mistake {
    Nothing,
    CosineForgotten,
    PiForgotten,
    TwoPiInsteadOfPi,
    DensityForgotten,
    DensityOfTheOther,
    MeasureMixed,
    BiasOfOnePercent,
}

/// ρ/π · cos θ / p for what is sky, with a mistake.
fn reflected(mistake: Mistake, density: Density, samples: u64) -> Moments {
    let scene = eclipse();
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let hit = geometry.intersect(&down()).expect("there is ground");
    let ground = scene.surface(&down(), &hit);
    let frame = Frame::around(ground.facing_normal());
    let albedo = 0.6;
    gather(samples, |sampler| {
        let u = sampler.next_2d();
        let (wi, mut pdf) = match density {
            Density::Uniform => (uniform_hemisphere(u), 1.0 / TAU),
            Density::Cosine => {
                let wi = cosine_hemisphere(u);
                (wi, wi.z / PI)
            }
        };
        let sees_sky = !geometry.occluded(&ground.spawn(frame.to_world(wi)));
        let mut f = albedo / PI;
        let mut cos = wi.z;
        match mistake {
            Mistake::Nothing => {}
            Mistake::CosineForgotten => cos = 1.0,
            Mistake::PiForgotten => f = albedo,
            Mistake::TwoPiInsteadOfPi => f = albedo / TAU,
            Mistake::DensityForgotten => pdf = 1.0,
            Mistake::DensityOfTheOther if density == Density::Uniform => pdf = wi.z / PI,
            Mistake::DensityOfTheOther => pdf = 1.0 / TAU,
            // The sky taken for a dome of radius 3.
            Mistake::MeasureMixed => pdf = pdf_area(pdf, 9.0, 1.0),
            Mistake::BiasOfOnePercent => f *= 1.01,
        }
        if sees_sky { Rgb::splat(f * cos / pdf) } else { Vec3::ZERO }
    })
}

#[test]
fn planted_mistakes_are_found() {
    use Mistake::{
        BiasOfOnePercent, CosineForgotten, DensityForgotten, DensityOfTheOther, MeasureMixed,
        Nothing, PiForgotten, TwoPiInsteadOfPi,
    };
    for (density, samples) in [(Density::Cosine, 300_000), (Density::Uniform, 900_000)] {
        let check = |mistake| check_mean("E8", &reflected(mistake, density, samples), 0.45);
        let right = check(Nothing);
        assert!(right.is_ok(), "{density:?}: {right:?}");
        for mistake in [
            CosineForgotten,
            PiForgotten,
            TwoPiInsteadOfPi,
            DensityForgotten,
            DensityOfTheOther,
            MeasureMixed,
            BiasOfOnePercent,
        ] {
            assert!(check(mistake).is_err(), "{density:?}, {mistake:?} was not found");
        }
    }
}
