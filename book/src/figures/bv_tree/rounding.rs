//! What a careless slab test loses.

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, LinearSearch, Ray};
use workbench::{Sampler, Unwatched};

use super::naive::{FolkloreBox, UnpaddedBox, point_of_edge};
use super::workload::{blob, terrain};
use crate::figures::Drawing;
use crate::picture::Picture;
use crate::table::{Table, count};

/// Blocks along each side of the city, and pixels along each block.
const BLOCKS: u32 = 12;
const PIXELS: u32 = 12;

/// Blocks of whole sizes at whole places: roofs and the walls around them.
fn town() -> Geometry {
    let mut geometry = Geometry::default();
    for i in 0..BLOCKS * BLOCKS {
        let height = (1.0 + 8.0 * Sampler::new(6, u64::from(i), 0).next_1d()).floor();
        let (low, size) =
            (vec3((i % BLOCKS) as f32, 0.0, (i / BLOCKS) as f32), vec3(1.0, height, 1.0));
        let first = geometry.vertices.len() as u32;
        let corner = |c: u32| vec3((c & 1) as f32, (c >> 1 & 1) as f32, (c >> 2) as f32);
        geometry.vertices.extend((0..8).map(|c| low + size * corner(c)));
        for [a, b, c, d] in [[2, 6, 7, 3], [4, 5, 7, 6], [1, 3, 7, 5], [0, 2, 3, 1], [0, 4, 6, 2]] {
            geometry.triangles.extend([[a, b, c], [a, c, d]].map(|t| t.map(|v| first + v)));
        }
    }
    geometry
}

fn tree<V: BoundingVolume>(geometry: &Geometry) -> BvTree<'static, V, Unwatched> {
    BvTree::build(geometry, Builder::Sah, &Unwatched)
}

/// A plan of the town: parallel rays from above, one through every twelfth of a block.
fn plan(search: &impl Intersect) -> Picture {
    let side = BLOCKS * PIXELS;
    let pixels = (0..side).flat_map(|y| (0..side).map(move |x| (x, y)));
    let color = |(x, y): (u32, u32)| {
        let place = |i: u32| i as f32 / PIXELS as f32;
        let ray = Ray::new(vec3(place(x), 10.0, place(y)), Vec3::NEG_Y);
        match search.intersect(&ray) {
            Some(hit) => {
                let height = 10.0 - hit.t;
                [70.0 + 20.0 * height, 76.0 + 18.0 * height, 90.0 + 12.0 * height]
            }
            None => [200.0, 30.0, 30.0],
        }
    };
    let rgba = pixels.map(color).flat_map(|[r, g, b]| [r as u8, g as u8, b as u8, 255]);
    Picture::new(side, side, rgba.collect()).enlarged(2)
}

/// The plan of the town with the folklore's boxes and with ours; red is nothing.
pub(super) fn city() -> Drawing {
    let town = town();
    let panels = [plan(&tree::<FolkloreBox>(&town)), plan(&tree::<Aabb>(&town))];
    Picture::side_by_side(&panels, 16).into()
}

/// Rays that linear search finds a hit for and a tree does not.
pub(super) fn lost() -> Drawing {
    let mut table = Table::new(&["rays", "that hit", "`min`, `max`", "no padding", "ours"]);
    let side = BLOCKS * PIXELS;
    let plan = (0..side * side).map(|i| {
        let place = |i: u32| i as f32 / PIXELS as f32;
        Ray::new(vec3(place(i % side), 10.0, place(i / side)), Vec3::NEG_Y)
    });
    let town = town();
    row(&mut table, "the plan of the town", &town, plan.collect());
    row(&mut table, "the town, aimed at edges", &town, aimed(&town, 10.0));
    row(&mut table, "the town, aimed at edges from far away", &town, aimed(&town, 1000.0));
    let ball = blob(23).geometry;
    row(&mut table, "a ball, aimed at edges from near by", &ball, aimed(&ball, 1.5));
    row(&mut table, "the same from far away", &ball, aimed(&ball, 300.0));
    let land = terrain(22).geometry;
    row(&mut table, "a terrain, aimed at edges", &land, aimed(&land, 100.0));
    table.into()
}

/// Rays from about `distance` away to points of edges.
fn aimed(geometry: &Geometry, distance: f32) -> Vec<Ray> {
    let ray = |i: u64| {
        let mut sampler = Sampler::new(9, i, 0);
        let mut cube = || {
            let [x, y] = sampler.next_2d();
            2.0 * vec3(x, y, sampler.next_1d()) - 1.0
        };
        let direction = cube().normalize();
        let triangle = (sampler.next_1d() * geometry.triangles.len() as f32) as u32;
        let target = point_of_edge(geometry, triangle, sampler.next_1d());
        let origin = target - distance * direction;
        Ray::new(origin, (target - origin).normalize())
    };
    (0..5_000).map(ray).collect()
}

fn row(table: &mut Table, name: &str, geometry: &Geometry, rays: Vec<Ray>) {
    let (hits, lost) = counts(geometry, rays);
    let [folklore, unpadded, ours] = lost.map(count);
    table.row([name.to_owned(), count(hits), folklore, unpadded, ours]);
}

/// How many rays hit something, and how many of them trees of three kinds of boxes lose: the
/// folklore's, boxes without padding, and ours.
fn counts(geometry: &Geometry, rays: Vec<Ray>) -> (u64, [u64; 3]) {
    let oracle = LinearSearch::new(geometry, &Unwatched);
    let hits: Vec<_> =
        rays.into_iter().filter_map(|ray| Some((ray, oracle.intersect(&ray)?.t))).collect();
    // A tree loses a ray if it finds nothing, or only something that lies behind.
    let lost = |search: &dyn Intersect| {
        let is_lost = |(ray, t): &&(Ray, f32)| search.intersect(ray).is_none_or(|hit| hit.t > *t);
        hits.iter().filter(is_lost).count() as u64
    };
    let trees = [
        lost(&tree::<FolkloreBox>(geometry)),
        lost(&tree::<UnpaddedBox>(geometry)),
        lost(&tree::<Aabb>(geometry)),
    ];
    (hits.len() as u64, trees)
}

/// Rays at edges of the town from far away that trees lose, without padding and with, and how many
/// they are.
pub(crate) fn lost_from_far_away() -> ([u64; 2], u64) {
    let town = town();
    let (hits, [_, unpadded, ours]) = counts(&town, aimed(&town, 1000.0));
    ([unpadded, ours], hits)
}
