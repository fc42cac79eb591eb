//! All the lights of a scene.

use glam::Vec3;
use ray_casting::{Geometry, Rgb, Scene, SurfacePoint};
use workbench::Sampler;

use crate::choice::Choice;
use crate::light::{Light, LightSample};
use crate::sphere_lamp::SphereLamp;
use crate::triangle_lamp::TriangleLamp;

/// What light comes from, and how one of it is chosen: in proportion to its power.
#[derive(Clone, Debug)]
pub struct Lights {
    lights: Vec<Light>,
    choice: Choice,
    /// The primitives that are lamps, in ascending order; their lights come first, in this order.
    lamps: Vec<u32>,
    /// Whether the last light is the sky.
    has_sky: bool,
}

impl Lights {
    /// Collects the lamps, the point lights and the sky of a scene, as far as they send out light.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let geometry = &scene.geometry;
        let radius = radius(geometry);
        let lit = |light: &Light| light.power(radius) > 0.0;
        let (mut lamps, mut lights) = (Vec::new(), Vec::new());
        for primitive in 0..geometry.primitives() {
            let material = scene.attributes.materials[primitive as usize] as usize;
            let radiance = Rgb::from_array(scene.materials[material].ke);
            if radiance == Rgb::ZERO {
                continue;
            }
            let lamp = match geometry.sphere(primitive) {
                Some(&sphere) => Light::Sphere(SphereLamp { sphere, radiance }),
                None => Light::Triangle(TriangleLamp::new(geometry.corners(primitive), radiance)),
            };
            if lit(&lamp) {
                lamps.push(primitive);
                lights.push(lamp);
            }
        }
        let points = scene.point_lights().map(|light| Light::Point {
            position: light.position,
            intensity: std::f32::consts::PI * light.intensity,
        });
        lights.extend(points.filter(lit));
        let sky = Light::Sky { radiance: scene.background };
        let has_sky = lit(&sky);
        lights.extend(has_sky.then_some(sky));

        let powers: Vec<f64> = lights.iter().map(|light| light.power(radius)).collect();
        Self { choice: Choice::new(&powers), lights, lamps, has_sky }
    }

    /// The lights: lamps in the order of their primitives, then point lights, then the sky.
    #[must_use]
    pub fn all(&self) -> &[Light] {
        &self.lights
    }

    // ANCHOR: sample
    /// Chooses a light and draws a direction toward it, with the density of both together; `None`
    /// if nothing can arrive from there, or if there is no light.
    #[inline]
    pub fn sample(&self, surface: &SurfacePoint, sampler: &mut Sampler) -> Option<LightSample> {
        let number = match self.lights.len() {
            0 => return None,
            1 => 0,
            _ => self.choice.pick(sampler.next_1d()),
        };
        let mut sample = self.lights[number].sample(surface, sampler.next_2d())?;
        sample.pdf_solid_angle *= self.choice.pmf(number);
        Some(sample)
    }

    /// The density per steradian with which [`Lights::sample`] at `viewer` draws the direction that
    /// leads to `lamp`; 0 if that does not shine there.
    #[inline]
    #[must_use]
    pub fn pdf_of_lamp(&self, viewer: Vec3, lamp: &SurfacePoint) -> f32 {
        let Ok(number) = self.lamps.binary_search(&lamp.hit.primitive) else { return 0.0 };
        let pdf = match &self.lights[number] {
            Light::Triangle(triangle) => {
                triangle.pdf(-lamp.wo, viewer.distance_squared(lamp.position))
            }
            Light::Sphere(sphere) => sphere.pdf(viewer),
            Light::Point { .. } | Light::Sky { .. } => None,
        };
        self.choice.pmf(number) * pdf.unwrap_or(0.0)
    }

    /// The same for a direction `wi` that leads out of the scene, from a surface whose normal on the
    /// viewer's side is `facing`.
    #[inline]
    #[must_use]
    pub fn pdf_of_sky(&self, facing: Vec3, wi: Vec3) -> f32 {
        if !self.has_sky {
            return 0.0;
        }
        let pmf = self.choice.pmf(self.lights.len() - 1);
        pmf * rendering_equation::directions::cosine_hemisphere_pdf(facing.dot(wi))
    }
    // ANCHOR_END: sample
}

/// The radius of a sphere around everything, in scene units; 1 if there is nothing.
fn radius(geometry: &Geometry) -> f64 {
    let spheres = geometry.spheres.iter();
    let ends = spheres.flat_map(|s| [s.center - s.radius, s.center + s.radius]);
    let points = geometry.vertices.iter().copied().chain(ends);
    let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let (min, max) = points.fold(nothing, |(min, max), p| (min.min(p), max.max(p)));
    if !min.cmple(max).all() {
        return 1.0;
    }
    // In double precision, since the square of a large scene overflows.
    let diagonal = min.as_dvec3().distance(max.as_dvec3());
    0.5 * diagonal.min(f64::from(f32::MAX))
}
