//! What the tests of rays against spheres and triangles promise, case by case.

mod closed_mesh;
mod plane;
mod self_hits;
mod spawn;
mod sphere;
mod tools;
mod triangle;
