//! Closed meshes, which no ray may leave: T3 and T4.

use std::cmp::Ordering;

use bv_tree::{Aabb, Builder, BvTree};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, Ray, SurfacePoint};
use workbench::Unwatched;

use super::Corners;
use crate::bits;
use crate::exact;
use crate::meshes::{ball, within};
use crate::scenes::{nearest, scene, toward};
use crate::trial::Trial;

/// [`sealed`] at the origin, where the test of Möller and Trumbore loses 5.8 % of the rays to
/// vertices and 9.3 % of those to edges.
pub(super) fn no_ray_leaves_a_closed_mesh(trial: &mut Trial) {
    sealed(trial, Vec3::ZERO);
}

/// [`sealed`] at (1000, −2000, 500) and at (148376, 1234, −223423), a place from the tests of
/// Embree.
pub(super) fn no_ray_leaves_a_closed_mesh_where_coordinates_are_coarse(trial: &mut Trial) {
    let rays = trial.rays;
    trial.rays = rays.div_ceil(2);
    sealed(trial, vec3(1000.0, -2000.0, 500.0));
    trial.rays = rays / 2;
    sealed(trial, vec3(148_376.0, 1234.0, -223_423.0));
}

/// A ball of 448 triangles between the radii 1 and 6 around `center`, another one each time, and
/// rays from within: a quarter anywhere, a quarter to a vertex, a quarter to a point of an edge,
/// and a quarter that leave inward from where they met the ball, close to an edge.
///
/// The search is that of a tree, which has the same triangle test and twenty times the rays.
fn sealed(trial: &mut Trial, center: Vec3) {
    let ball = scene(ball(center, &mut trial.random));
    let geometry = &ball.geometry;
    let tree = BvTree::<Aabb, _>::build(geometry, Builder::Sah, &Unwatched);
    for i in 0..trial.rays {
        let random = &mut trial.random;
        let origin = within(center, random);
        let corners = geometry.corners(random.below(geometry.triangles.len() as u64) as u32);
        let [a, b, c] = corners.map(|v| v.as_dvec3());
        let edge = a.lerp(b, random.unit());
        let ray = match i % 4 {
            0 => Some(Ray::new(origin, random.direction().as_vec3())),
            1 => toward(origin, corners[0]),
            2 => toward(origin, edge.as_vec3()),
            _ => toward(origin, edge.lerp(c, random.magnitude(-5.0, 0.0)).as_vec3()),
        };
        let Some(ray) = ray else { continue };
        let hit = tree.intersect(&ray);
        trial.require(hit.is_some(), || {
            let by_all = nearest(geometry, &ray);
            format!("{} leaves a ball around {center}; without a tree: {by_all:?}", bits::ray(&ray))
        });
        if let Some(hit) = hit.filter(|_| i % 4 == 3) {
            leave_inward(trial, geometry, &tree, &ball.surface(&ray, &hit));
        }
    }
}

/// A ray back into the closed mesh that `surface` belongs to. Where the origin is moved off one
/// surface within a few floats of another, it may be moved through that; so a ray may leave if it
/// crosses an even number of triangles in exact arithmetic: then it has started outside.
fn leave_inward(trial: &mut Trial, mesh: &Geometry, tree: &impl Intersect, surface: &SurfacePoint) {
    let inward = surface.facing_normal().as_dvec3();
    let direction = trial.random.direction();
    let direction = direction * direction.dot(inward).signum();
    let next = surface.spawn(direction.as_vec3());
    let crossings = || {
        let triangles = 0..mesh.triangles.len() as u32;
        triangles.filter(|&i| crosses(&next, mesh.corners(i))).count()
    };
    trial.require(tree.occluded(&next) || crossings() % 2 == 0, || {
        format!("{} leaves from {surface:?}", bits::ray(&next))
    });
}

/// Whether a ray meets the inside of a triangle, in exact arithmetic.
fn crosses(ray: &Ray, corners: Corners) -> bool {
    let [a, b, c] = corners;
    let first = exact_side(ray, a, b);
    let inside = first.is_ne() && exact_side(ray, b, c) == first && exact_side(ray, c, a) == first;
    inside && {
        let n = exact::normal(corners);
        let height = exact::dot(&n, &exact::difference(a, ray.origin));
        height.sign() == exact::dot(&n, &exact::vector(ray.direction)).sign()
    }
}

/// The sign of d·((a − o) × (b − o)). Its error in double precision is below 2⁻⁴⁹ of the product of
/// the three lengths; only closer to zero is it computed without any.
fn exact_side(ray: &Ray, a: Vec3, b: Vec3) -> Ordering {
    let d = ray.direction.as_dvec3();
    let [from, to] = [a, b].map(|v| v.as_dvec3() - ray.origin.as_dvec3());
    let quick = d.dot(from.cross(to));
    if quick.abs() > 1e-12 * d.length() * from.length() * to.length() {
        return quick.total_cmp(&0.0);
    }
    let [from, to] = [a, b].map(|v| exact::difference(v, ray.origin));
    exact::dot(&exact::vector(ray.direction), &exact::cross(&from, &to)).sign()
}
