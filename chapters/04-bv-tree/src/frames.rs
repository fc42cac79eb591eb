//! Directions along which some primitives might be boxed tightly.

use glam::{DMat3, DVec3, Vec3};
use ray_casting::Geometry;

use crate::item::Item;

/// How many sweeps the Jacobi iteration makes: its error squares with each, so a handful suffice.
const SWEEPS: usize = 8;

/// Right-handed frames worth trying: along edges of the largest triangle, and along the main
/// directions in which the corners spread.
pub(crate) fn candidates(items: &[Item], geometry: &Geometry) -> Vec<[Vec3; 3]> {
    let along_edges = largest_triangle(items, geometry).map_or_else(Vec::new, |corners| {
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        extreme_edges(corners).map(|edge| frame(edge.normalize(), normal)).to_vec()
    });
    along_edges
        .into_iter()
        .chain([principal_axes(items, geometry)])
        .filter(|axes| axes.iter().all(|a| a.is_finite()))
        .collect()
}

/// The corners of the triangle with the largest area, if any has one.
fn largest_triangle(items: &[Item], geometry: &Geometry) -> Option<[DVec3; 3]> {
    let mut best = (0.0, None);
    for item in items {
        if geometry.sphere(item.primitive).is_some() {
            continue;
        }
        let [a, b, c] = geometry.corners(item.primitive).map(|v| v.as_dvec3());
        let area = (b - a).cross(c - a).length_squared();
        if area > best.0 {
            best = (area, Some([a, b, c]));
        }
    }
    best.1
}

/// The longest edge, which suits a sliver, and the shortest: in half of a rectangle, the longest is
/// the diagonal, the shortest a side.
fn extreme_edges([a, b, c]: [DVec3; 3]) -> [DVec3; 2] {
    let mut edges = [b - a, c - b, a - c];
    edges.sort_by(|e, f| e.length_squared().total_cmp(&f.length_squared()));
    [edges[2], edges[0]]
}

/// The eigenvectors of the corners' covariance matrix \[Gottschalk96].
fn principal_axes(items: &[Item], geometry: &Geometry) -> [Vec3; 3] {
    let points = || items.iter().flat_map(|item| corners(item, geometry));
    let count = points().count() as f64;
    let mean = points().sum::<DVec3>() / count;
    let mut covariance = DMat3::ZERO;
    for point in points() {
        let p = point - mean;
        covariance += DMat3::from_cols(p.x * p, p.y * p, p.z * p);
    }
    let vectors = eigenvectors(covariance / count);
    frame(vectors.x_axis, vectors.y_axis)
}

/// A triangle's corners; a sphere stands in with its centre.
fn corners(item: &Item, geometry: &Geometry) -> impl Iterator<Item = DVec3> {
    let points = match geometry.sphere(item.primitive) {
        None => geometry.corners(item.primitive),
        Some(sphere) => [sphere.center; 3],
    };
    points.into_iter().map(|v| v.as_dvec3())
}

/// A frame whose first axis is `first`, and whose second is as near to `second` as it can be.
fn frame(first: DVec3, second: DVec3) -> [Vec3; 3] {
    let third = first.cross(second).normalize();
    [first, third.cross(first), third].map(|axis| axis.as_vec3())
}

/// The eigenvectors of a symmetric matrix, as columns: cyclic Jacobi rotations \[GolubVanLoan13]
/// §8.5.
///
/// Each rotation by φ, with tan 2φ = 2 a_pq / (a_qq − a_pp), makes one pair of off-diagonal
/// elements zero, and the sum of their squares shrinks.
fn eigenvectors(mut matrix: DMat3) -> DMat3 {
    let mut vectors = DMat3::IDENTITY;
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off_diagonal = matrix.col(p)[q];
            if off_diagonal == 0.0 {
                continue;
            }
            let theta = (matrix.col(q)[q] - matrix.col(p)[p]) / (2.0 * off_diagonal);
            let tan = 1.0_f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
            let cos = 1.0 / (tan * tan + 1.0).sqrt();
            let sin = tan * cos;

            let mut rotation = DMat3::IDENTITY;
            rotation.col_mut(p)[p] = cos;
            rotation.col_mut(q)[q] = cos;
            rotation.col_mut(q)[p] = sin;
            rotation.col_mut(p)[q] = -sin;
            matrix = rotation.transpose() * matrix * rotation;
            vectors *= rotation;
        }
    }
    vectors
}
