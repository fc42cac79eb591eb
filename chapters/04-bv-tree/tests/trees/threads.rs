//! The same tree, whoever builds it.

use bv_tree::{Aabb, BoundingVolume, KDop, Obb, Shape};
use rayon::ThreadPoolBuilder;

use crate::tools::{BUILDERS, rays, soup, tests, tree};

/// Enough triangles that every step is divided among threads.
const TRIANGLES: u64 = 20_000;

/// The shape of a tree and what its rays test, when `threads` build it.
fn built_by<V: BoundingVolume>(threads: usize) -> Vec<(Shape, [u64; 2])> {
    let geometry = soup(TRIANGLES, 0.02);
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.unwrap_or_else(|error| panic!("{threads} threads: {error}"));
    pool.install(|| {
        BUILDERS
            .map(|builder| {
                let shape = tree::<V>(&geometry, builder).shape();
                (shape, tests::<V>(&geometry, builder, rays(500)))
            })
            .to_vec()
    })
}

fn check<V: BoundingVolume>(name: &str) {
    let one = built_by::<V>(1);
    for threads in [2, 5] {
        let many = built_by::<V>(threads);
        assert_eq!(many, one, "{name}: shapes and tests by {threads} threads, and by one");
    }
}

#[test]
fn the_number_of_threads_changes_no_tree() {
    check::<Aabb>("AABB");
    check::<Obb>("OBB");
    check::<KDop<7>>("14-DOP");
}
