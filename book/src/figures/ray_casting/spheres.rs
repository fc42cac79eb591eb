//! What the school formula does to spheres, and what ours does.

use glam::{Vec2, Vec3, vec3};
use ray_casting::math::sin_cos;
use ray_casting::{
    Attributes, Camera, Geometry, Hit, Intersect, LinearSearch, Ray, RayCaster, Rgb, Scene, Show,
    Sphere, sphere,
};
use workbench::{FilmSettings, Image, Sampler, Unwatched, expose};

use super::stage::scene;
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::plot::{Plot, Series, Style};
use crate::table::{Table, count};

const UNIT: Sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };

/// How many rays each distance is tried with.
const RAYS: u64 = 1000;

/// Rays along z from `distance` before the centre, within 0.9 of the axis, and their exact t.
fn distant_rays(distance: f32) -> impl Iterator<Item = (Ray, f64)> {
    (0..RAYS).filter_map(move |i| {
        let mut sampler = Sampler::new(1, i, 0);
        let [x, y] = sampler.next_2d().map(|u| 2.0 * u - 1.0);
        let (exact_x, exact_y) = (f64::from(x), f64::from(y));
        let rest = 1.0 - exact_x * exact_x - exact_y * exact_y;
        let t = f64::from(distance) - rest.sqrt();
        (rest > 0.19).then(|| (Ray::new(vec3(x, y, -distance), Vec3::Z), t))
    })
}

/// The distance of `t` from the exact value, in units of the last place of `t`.
fn ulps(t: f32, exact: f64) -> f64 {
    (f64::from(t) - exact).abs() / f64::from(t.next_up() - t)
}

/// The worst error of the hits that `intersect` finds at this distance, and how many it misses.
fn worst(distance: f32, intersect: impl Fn(&Ray) -> Option<f32>) -> (f64, u64) {
    let (mut worst, mut missed) = (0.0_f64, 0);
    for (ray, exact) in distant_rays(distance) {
        match intersect(&ray) {
            Some(t) => worst = worst.max(ulps(t, exact)),
            None => missed += 1,
        }
    }
    (worst, missed)
}

/// The error of both formulas against the distance from a unit sphere.
pub(super) fn ulp() -> Drawing {
    let curve = |name: &str, intersect: &dyn Fn(&Ray) -> Option<f32>| {
        // Not powers of two: there every formula is luckier than elsewhere.
        let distances = (1..=16).map(|k| 1.1 * f32::powi(2.0, k));
        let points = distances.map(|d| [f64::from(d), worst(d, intersect).0]).collect();
        Series { name: name.to_owned(), points, style: Style::LineAndMarks }
    };
    Plot {
        description: "The worst error of the school formula grows from a few units in the last \
                      place near the sphere to two thousand at a distance of some thousand radii, \
                      then falls; that of the stable form stays at half a unit."
            .to_owned(),
        x: Axis::log("distance from the centre, in radii"),
        y: Axis::log("worst error of t in ULP"),
        series: vec![
            curve("school", &|ray| sphere::intersect_naive(&UNIT, ray)),
            curve("stable", &|ray| UNIT.intersect(ray)),
        ],
    }
    .into()
}

/// The same for a single distance, in figures, and the rays that are lost.
pub(super) fn numbers() -> Drawing {
    let mut numbers = Numbers::new();
    let rays = distant_rays(1e4).count() as u64;
    let (school, lost) = worst(1e4, |ray| sphere::intersect_naive(&UNIT, ray));
    let (stable, stable_lost) = worst(1e4, |ray| UNIT.intersect(ray));
    numbers.add("rays", count(rays));
    numbers.add("school", format!("{school:.0}"));
    numbers.add("school-lost", count(lost));
    numbers.add("stable", format!("{stable:.2}"));
    numbers.add("stable-lost", count(stable_lost));
    numbers.into()
}

/// All spheres of a geometry by the school formula.
struct SchoolFormula<'a>(&'a Geometry);

impl Intersect for SchoolFormula<'_> {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let hits = (0..).zip(&self.0.spheres).filter_map(|(primitive, sphere)| {
            let t = sphere::intersect_naive(sphere, ray)?;
            Some(Hit { t, primitive, barycentric: Vec2::ZERO })
        });
        hits.min_by(|a, b| a.t.total_cmp(&b.t))
    }
}

/// A scene of one sphere, seen by `camera`, without lights.
fn lone_sphere(sphere: Sphere, camera: Camera) -> Scene {
    Scene {
        camera,
        geometry: Geometry { spheres: vec![sphere], ..Geometry::default() },
        attributes: Attributes { materials: vec![0], ..Attributes::default() },
        lights: Vec::new(),
        background: Rgb::new(0.05, 0.06, 0.08),
        ..scene("furnace")
    }
}

