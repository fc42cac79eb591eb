//! All the lights of a scene.

use glam::Vec3;
use ray_casting::{Geometry, Ray, Rgb, Scene, SurfacePoint};
use workbench::Sampler;

use crate::choice::Choice;
use crate::discrete::Discrete;
use crate::flat_lamp::{FlatLamp, Measure};
use crate::light::{Light, LightSample};
use crate::nearby::Nearby;
use crate::sphere_lamp::SphereLamp;

/// What light comes from, and how one of it is chosen.
#[derive(Clone, Debug)]
pub struct Lights {
    lights: Vec<Light>,
    /// The choice that does not depend on who asks,
    anywhere: Discrete,
    /// and the one that does, where there is one.
    nearby: Option<Nearby>,
    /// The primitives that are lamps, in ascending order, with the number of the light that each is
    /// or is a half of.
    lamps: Vec<(u32, u32)>,
    /// Whether the last light is the sky.
    has_sky: bool,
}

impl Lights {
    /// Collects the lamps, the point lights and the sky of a scene, as far as they send out light,
    /// to be chosen and sampled as the stage does unless it is told otherwise.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::with(scene, Choice::default(), Measure::default())
    }

    /// The same lights, chosen and sampled in this way.
    #[must_use]
    pub fn with(scene: &Scene, choice: Choice, measure: Measure) -> Self {
        let geometry = &scene.geometry;
        let radius = radius(geometry);
        let lit = |light: &Light| light.power(radius) > 0.0;
        let (mut lamps, mut lights) = (Vec::new(), Vec::new());
        let mut primitive = 0;
        while primitive < geometry.primitives() {
            let (lamp, size) = lamp(scene, primitive, measure);
            if let Some(lamp) = lamp.filter(lit) {
                lamps.extend((primitive..primitive + size).map(|half| (half, lights.len() as u32)));
                lights.push(lamp);
            }
            primitive += size;
        }
        let points = scene.point_lights().map(|light| Light::Point {
            position: light.position,
            intensity: std::f32::consts::PI * light.intensity,
        });
        lights.extend(points.filter(lit));
        let sky = Light::Sky { radiance: scene.background };
        let has_sky = lit(&sky);
        lights.extend(has_sky.then_some(sky));

        let weight = |light: &Light| match choice {
            Choice::Uniform => 1.0,
            Choice::Power | Choice::Nearby => light.power(radius),
        };
        let anywhere = Discrete::new(&lights.iter().map(weight).collect::<Vec<_>>());
        let nearby = if choice == Choice::Nearby { Nearby::new(&lights) } else { None };
        Self { lights, anywhere, nearby, lamps, has_sky }
    }

    /// The lights: lamps in the order of their primitives, then point lights, then the sky.
    #[must_use]
    pub fn all(&self) -> &[Light] {
        &self.lights
    }

    /// Whether this primitive is a lamp, or a half of one.
    #[must_use]
    pub fn is_lamp(&self, primitive: u32) -> bool {
        self.lamps.binary_search_by_key(&primitive, |(lamp, _)| *lamp).is_ok()
    }

    // ANCHOR: sample
    /// Chooses a light and draws a direction toward it, with the density of both together; `None`
    /// if nothing can arrive from there, or if there is no light.
    #[inline(always)]
    pub fn sample(&self, surface: &SurfacePoint, sampler: &mut Sampler) -> Option<LightSample> {
        let (number, pmf) = match self.lights.len() {
            0 => return None,
            1 => (0, 1.0),
            _ => self.pick(surface.position, surface.facing_normal(), sampler.next_1d()),
        };
        let mut sample = self.lights[number].sample(surface, sampler.next_2d())?;
        sample.pdf_solid_angle *= pmf;
        Some(sample)
    }

    /// The density per steradian with which [`Lights::sample`] draws the direction that leads to
    /// `lamp`, on a surface at `viewer` whose normal on the viewer's side is `facing`; 0 if the lamp
    /// does not shine there.
    #[inline]
    #[must_use]
    pub fn pdf_of_lamp(&self, viewer: Vec3, facing: Vec3, lamp: &SurfacePoint) -> f32 {
        let index =
            self.lamps.binary_search_by_key(&lamp.hit.primitive, |(primitive, _)| *primitive);
        let Ok(index) = index else { return 0.0 };
        let number = self.lamps[index].1 as usize;
        let pdf = match &self.lights[number] {
            Light::Flat(flat) => flat.pdf(viewer, -lamp.wo, viewer.distance_squared(lamp.position)),
            Light::Sphere(sphere) => sphere.pdf(viewer),
            Light::Point { .. } | Light::Sky { .. } => None,
        };
        pdf.map_or(0.0, |pdf| self.pmf(viewer, facing, number) * pdf)
    }

    /// The same for a direction `wi` that leads out of the scene.
    #[inline]
    #[must_use]
    pub fn pdf_of_sky(&self, viewer: Vec3, facing: Vec3, wi: Vec3) -> f32 {
        if !self.has_sky {
            return 0.0;
        }
        let pmf = self.pmf(viewer, facing, self.lights.len() - 1);
        pmf * rendering_equation::directions::cosine_hemisphere_pdf(facing.dot(wi))
    }
    // ANCHOR_END: sample

    /// A ray from `surface` to the middle of one of the lights, even if nothing can arrive from it;
    /// `None` if there is no light. It answers nothing that a picture needs.
    pub fn ray_toward_any(&self, surface: &SurfacePoint, sampler: &mut Sampler) -> Option<Ray> {
        let number = match self.lights.len() {
            0 => return None,
            1 => 0,
            _ => self.pick(surface.position, surface.facing_normal(), sampler.next_1d()).0,
        };
        Some(self.lights[number].ray_from(surface))
    }

    /// The light that `u` picks for a surface at `viewer`, and the probability of that.
    #[inline]
    fn pick(&self, viewer: Vec3, facing: Vec3, u: f32) -> (usize, f32) {
        let nearby = self.nearby.as_ref().and_then(|nearby| nearby.pick(viewer, facing, u));
        nearby.unwrap_or_else(|| {
            let number = self.anywhere.pick(u);
            (number, self.anywhere.pmf(number))
        })
    }

    /// The probability that a surface at `viewer` chooses the light of this number.
    #[inline]
    #[must_use]
    pub fn pmf(&self, viewer: Vec3, facing: Vec3, number: usize) -> f32 {
        let nearby = self.nearby.as_ref().and_then(|nearby| nearby.pmf(viewer, facing, number));
        nearby.unwrap_or_else(|| self.anywhere.pmf(number))
    }
}

