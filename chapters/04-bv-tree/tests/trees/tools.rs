//! Geometries and rays.

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree};
use glam::Vec3;
use ray_casting::{Geometry, Intersect, LinearSearch, Ray};
use workbench::{Counter, Recorder, Sampler, Unwatched};

pub(crate) const BUILDERS: [Builder; 2] = [Builder::Median, Builder::Sah];

/// A point of the cube from −1 to 1.
pub(crate) fn in_cube(sampler: &mut Sampler) -> Vec3 {
    2.0 * Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d()) - 1.0
}

/// Triangles with vertices of their own.
pub(crate) fn triangles(corners: impl IntoIterator<Item = [Vec3; 3]>) -> Geometry {
    let vertices: Vec<Vec3> = corners.into_iter().flatten().collect();
    let triangles = (0..vertices.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Geometry { vertices, triangles, spheres: Vec::new() }
}

/// Small triangles anywhere in the cube.
pub(crate) fn soup(count: u64, size: f32) -> Geometry {
    triangles((0..count).map(|i| {
        let mut sampler = Sampler::new(1, i, 0);
        let center = in_cube(&mut sampler);
        [(); 3].map(|()| center + size * in_cube(&mut sampler))
    }))
}

/// Rays in and around the cube.
pub(crate) fn rays(count: u64) -> impl Iterator<Item = Ray> {
    (0..count).map(|i| {
        let mut sampler = Sampler::new(2, i, 0);
        let (origin, target) = (3.0 * in_cube(&mut sampler), in_cube(&mut sampler));
        Ray::new(origin, (target - origin).normalize())
    })
}

/// A tree that nobody watches.
pub(crate) fn tree<V: BoundingVolume>(
    geometry: &Geometry,
    builder: Builder,
) -> BvTree<'static, V, Unwatched> {
    BvTree::build(geometry, builder, &Unwatched)
}

/// Volume and primitive tests of these rays.
pub(crate) fn tests<V: BoundingVolume>(
    geometry: &Geometry,
    builder: Builder,
    rays: impl IntoIterator<Item = Ray>,
) -> [u64; 2] {
    let recorder = Recorder::new();
    let tree = BvTree::<V, _>::build(geometry, builder, &recorder);
    for ray in rays {
        let found = tree.intersect(&ray).is_some();
        assert_eq!(tree.occluded(&ray), found, "occluded, {ray:?}");
    }
    [Counter::VolumeTests, Counter::PrimitiveTests].map(|counter| recorder.get(counter))
}

/// Asserts that trees of both builders find what linear search finds.
pub(crate) fn check_hits(geometry: &Geometry, rays: &[Ray], case: &str) {
    let linear = LinearSearch::new(geometry, &Unwatched);
    let trees = BUILDERS.map(|builder| tree::<Aabb>(geometry, builder));
    for ray in rays {
        let expected = linear.intersect(ray);
        for (tree, builder) in trees.iter().zip(BUILDERS) {
            let found = tree.intersect(ray);
            assert_eq!(found, expected, "{case}, {builder:?}: {ray:?}");
            assert_eq!(tree.occluded(ray), expected.is_some(), "{case}, {builder:?}: {ray:?}");
        }
    }
}
