//! Directions along which some primitives might be boxed tightly.

use glam::{DMat3, DVec3, Vec3};
use ray_casting::Geometry;

use crate::item::Item;

/// How many sweeps the Jacobi iteration makes: its error squares with each, so a handful suffice.
const SWEEPS: usize = 8;

/// Right-handed frames worth trying: along the largest triangle, and along the main directions in
/// which the corners spread.
pub(crate) fn candidates(items: &[Item], geometry: &Geometry) -> Vec<[Vec3; 3]> {
    [largest_triangle(items, geometry), Some(principal_axes(items, geometry))]
        .into_iter()
        .flatten()
        .filter(|axes| axes.iter().all(|a| a.is_finite()))
        .collect()
}

/// The longest edge of the largest triangle, and its normal.
fn largest_triangle(items: &[Item], geometry: &Geometry) -> Option<[Vec3; 3]> {
    let mut best = (0.0, None);
    for item in items {
        if geometry.sphere(item.primitive).is_some() {
            continue;
        }
        let [a, b, c] = geometry.corners(item.primitive).map(|v| v.as_dvec3());
        let normal = (b - a).cross(c - a);
        if normal.length_squared() > best.0 {
            let edges = [b - a, c - b, a - c];
            let longest = if edges[0].length() >= edges[1].length() { edges[0] } else { edges[1] };
            let longest = if longest.length() >= edges[2].length() { longest } else { edges[2] };
            best = (normal.length_squared(), Some((longest, normal)));
        }
    }
    let (edge, normal) = best.1?;
    Some(frame(edge.normalize(), normal.normalize()))
}

/// The eigenvectors of the corners' covariance matrix [Gottschalk96].
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

/// The eigenvectors of a symmetric matrix, as columns: cyclic Jacobi rotations [GolubVanLoan13] §8.5.
///
/// Each rotation by φ, with tan 2φ = 2 a_pq / (a_qq − a_pp), makes one pair of off-diagonal elements
/// zero, and the sum of their squares shrinks.
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