/// The lamp that begins with a primitive, if it shines, and of how many primitives it is made: a
/// parallelogram comes as two triangles, (0, 1, 2) and (0, 2, 3).
fn lamp(scene: &Scene, primitive: u32, measure: Measure) -> (Option<Light>, u32) {
    let geometry = &scene.geometry;
    let material = |primitive: u32| scene.attributes.materials[primitive as usize];
    let radiance = Rgb::from_array(scene.materials[material(primitive) as usize].ke);
    if radiance == Rgb::ZERO {
        return (None, 1);
    }
    if let Some(&sphere) = geometry.sphere(primitive) {
        return (Some(Light::Sphere(SphereLamp { sphere, radiance })), 1);
    }
    if let [[a, b, c], [d, e, f], ..] = geometry.triangles[primitive as usize..]
        && [a, c] == [d, e]
        && material(primitive) == material(primitive + 1)
    {
        let corners = [a, b, c, f].map(|vertex| geometry.vertices[vertex as usize]);
        if let Some(quad) = FlatLamp::parallelogram(corners, radiance, measure) {
            return (Some(Light::Flat(quad.of_primitive(primitive))), 2);
        }
    }
    let corners = geometry.corners(primitive);
    let triangle = FlatLamp::triangle(corners, radiance, measure);
    (Some(Light::Flat(triangle.of_primitive(primitive))), 1)
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
