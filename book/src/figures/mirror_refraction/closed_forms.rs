//! What physics answers exactly, beside what the recursion answers.

use glam::{Vec3, vec3};
use mirror_refraction::fresnel::fresnel;
use mirror_refraction::{Limits, RayTracer};
use ray_casting::{Attributes, Camera, Geometry, LinearSearch, Ray, Rgb, Scene, Sphere};
use workbench::{CameraRecord, Exposure, MaterialRecord, SurfaceKind, Unwatched};

use crate::figures::Drawing;
use crate::table::Table;

const IOR: f32 = 1.5;

/// White surroundings, glass of the first material, and black of the second.
fn white(geometry: Geometry, materials: Vec<u32>) -> Scene {
    let record = CameraRecord {
        eye: [0.0, 0.0, 5.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov: 40.0,
        size: [1, 1],
    };
    let glass =
        MaterialRecord { surface: SurfaceKind::Glass, ni: IOR, ..MaterialRecord::new("glass") };
    Scene {
        camera: Camera::from(&record),
        focus: 5.0,
        exposure: Exposure { size: record.size, samples: None },
        geometry,
        attributes: Attributes { materials, ..Attributes::default() },
        materials: vec![glass, MaterialRecord::new("black")],
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::ZERO,
        background: Rgb::ONE,
        notices: Vec::new(),
    }
}

/// A square in the plane of height `z`, its front toward +z or toward −z.
fn square(geometry: &mut Geometry, z: f32, side: f32, up: bool) {
    let first = geometry.vertices.len() as u32;
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    geometry.vertices.extend(corners.map(|(x, y)| vec3(side * x, side * y, z)));
    let triangles = if up { [[0, 1, 2], [0, 2, 3]] } else { [[0, 2, 1], [0, 3, 2]] };
    geometry.triangles.extend(triangles.map(|triangle| triangle.map(|i| first + i)));
}

/// Two large faces of a slab before a black wall: what arrives is what the slab reflects.
fn slab() -> Scene {
    let mut geometry = Geometry::default();
    square(&mut geometry, 1.0, 9.0, true);
    square(&mut geometry, 0.0, 9.0, false);
    square(&mut geometry, -1.0, 9.0, true);
    white(geometry, vec![0, 0, 0, 0, 1, 1])
}

fn ball() -> Scene {
    let sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };
    white(Geometry { spheres: vec![sphere], ..Geometry::default() }, vec![0])
}

fn seen(scene: &Scene, x: f32, depth: u32) -> f64 {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let limits = Limits::new(Some(depth), 0.0);
    let tracer = RayTracer::new(scene, &[], &geometry, &Unwatched, limits);
    let ray = Ray::new(vec3(x, 0.25, 5.0), Vec3::NEG_Z);
    tracer.incident_radiance(ray).x.into()
}

/// The share that one face of the ball reflects of a ray at this distance from its axis.
fn reflectance(x: f32) -> f64 {
    let sin2 = x * x + 0.25 * 0.25;
    fresnel((1.0 - sin2).sqrt(), (1.0 - sin2 / (IOR * IOR)).sqrt(), 1.0 / IOR).into()
}

/// Slab and ball at several depths.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&["", "depth", "computed", "exact", "difference"]);
    let mut row = |what: &str, depth: u32, computed: f64, exact: f64| {
        table.row([
            what.to_owned(),
            depth.to_string(),
            format!("{computed:.8}"),
            format!("{exact:.8}"),
            format!("{:.1} · 10⁻⁸", 1e8 * (computed - exact).abs()),
        ]);
    };
    let slab = slab();
    let r = 0.04_f64;
    for depth in [1, 3, 5, 7, 31] {
        // One more pair of crossings for every two levels: r + (1 − r)² (r + r³ + …).
        let terms = (depth - 1) / 2;
        let tail: f64 = (0..terms).map(|k| libm::pow(r, f64::from(2 * k + 1))).sum();
        let exact = r + (1.0 - r) * (1.0 - r) * tail;
        row("slab, head on", depth, seen(&slab, 0.1, depth), exact);
    }
    let ball = ball();
    for (what, x) in [("ball, near its middle", 0.25), ("ball, near its rim", 0.9375)] {
        for depth in [2, 4, 8, 20] {
            let r = reflectance(x);
            let exact = 1.0 - (1.0 - r) * libm::pow(r, f64::from(depth - 1));
            row(what, depth, seen(&ball, x, depth), exact);
        }
    }
    table.into()
}
