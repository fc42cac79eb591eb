//! The same light by directions and by points, and what comes of mixing the two.

use std::f64::consts::PI;

use glam::Vec3;
use ray_casting::{EndPoint, Intersect, LinearSearch, Rgb, Scene, SurfacePoint};
use rendering_equation::directions::{
    cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere, uniform_hemisphere_pdf,
};
use rendering_equation::measures::{geometry_term, pdf_solid_angle};
use rendering_equation::monte_carlo::integrate;
use rendering_equation::{Brdf, Material, Materials};
use workbench::{FilmSettings, Image, Sampler, Unwatched, expose};

use super::stage::{scene, settings};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::table::Table;

/// The lamp of the Cornell box: a corner, the two edges from there, and its normal.
struct Lamp {
    corner: Vec3,
    edges: [Vec3; 2],
    normal: Vec3,
    material: u32,
    radiance: Rgb,
}

impl Lamp {
    fn of(scene: &Scene) -> Self {
        let shines = |m: u32| scene.materials[m as usize].ke != [0.0; 3];
        let first = scene.attributes.materials.iter().position(|&m| shines(m));
        let first = first.expect("the box has a lamp") as u32;
        let ([a, b, _], [_, _, d]) =
            (scene.geometry.corners(first), scene.geometry.corners(first + 1));
        let edges = [b - a, d - a];
        let material = scene.attributes.materials[first as usize];
        let radiance = Rgb::from_array(scene.materials[material as usize].ke);
        Self { corner: a, edges, normal: edges[0].cross(edges[1]).normalize(), material, radiance }
    }

    fn area(&self) -> f32 {
        self.edges[0].cross(self.edges[1]).length()
    }

    /// A uniform point.
    fn point(&self, [u, v]: [f32; 2]) -> EndPoint {
        let [e1, e2] = self.edges.map(|edge| edge.as_dvec3());
        let corner = self.corner.as_dvec3();
        let position = corner + f64::from(u) * e1 + f64::from(v) * e2;
        EndPoint::new(position, corner.abs() + e1.abs() + e2.abs(), self.normal)
    }
}

/// What the eye gets from a surface by a point of the lamp that was drawn with density `1 / area`;
/// `eye` and `lamp` are the ways from the surface to either.
type Rule = dyn Fn(&Brdf, &Lamp, [Vec3; 2], bool) -> Rgb + Sync;

/// The Cornell box by the light that comes straight from its lamp. What the camera sees of the lamp
/// itself is `seen` of the way there.
fn direct(rule: &Rule, seen: &(dyn Fn(Vec3) -> f32 + Sync), film: &FilmSettings) -> Image {
    let scene = scene("cornell-box");
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let materials = Materials::new(&scene, &[]);
    let lamp = Lamp::of(&scene);
    expose(film, |point, sampler| {
        let ray = scene.camera.ray(point);
        let Some(hit) = geometry.intersect(&ray) else { return Rgb::ZERO };
        let surface = scene.surface(&ray, &hit);
        let eye = ray.origin - surface.position;
        if surface.material == lamp.material {
            return lamp.radiance * seen(eye);
        }
        let Some(brdf) = brdf(&materials, &surface) else { return Rgb::ZERO };
        let end = lamp.point(sampler.next_2d());
        let visible = !geometry.occluded(&surface.spawn_toward(&end));
        rule(&brdf, &lamp, [eye, end.position - surface.position], visible)
    })
}

fn brdf(materials: &Materials<'_>, surface: &SurfacePoint) -> Option<Brdf> {
    let Material::Matte { kd, map_kd, lobe } = materials.at(surface) else { return None };
    Some(materials.brdf(surface, kd, map_kd, lobe))
}

// ANCHOR: literal
/// Equation 4 with one bounce, read as the review explains it: I is radiance, g is 1/r², ρ is the
/// BRDF, ε the radiance of the lamp; a point of the lamp for x″. `unit` is the length that is
/// called 1.
fn literal(unit: f32, brdf: &Brdf, lamp: &Lamp, [eye, to_lamp]: [Vec3; 2]) -> Rgb {
    let g = |path: Vec3| unit * unit / path.length_squared();
    let area = lamp.area() / (unit * unit);
    let (rho, epsilon) = (brdf.lambert.eval(), lamp.radiance);
    g(eye) * rho * (g(to_lamp) * epsilon) * area
}
// ANCHOR_END: literal

// ANCHOR: area-form
/// The area form with one bounce.
fn by_area(brdf: &Brdf, lamp: &Lamp, to_lamp: Vec3, visible: bool) -> Rgb {
    let wi = to_lamp.normalize();
    if !visible || lamp.normal.dot(wi) >= 0.0 {
        return Rgb::ZERO;
    }
    let g = geometry_term(Vec3::ZERO, brdf.normal, to_lamp, lamp.normal);
    brdf.eval(wi) * lamp.radiance * (g * lamp.area())
}
// ANCHOR_END: area-form

const FILM: FilmSettings = settings([160, 160], 16);