const PANEL: FilmSettings = FilmSettings { size: [240, 240], samples: 16, seed: 0, threads: None };

/// A unit sphere through telephoto lenses: by the school formula at a distance of 1000 and of 4096,
/// then by the stable form at the latter.
pub(super) fn distant() -> Drawing {
    let [near, far] = [1000.0, 4096.0].map(|distance| {
        let camera = Camera {
            eye: vec3(0.0, 0.0, distance),
            forward: Vec3::NEG_Z,
            right: Vec3::X,
            up: Vec3::Y,
            half_height: 1.2 / distance,
        };
        lone_sphere(UNIT, camera)
    });
    let panels = [
        draw(&near, &SchoolFormula(&near.geometry)),
        draw(&far, &SchoolFormula(&far.geometry)),
        draw(&far, &LinearSearch::new(&far.geometry, &Unwatched)),
    ];
    Picture::side_by_side(&panels.map(|image| Picture::from(&image)), 16).into()
}

fn draw(scene: &Scene, geometry: &impl Intersect) -> Image {
    let caster = RayCaster::new(scene, geometry, &Unwatched, Show::Facing);
    expose(&PANEL, |point, _| caster.incident_radiance(scene.camera.ray(point)))
}

/// A sphere of this radius below the origin, which an eye at `height` stands on.
fn ground_sphere(radius: f32) -> Sphere {
    Sphere { center: vec3(0.0, -radius, 0.0), radius }
}

/// Tiles of one unit on a ground sphere as large as the Earth, by the school formula and by ours.
pub(super) fn ground() -> Drawing {
    let sphere = ground_sphere(6_371_000.0);
    let (sin, cos) = sin_cos(0.35);
    let camera = Camera {
        eye: vec3(0.0, 1.7, 0.0),
        forward: vec3(0.0, -sin, -cos),
        right: Vec3::X,
        up: vec3(0.0, cos, -sin),
        half_height: 0.5,
    };
    let scene = lone_sphere(sphere, camera);
    let tiles = |geometry: &dyn Intersect| {
        let image = expose(&PANEL, |point, _| {
            let ray = scene.camera.ray(point);
            let Some(hit) = geometry.intersect(&ray) else { return scene.background };
            let position = scene.surface(&ray, &hit).position;
            let tile = position.x.floor() + position.z.floor();
            Rgb::splat(if tile.rem_euclid(2.0) < 1.0 { 0.7 } else { 0.1 })
        });
        Picture::from(&image)
    };
    let school = SchoolFormula(&scene.geometry);
    let stable = LinearSearch::new(&scene.geometry, &Unwatched);
    Picture::side_by_side(&[tiles(&school), tiles(&stable)], 16).into()
}

/// A ray from above the top of a ground sphere, 3° to 86° down, and its exact t if it hits.
fn ground_ray(sphere: Sphere, i: u64) -> Option<(Ray, f64)> {
    let mut sampler = Sampler::new(2, i, 0);
    let height = 0.1 + 3.0 * sampler.next_1d();
    let (sin, cos) = sin_cos((3.0 + 83.0 * sampler.next_1d()).to_radians());
    let ray = Ray::new(vec3(0.0, height, 0.0), vec3(cos, -sin, 0.0));

    // With the eye above the centre, c = f·f − r² factors without cancelling.
    let (d, r, y) = (ray.direction.as_dvec3(), f64::from(sphere.radius), f64::from(height));
    let (a, b, c) = (d.length_squared(), -(y + r) * d.y, y * (y + 2.0 * r));
    let discriminant = b * b - a * c;
    (discriminant > 0.0).then(|| (ray, c / (b + discriminant.sqrt())))
}

/// The worst relative error of t above ground spheres of several radii.
pub(super) fn ground_errors() -> Drawing {
    let mut table = Table::new(&["radius", "rays that hit", "school formula", "stable form"]);
    for exponent in [2, 3, 4, 5, 6, 7] {
        let sphere = ground_sphere(f32::powi(10.0, exponent));
        let (mut errors, mut rays) = ([0.0_f64; 2], 0);
        for (ray, exact) in (0..20_000).filter_map(|i| ground_ray(sphere, i)) {
            rays += 1;
            let hits = [sphere::intersect_naive(&sphere, &ray), sphere.intersect(&ray)];
            for (error, hit) in errors.iter_mut().zip(hits) {
                let t = hit.map_or(f64::INFINITY, f64::from);
                *error = error.max((t - exact).abs() / exact);
            }
        }
        let [school, stable] = errors.map(scientific);
        table.row([format!("$10^{exponent}$"), count(rays), school, stable]);
    }
    table.into()
}

/// A number like 1.5 · 10⁻⁴, as a formula.
fn scientific(x: f64) -> String {
    let text = format!("{x:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("${digits} \\cdot 10^{{{exponent}}}$")
}
