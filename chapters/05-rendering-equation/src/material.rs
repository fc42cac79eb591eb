//! What this chapter knows of a material.

use std::marker::PhantomData;

use blinn_phong::Picture;
use ray_casting::{Rgb, Scene, SurfacePoint};
use workbench::{MaterialRecord, SurfaceKind};

use crate::brdf::Brdf;
use crate::lambert::Lambert;
use crate::lobe::Lobe;
use crate::survey::{Anything, Has};

/// The kinds of surface, each with what it reflects.
#[derive(Clone, Copy, Debug)]
pub enum Material {
    /// Reflects to all sides, described by a BRDF.
    Matte {
        /// The matte part, before the picture.
        kd: Rgb,
        /// The picture that k_d is multiplied with: an index into the scene's textures.
        map_kd: Option<u32>,
        /// The highlight, if there is one.
        lobe: Option<Lobe>,
    },
    /// Reflects in one direction, on both sides.
    Mirror {
        /// k_r: the share of the light that is reflected.
        kr: Rgb,
    },
    /// The boundary of a transparent body: reflects or refracts. Its index of refraction is known to
    /// [`Boundaries`](mirror_refraction::Boundaries).
    Glass,
}

impl From<&MaterialRecord> for Material {
    fn from(record: &MaterialRecord) -> Self {
        match record.surface {
            SurfaceKind::Diffuse => {
                let ks = Rgb::from_array(record.ks);
                Self::Matte {
                    kd: Rgb::from_array(record.kd),
                    map_kd: record.map_kd,
                    lobe: (ks != Rgb::ZERO).then(|| Lobe::new(ks, record.ns)),
                }
            }
            SurfaceKind::Mirror => Self::Mirror { kr: Rgb::from_array(record.kr) },
            SurfaceKind::Glass => Self::Glass,
        }
    }
}

/// All materials of a scene, ready to be asked about points of its surfaces by code for `H`.
pub struct Materials<'a, H = Anything> {
    scene: &'a Scene,
    pictures: &'a [Picture],
    materials: Vec<Material>,
    emitted: Vec<Rgb>,
    has: PhantomData<H>,
}

impl<'a, H: Has> Materials<'a, H> {
    /// Reads the materials of `scene`, whose textures are `pictures`.
    #[must_use]
    pub fn new(scene: &'a Scene, pictures: &'a [Picture]) -> Self {
        let emitted = scene.materials.iter().map(|record| Rgb::from_array(record.ke)).collect();
        let materials = scene.materials.iter().map(Material::from).collect();
        Self { scene, pictures, materials, emitted, has: PhantomData }
    }

    /// What the surface is made of, as far as code for `H` knows it: black where the scene was said
    /// to have none of this kind.
    #[inline]
    #[must_use]
    pub fn at(&self, surface: &SurfacePoint) -> Material {
        match self.materials[surface.material as usize] {
            Material::Matte { kd, map_kd, lobe } => Material::Matte {
                kd,
                map_kd: map_kd.filter(|_| H::TEXTURES),
                lobe: lobe.filter(|_| H::HIGHLIGHTS),
            },
            mirror @ Material::Mirror { .. } if H::MIRRORS => mirror,
            Material::Glass if H::GLASS => Material::Glass,
            _ => Material::Matte { kd: Rgb::ZERO, map_kd: None, lobe: None },
        }
    }

    // ANCHOR: emitted
    /// Lₑ(ωₒ): the radiance that a surface sends out by itself, from its front only.
    #[inline]
    #[must_use]
    pub fn emitted(&self, surface: &SurfacePoint) -> Rgb {
        let emitted = self.emitted[surface.material as usize];
        if emitted == Rgb::ZERO || !surface.is_front() { Rgb::ZERO } else { emitted }
    }
    // ANCHOR_END: emitted

    /// The BRDF at a point of a matte surface.
    #[inline]
    #[must_use]
    pub fn brdf(
        &self,
        surface: &SurfacePoint,
        kd: Rgb,
        map_kd: Option<u32>,
        lobe: Option<Lobe>,
    ) -> Brdf {
        let albedo = match map_kd {
            None => kd,
            Some(picture) => {
                let coordinates = self.scene.texture_coordinates(surface);
                kd * self.pictures[picture as usize].sample(coordinates)
            }
        };
        Brdf {
            normal: self.scene.shading_normal(surface),
            facing: surface.facing_normal(),
            wo: surface.wo,
            lambert: Lambert { albedo },
            lobe,
        }
    }
}