/// Equation 4 as it is explained, in metres and in tens of metres, and the area form.
pub(super) fn literally() -> Drawing {
    let printed = |unit: f32| {
        direct(
            &move |brdf, lamp, ways, _| literal(unit, brdf, lamp, ways),
            &move |eye| unit * unit / eye.length_squared(),
            &FILM,
        )
    };
    let right = direct(&|b, lamp, [_, to_lamp], v| by_area(b, lamp, to_lamp, v), &|_| 1.0, &FILM);
    Picture::side_by_side(&[printed(1.0), printed(10.0), right].map(|i| Picture::from(&i)), 8)
        .into()
}

/// A density per area taken for one per steradian, the picture divided by 16; and converted.
pub(super) fn mixed() -> Drawing {
    let picture = |convert: bool, much: f32| {
        let rule = move |brdf: &Brdf, lamp: &Lamp, [_, to_lamp]: [Vec3; 2], visible: bool| {
            let wi = to_lamp.normalize();
            let cos_theta = -lamp.normal.dot(wi);
            if !visible || cos_theta <= 0.0 {
                return Rgb::ZERO;
            }
            let pdf_area = 1.0 / lamp.area();
            let converted = pdf_solid_angle(pdf_area, to_lamp.length_squared(), cos_theta);
            let pdf = if convert { converted } else { pdf_area };
            brdf.eval(wi) * lamp.radiance * (brdf.cos_theta(wi) / pdf) / much
        };
        Picture::from(&direct(&rule, &|_| 1.0, &FILM))
    };
    Picture::side_by_side(&[picture(false, 16.0), picture(true, 1.0)], 8).into()
}

/// One direction or one point: its value f/p, and whether it is one at all.
struct Way {
    name: &'static str,
    value: fn(&mut Sampler) -> f64,
}

fn point_of_square(sampler: &mut Sampler) -> Vec3 {
    let [x, z] = sampler.next_2d();
    Vec3::new(x, 1.0, z)
}

/// Whether a direction around +z, turned to +y, meets the square.
fn meets(wi: Vec3) -> bool {
    let (x, z) = (wi.x / wi.z, wi.y / wi.z);
    (0.0..1.0).contains(&x) && (0.0..1.0).contains(&z)
}

const WAYS: [Way; 6] = [
    Way {
        name: "uniform directions",
        value: |sampler| {
            let wi = uniform_hemisphere(sampler.next_2d());
            if meets(wi) { f64::from(wi.z / uniform_hemisphere_pdf(wi.z)) } else { 0.0 }
        },
    },
    Way {
        name: "directions of cosine density",
        value: |sampler| {
            let wi = cosine_hemisphere(sampler.next_2d());
            if meets(wi) { f64::from(wi.z / cosine_hemisphere_pdf(wi.z)) } else { 0.0 }
        },
    },
    Way {
        name: "points, with $G$ and $p_A$",
        value: |sampler| {
            let point = point_of_square(sampler);
            f64::from(geometry_term(Vec3::ZERO, Vec3::Y, point, Vec3::NEG_Y))
        },
    },
    Way {
        name: "points, with $\\cos\\theta$ and $p_\\omega$",
        value: |sampler| {
            let point = point_of_square(sampler);
            let cos = point.normalize().y;
            f64::from(cos / pdf_solid_angle(1.0, point.length_squared(), cos))
        },
    },
    Way {
        name: "wrong: points, with $\\cos\\theta$ and $p_A$",
        value: |sampler| f64::from(point_of_square(sampler).normalize().y),
    },
    Way {
        name: "wrong: points, with $G$ and $p_\\omega$",
        value: |sampler| {
            let point = point_of_square(sampler);
            let cos = point.normalize().y;
            let g = geometry_term(Vec3::ZERO, Vec3::Y, point, Vec3::NEG_Y);
            f64::from(g / pdf_solid_angle(1.0, point.length_squared(), cos))
        },
    },
];

/// The irradiance below a corner of a square lamp of side 1 at height 1, by several ways.
pub(super) fn ways() -> Drawing {
    let mut table = Table::new(&["", "mean", "standard error", "deviation of one sample / mean"]);
    for Way { name, value } in WAYS {
        let n = 1_000_000;
        let estimate = integrate(n, &mut Sampler::new(0, 0, 0), value, |_| 1.0, |v| v);
        let error = estimate.standard_error();
        table.row([
            name.to_owned(),
            format!("{:.4}", estimate.mean),
            format!("{error:.4}"),
            format!("{:.2}", error * (n as f64).sqrt() / estimate.mean),
        ]);
    }
    // Howell's catalogue of form factors, C-11: π F.
    table.row(["exact".to_owned(), format!("{:.4}", PI * 0.138_531_6), "".into(), "".into()]);
    table.into()
}

/// The lamp of the Cornell box.
pub(super) fn lamp() -> Drawing {
    let lamp = Lamp::of(&scene("cornell-box"));
    let mut numbers = Numbers::new();
    numbers.add("area", format!("{:.3}", lamp.area()));
    numbers.add("power", format!("{:.0}", PI * f64::from(lamp.area() * lamp.radiance.x)));
    numbers.into()
}
