//! The stability laboratory: the stress catalogue, case by case.
//!
//! A *case* is a fact about numbers ("no ray meets again the sphere that it leaves"), with the
//! inputs that are likely to break it and an oracle that is not the code under test: double
//! precision, exact integers, or a closed form. Each has an id, S for spheres to G for pictures, by
//! which the comments of the other tests cite it.
//!
//! `cargo test -p stability` makes every case a test, with so many random inputs that all take less
//! than a minute. `cargo run --release -p stability -- --rays 1e9` runs the same functions for
//! hours, and prints for each how often it was tried, how often it failed and the largest error.
//! What fails is printed as exact bits, ready to become a test.
//!
//! | file | |
//! |---|---|
//! | [`case`] | what a case is, and the macro that makes tests of a table |
//! | [`trial`] | what a case reports to |
//! | [`laboratory`] | runs a case on all cores |
//! | [`report`] | the table of the long tier |
//! | [`random`] | random numbers of any magnitude |
//! | [`scenes`] | geometry without a file, and what a search finds in it |
//! | [`meshes`], [`closed`] | meshes without a hole, and rays from within |
//! | [`volumes`] | bounding volumes around some content |
//! | [`exact`] | arithmetic without rounding |
//! | [`replay`] | what fuzzers call, and what they once found |
//! | [`zoo`] | mistakes, planted to see that a test notices them |
//! | [`bits`] | units in the last place, and floats as exact bits |
//! | the others | one component each, in the order in which the course meets them |

pub mod bits;
pub mod case;
pub mod exact;
pub mod laboratory;
pub mod meshes;
pub mod random;
pub mod replay;
pub mod report;
pub mod scenes;
pub mod trial;
pub mod zoo;

pub mod aabb;
pub mod agreement;
pub mod camera;
pub mod closed;
pub mod estimators;
pub mod k_dop;
pub mod obb;
pub mod output;
pub mod plane;
pub mod refraction;
pub mod sampling;
pub mod shading;
pub mod sphere;
pub mod tree;
pub mod triangle;
pub mod volumes;

pub use case::{Case, Check};
pub use random::Random;
pub use trial::Trial;

/// Every case, component by component.
#[must_use]
pub fn catalogue() -> Vec<(&'static str, &'static [Case])> {
    vec![
        ("sphere", sphere::CASES),
        ("plane", plane::CASES),
        ("triangle", triangle::CASES),
        ("aabb", aabb::CASES),
        ("obb", obb::CASES),
        ("k_dop", k_dop::CASES),
        ("tree", tree::CASES),
        ("camera", camera::CASES),
        ("refraction", refraction::CASES),
        ("shading", shading::CASES),
        ("sampling", sampling::CASES),
        ("estimators", estimators::CASES),
        ("agreement", agreement::CASES),
        ("output", output::CASES),
    ]
}
