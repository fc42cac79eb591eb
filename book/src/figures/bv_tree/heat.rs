//! Where in the picture the work is: the tests of each pixel's camera ray.

use std::sync::OnceLock;

use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::{Intersect, Scene};
use workbench::{Counter, FilmPoint, Recorder};

use super::workload::scene;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::table::count;

const SIZE: [u32; 2] = [270, 180];

/// Tests of boxes and primitives for the ray through the middle of each pixel.
fn tests(scene: &Scene, search: &impl Intersect, recorder: &Recorder) -> Vec<u64> {
    let total = || recorder.get(Counter::VolumeTests) + recorder.get(Counter::PrimitiveTests);
    let [width, height] = SIZE;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let mut before = 0;
    let cost = |(x, y): (u32, u32)| {
        let point = FilmPoint { x: x as f32 + 0.5, y: y as f32 + 0.5, size: SIZE };
        let _ = search.intersect(&scene.camera.ray(point));
        let after = total();
        let cost = after - before;
        before = after;
        cost
    };
    pixels.map(cost).collect()
}

/// The teapot's tests by linear search, with a median tree, with a SAH tree.
fn maps_of_tests() -> &'static [Vec<u64>; 3] {
    static MAPS: OnceLock<[Vec<u64>; 3]> = OnceLock::new();
    MAPS.get_or_init(|| {
        let scene = scene("teapot");
        let tree = |builder| {
            let recorder = Recorder::new();
            tests(&scene, &BvTree::<Aabb, _>::build(&scene.geometry, builder, &recorder), &recorder)
        };
        // A linear search tests every primitive for every ray: there is nothing to render.
        let linear = vec![u64::from(scene.geometry.primitives()); (SIZE[0] * SIZE[1]) as usize];
        [linear, tree(Builder::Median), tree(Builder::Sah)]
    })
}

/// The colours of 1, 10, 100, 1000 and 10 000 tests, sRGB bytes.
const PALETTE: [[u8; 3]; 5] =
    [[12, 12, 40], [38, 60, 150], [190, 50, 110], [245, 150, 50], [255, 250, 205]];

/// The colour of a number of tests, on a logarithmic scale.
fn color(tests: f64) -> [u8; 4] {
    let place = libm::log10(tests.max(1.0)).min(3.999);
    let (from, share) = (place as usize, place.fract());
    let mix = |i: usize| {
        let [a, b] = [PALETTE[from][i], PALETTE[from + 1][i]].map(f64::from);
        (a + share * (b - a)) as u8
    };
    [mix(0), mix(1), mix(2), 255]
}

/// The three maps, and under them the scale, cut at every power of ten.
pub(super) fn maps() -> Drawing {
    let [width, height] = SIZE;
    let map = |tests: &Vec<u64>| {
        Picture::new(width, height, tests.iter().flat_map(|&n| color(n as f64)).collect())
    };
    let maps = Picture::side_by_side(&maps_of_tests().each_ref().map(map), 12);
    let decade = |decade: i32| {
        let [width, height] = [(maps.width - 3 * 4) / 4, 12];
        let tests = |x: u32| libm::pow(10.0, f64::from(decade) + f64::from(x) / f64::from(width));
        let row = || (0..width).flat_map(|x| color(tests(x)));
        Picture::new(width, height, (0..height).flat_map(|_| row()).collect())
    };
    let scale = Picture::side_by_side(&[0, 1, 2, 3].map(decade), 4);
    Picture::stacked(&[maps, scale], 10).into()
}

/// The mean and the dearest pixel of each map.
pub(super) fn numbers() -> Drawing {
    let mut numbers = Numbers::new();
    let [linear, median, sah] = maps_of_tests();
    let mean = |tests: &[u64]| tests.iter().sum::<u64>() as f64 / tests.len() as f64;
    let most = |tests: &[u64]| count(tests.iter().copied().max().unwrap_or(0));
    numbers.add("linear", most(linear));
    numbers.add("median-mean", format!("{:.0}", mean(median)));
    numbers.add("median-most", most(median));
    numbers.add("sah-mean", format!("{:.0}", mean(sah)));
    numbers.add("sah-most", most(sah));
    numbers.into()
}
