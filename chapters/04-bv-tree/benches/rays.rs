//! Rays a second, build time and bytes a triangle: `cargo bench -p bv-tree`.
//!
//! One thread for the rays, all cores for building. Compare only figures of one run.

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use generator::{Mesh, Surface, TessellatedSpheres};
use glam::Vec3;
use ray_casting::{Geometry, Intersect, Ray};
use workbench::{Sampler, Unwatched};

/// Rays in each set.
const RAYS: u64 = 20_000;

fn main() {
    for scene in SCENES {
        let geometry = geometry(scene);
        let shape = tree::<Aabb>(&geometry, Builder::Sah).shape();
        let triangles = geometry.triangles.len();
        let bytes = shape.bytes as f64 / triangles as f64;
        println!(
            "{scene}: {triangles} triangles, depth {}, {bytes:.1} bytes a triangle",
            shape.depth
        );
    }
    divan::main();
}

const SCENES: [&str; 3] = ["sphereflake", "terrain", "blob"];

fn geometry(scene: &str) -> Geometry {
    let Mesh { positions, triangles } = match scene {
        "sphereflake" => {
            TessellatedSpheres { spheres: generator::sphereflake(3), rings: 12 }.mesh()
        }
        "terrain" => generator::terrain(generator::side_for(200_000), 1),
        _ => generator::blob(generator::rings_for(200_000)),
    };
    let vertices = positions.into_iter().map(Vec3::from_array).collect();
    Geometry { vertices, triangles, spheres: Vec::new() }
}

fn tree<V: BoundingVolume>(geometry: &Geometry, builder: Builder) -> BvTree<'static, V, Unwatched> {
    BvTree::build(geometry, builder, &Unwatched)
}

/// Rays from one point outside to points of the triangles: what a camera sends.
fn primary(geometry: &Geometry) -> Vec<Ray> {
    let count = geometry.vertices.len() as u64;
    let center = geometry.vertices.iter().sum::<Vec3>() / count as f32;
    let eye = center + 3.0 * (geometry.vertices[0] - center) + Vec3::ONE;
    let target = |i| geometry.vertices[(i * count / RAYS) as usize];
    (0..RAYS).map(|i| Ray::new(eye, (target(i) - eye).normalize_or(Vec3::Y))).collect()
}

/// Rays between random points of the triangles: what light does after a few bounces.
fn random(geometry: &Geometry) -> Vec<Ray> {
    let point = |sampler: &mut Sampler| {
        let index = (sampler.next_1d() * geometry.vertices.len() as f32) as usize;
        geometry.vertices[index.min(geometry.vertices.len() - 1)]
    };
    let between = |from: Vec3, to: Vec3| {
        let direction = (to - from).normalize_or(Vec3::Y);
        Ray::new(from - direction, direction)
    };
    let ray = |i| {
        let mut sampler = Sampler::new(1, i, 0);
        between(point(&mut sampler), point(&mut sampler))
    };
    (0..RAYS).map(ray).collect()
}

fn trace<V: BoundingVolume>(bencher: Bencher, scene: &str, rays: fn(&Geometry) -> Vec<Ray>) {
    let geometry = geometry(scene);
    let (tree, rays) = (tree::<V>(&geometry, Builder::Sah), rays(&geometry));
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        for ray in &rays {
            black_box(tree.intersect(ray));
        }
    });
}

#[divan::bench(args = SCENES, types = [Aabb, Obb, KDop<7>, KDop<13>], sample_count = 10)]
fn nearest_hit_of_primary_rays<V: BoundingVolume>(bencher: Bencher, scene: &str) {
    trace::<V>(bencher, scene, primary);
}

#[divan::bench(args = SCENES, types = [Aabb, Obb, KDop<7>, KDop<13>], sample_count = 10)]
fn nearest_hit_of_random_rays<V: BoundingVolume>(bencher: Bencher, scene: &str) {
    trace::<V>(bencher, scene, random);
}

#[divan::bench(args = SCENES, sample_count = 10)]
fn any_hit_of_random_rays(bencher: Bencher, scene: &str) {
    let geometry = geometry(scene);
    let (tree, rays) = (tree::<Aabb>(&geometry, Builder::Sah), random(&geometry));
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        for ray in &rays {
            black_box(tree.occluded(ray));
        }
    });
}

#[divan::bench(args = SCENES, consts = [false, true], sample_count = 5)]
fn build<const SAH: bool>(bencher: Bencher, scene: &str) {
    let geometry = geometry(scene);
    let builder = if SAH { Builder::Sah } else { Builder::Median };
    let triangles = ItemsCount::new(geometry.triangles.len());
    bencher.counter(triangles).bench_local(|| tree::<Aabb>(&geometry, builder));
}
