//! The same scene at many sizes and in many places, by a constant and by a bound.

use glam::vec3;

use super::stage::{Ball, HERE, Leave, Place, by_bound, by_constant, unmoved};
use crate::figures::Drawing;
use crate::picture::Picture;
use crate::table::{Table, count};

const SIZE: [u32; 2] = [180, 120];
const SAMPLES: u32 = 4;

/// Powers of ten by which the scene is enlarged.
const SCALES: [i32; 5] = [-6, -3, 0, 3, 6];

/// How far it is moved, in each direction a different part of it.
const DISTANCES: [f32; 4] = [0.0, 1e4, 1e6, 1e7];

/// Its radius there: at 10⁷ floats are one apart, and smaller things have no shape.
const RADIUS: f32 = 100.0;

fn scaled(exponent: i32) -> Place {
    Place { scale: 10.0_f64.powi(exponent) as f32, ..HERE }
}

fn moved(distance: f32) -> Place {
    Place { scale: RADIUS, offset: distance * vec3(0.6, -0.35, 1.0) }
}

fn draw(place: Place, leave: Leave) -> Picture {
    Ball::new(place).draw(SIZE, SAMPLES, leave)
}

/// A row of pictures for each way to leave a surface.
fn rows(places: &[Place], ways: &[Leave]) -> Drawing {
    let row = |&leave: &Leave| {
        let panels: Vec<_> = places.iter().map(|&place| draw(place, leave)).collect();
        Picture::side_by_side(&panels, 8)
    };
    let rows: Vec<_> = ways.iter().map(row).collect();
    Picture::stacked(&rows, 8).into()
}

/// Shadow rays that start at the rounded point, and by the bound.
pub(super) fn acne() -> Drawing {
    let panels =
        [unmoved as Leave, by_bound].map(|leave| Ball::new(HERE).draw([300, 200], 4, leave));
    Picture::side_by_side(&panels, 8).into()
}

/// The ball and its shadow, in a scene of which a thousandth is a large part.
pub(super) fn floating() -> Drawing {
    let panels = [by_constant as Leave, by_bound].map(|leave| {
        let small = Place { scale: 5e-4, ..HERE };
        Ball::new(small).draw([360, 240], 16, leave).crop([120, 10], [180, 140]).enlarged(2)
    });
    Picture::side_by_side(&panels, 8).into()
}

pub(super) fn scales() -> Drawing {
    rows(&SCALES.map(scaled), &[by_constant, by_bound])
}

pub(super) fn offsets() -> Drawing {
    rows(&DISTANCES.map(moved), &[by_constant, by_bound])
}

/// How many pixels of two pictures differ by more than `codes` in any channel.
fn different(a: &Picture, b: &Picture, codes: u8) -> u64 {
    let pixels = a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4));
    let differ = pixels.filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > codes));
    differ.count() as u64
}

/// One sample lit or not changes a pixel by more than this.
const CODES: u8 = 8;

/// A row of counts for each way: pixels that differ from those of `places[original]` by the bound.
fn counts(first: &str, names: &[String], places: &[Place], original: usize) -> Drawing {
    let header: Vec<&str> = [first].into_iter().chain(names.iter().map(String::as_str)).collect();
    let mut table = Table::new(&header);
    let right = draw(places[original], by_bound);
    let ways: [(&str, Leave); 2] = [("by a constant", by_constant), ("by the bound", by_bound)];
    for (name, leave) in ways {
        let wrong = places.iter().map(|&place| different(&draw(place, leave), &right, CODES));
        table.row([name.to_owned()].into_iter().chain(wrong.map(count)));
    }
    table.into()
}

/// Of 21 600 pixels, how many are not those of the scene at its own size.
pub(super) fn scale_counts() -> Drawing {
    let names = SCALES.map(|exponent| match exponent {
        0 => "1".to_owned(),
        exponent if exponent < 0 => format!("10⁻{}", superscript(-exponent)),
        exponent => format!("10{}", superscript(exponent)),
    });
    counts("enlarged by", &names, &SCALES.map(scaled), 2)
}

fn superscript(digit: i32) -> char {
    ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize]
}

/// Likewise for a scene that is moved away.
pub(super) fn offset_counts() -> Drawing {
    let names = DISTANCES.map(|distance| count(distance as u64));
    counts("moved by", &names, &DISTANCES.map(moved), 0)
}
