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
use crate::figures::bv_tree::rounding::lost_from_far_away;
use crate::figures::bv_tree::workload::{Workload, scene, stopwatch, terrain};
use crate::figures::ray_casting::seams::lost_at_edges;
use crate::figures::stability::leaks::lit;
use crate::figures::stability::stage::{Ball, HERE, by_bound, by_constant};
use crate::table::{Table, count};

pub(super) const MEASUREMENTS: &[Measurement] =
    &[Measurement { file: "stability/cost.md", take: cost }];

/// Times of the robust version relative to the naive one, and what it is for.
fn cost() -> Drawing {
    let mut table =
        Table::new(&["naive", "robust", "what is timed", "robust / naive", "failures removed"]);
    let triangle = removed(lost_at_edges(), "rays at edges of a closed ball");
    let slabs = removed(lost_from_far_away(), "rays at edges of a town, from far away");
    let offset = removed(lit(), "pixels of a dark room");
    let rows = [
        (triangles(), &triangle),
        (boxes("teapot"), &slabs),
        (boxes("terrain"), &slabs),
        (leaving(), &offset),
        (picture(), &offset),
    ];
    for ([naive, robust, what, ratio], failures) in rows {
        table.row([naive, robust, what, ratio, failures.clone()]);
    }
    table.into()
}

/// "933 of 10 000 rays at edges", or what is left of it.
fn removed(([naive, robust], of): ([u64; 2], u64), what: &str) -> String {
    let left = if robust == 0 { String::new() } else { format!("; {} are left", count(robust)) };
    format!("{} of {} {what}{left}", count(naive), count(of))
}

fn row(naive: &str, robust: &str, what: &str, seconds: &[f64]) -> [String; 4] {
    let ratio = format!("{:.2}", seconds[1] / seconds[0]);
    [naive.to_owned(), robust.to_owned(), what.to_owned(), ratio]
}

/// Every triangle of the teapot for some of its rays, as a linear search asks.
fn triangles() -> [String; 4] {
    let workload = Workload::record("teapot", scene("teapot"), 24);
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
        for _ in 0..2000 {
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
    let draw = |leave| ball.draw([240, 160], 16, leave).rgba.len() as u64;
    let seconds = alternating(&[Box::new(|| draw(by_constant)), Box::new(|| draw(by_bound))]);
    row("offset by a constant", "offset by a bound", "the ball and its shadow", &seconds)
}
