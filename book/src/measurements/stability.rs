//! What "When numbers break" measures: the price of robustness.

use std::hint::black_box;

use glam::Vec3;
use ray_casting::triangle::{self, ShearedRay};
use ray_casting::{Ray, SurfacePoint, moller_trumbore};

use super::Measurement;
use super::bv_tree::alternating;
use crate::figures::Drawing;
use crate::figures::bv_tree::fours::SingleBox;
use crate::figures::bv_tree::naive::UnpaddedBox;
use crate::figures::bv_tree::workload::{Workload, scene, stopwatch, terrain};
use crate::figures::stability::stage::{Ball, HERE, by_bound, by_constant};
use crate::table::Table;

pub(super) const MEASUREMENTS: &[Measurement] =
    &[Measurement { file: "stability/cost.md", take: cost }];

/// Times of the robust version relative to the naive one.
fn cost() -> Drawing {
    let mut table = Table::new(&["naive", "robust", "what is timed", "robust / naive"]);
    for [naive, robust, what, ratio] in
        [triangles(), boxes("teapot"), boxes("terrain"), leaving(), picture()]
    {
        table.row([naive, robust, what, ratio]);
    }
    table.into()
}

fn row(naive: &str, robust: &str, what: &str, seconds: &[f64]) -> [String; 4] {
    let ratio = format!("{:.2}", seconds[1] / seconds[0]);
    [naive.to_owned(), robust.to_owned(), what.to_owned(), ratio]
}

/// Every triangle of the teapot for some of its rays, as a linear search asks.
fn triangles() -> [String; 4] {
    let workload = Workload::record("teapot", scene("teapot"), 12);
    let geometry = &workload.geometry;
    let corners: Vec<[Vec3; 3]> =
        (0..geometry.triangles.len() as u32).map(|i| geometry.corners(i)).collect();
    let rays: Vec<Ray> = workload.questions.iter().map(|question| question.ray).collect();
    let seconds = alternating(&[
        Box::new(|| {
            let hits = |ray: &Ray| {
                let hit = |c: &&[Vec3; 3]| moller_trumbore::intersect(ray, **c, 0).is_some();
                corners.iter().filter(hit).count() as u64
            };
            rays.iter().map(hits).sum()
        }),
        Box::new(|| {
            let hits = |ray: &Ray| {
                let ray = ShearedRay::new(ray);
                let hit = |c: &&[Vec3; 3]| triangle::intersect(&ray, c, 0).is_some();
                corners.iter().filter(hit).count() as u64
            };
            rays.iter().map(hits).sum()
        }),
    ]);
    row("Möller–Trumbore", "watertight", "every triangle of `teapot`, one by one", &seconds)
}

/// Whole searches, with boxes that are tested one at a time.
fn boxes(name: &'static str) -> [String; 4] {
    let scene = if name == "terrain" { terrain(71) } else { scene(name) };
    let workload = Workload::record(name, scene, 160);
    let seconds = alternating(&[
        Box::new(stopwatch::<UnpaddedBox>(&workload)),
        Box::new(stopwatch::<SingleBox<false>>(&workload)),
    ]);
    let what = format!("all searches of a picture of `{name}`");
    row("bare slabs", "padded slabs", &what, &seconds)
}

/// Making the rays alone.
fn leaving() -> [String; 4] {
    let points = Ball::new(HERE).points([64, 64]);
    let light = Vec3::new(-5.0, 6.0, 4.0);
    let all = |leave: fn(&SurfacePoint, Vec3) -> Ray| {
        for _ in 0..200 {
            points.iter().for_each(|point| {
                black_box(leave(point, light));
            });
        }
        points.len() as u64
    };
    let seconds = alternating(&[Box::new(|| all(by_constant)), Box::new(|| all(by_bound))]);
    row("offset by a constant", "offset by a bound", "making the rays, nothing else", &seconds)
}

/// A whole picture, of which most is search.
fn picture() -> [String; 4] {
    let ball = Ball::new(HERE);
    let draw = |leave| ball.draw([120, 80], 16, leave).rgba.len() as u64;
    let seconds = alternating(&[Box::new(|| draw(by_constant)), Box::new(|| draw(by_bound))]);
    row("offset by a constant", "offset by a bound", "the ball and its shadow", &seconds)
}
