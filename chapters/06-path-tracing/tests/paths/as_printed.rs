//! The review's two listings, as they are printed.
//!
//! Kept to show what they draw. Names are those of the listings; `depth` counts from 0 at the eye,
//! and a light source is whatever shines.

use ray_casting::{Intersect, Ray, Rgb, Scene, SurfacePoint};
use rendering_equation::{Density, Material, Materials};
use workbench::Sampler;

/// What `shade` of the listings needs to know.
pub(crate) struct AsPrinted<'a, G> {
    pub(crate) scene: &'a Scene,
    pub(crate) materials: Materials<'a>,
    pub(crate) geometry: &'a G,
    /// The `pdf` of the directions.
    pub(crate) density: Density,
    /// D.
    pub(crate) most: u32,
}

impl<'a, G: Intersect> AsPrinted<'a, G> {
    pub(crate) fn new(scene: &'a Scene, geometry: &'a G, density: Density, most: u32) -> Self {
        Self { scene, materials: Materials::new(scene, &[]), geometry, density, most }
    }

    // ANCHOR: first
    /// The first listing, with N directions from every hit.
    pub(crate) fn first(&self, r: Ray, depth: u32, n: u32, sampler: &mut Sampler) -> Rgb {
        let mut total = Rgb::ZERO; // black
        if depth <= self.most {
            let Some(x_prime) = self.hit(&r) else { return Rgb::ZERO };
            let epsilon = self.materials.emitted(&x_prime);
            if epsilon != Rgb::ZERO {
                total += epsilon;
                return total;
            }
            for _ in 0..n {
                let Some((dir_r, pdf)) = self.direction(&x_prime, sampler) else { continue };
                let next = x_prime.spawn(dir_r);
                total += self.first(next, depth + 1, n, sampler) / (n as f32 * pdf);
            }
        }
        total
    }
    // ANCHOR_END: first

    // ANCHOR: second
    /// The second listing, with one.
    pub(crate) fn second(&self, r: Ray, depth: u32, sampler: &mut Sampler) -> Rgb {
        let mut total = Rgb::ZERO; // black
        if depth <= self.most {
            let Some(x_prime) = self.hit(&r) else { return Rgb::ZERO };
            let epsilon = self.materials.emitted(&x_prime);
            if epsilon != Rgb::ZERO {
                total += epsilon;
                return total;
            }
            if let Some((dir_r, _)) = self.direction(&x_prime, sampler) {
                total += self.second(x_prime.spawn(dir_r), depth + 1, sampler);
            }
        }
        total
    }
    // ANCHOR_END: second

    fn hit(&self, r: &Ray) -> Option<SurfacePoint> {
        self.geometry.intersect(r).map(|hit| self.scene.surface(r, &hit))
    }

    /// A direction above the surface, and its density per steradian. The listings know no mirrors.
    fn direction(&self, at: &SurfacePoint, sampler: &mut Sampler) -> Option<(glam::Vec3, f32)> {
        let Material::Matte { kd, map_kd, lobe } = self.materials.at(at) else { return None };
        let brdf = self.materials.brdf(at, kd, map_kd, lobe);
        brdf.sample(self.density, sampler).map(|drawn| (drawn.wi, drawn.pdf_solid_angle))
    }
}
