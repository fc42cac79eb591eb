//! What this chapter knows of a material.

use glam::Vec2;
use ray_casting::Rgb;
use workbench::{MaterialRecord, SurfaceKind};

use crate::picture::Picture;

/// The coefficients of equations 1 and 2.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// k_d: the share of the light that is reflected to all sides, 0 to 1.
    pub kd: Rgb,
    /// The picture that k_d is multiplied with: an index into the scene's textures.
    pub map_kd: Option<u32>,
    /// k_s: how strong the highlight is.
    pub ks: Rgb,
    /// p: how sharp it is, at least 0.
    pub ns: f32,
}

impl Material {
    // ANCHOR: diffuse_reflectance
    /// k_d where the texture coordinates are what `coordinates` returns, asked only if needed.
    #[inline]
    #[must_use]
    pub fn diffuse_reflectance(
        &self,
        pictures: &[Picture],
        coordinates: impl FnOnce() -> Vec2,
    ) -> Rgb {
        match self.map_kd {
            None => self.kd,
            Some(picture) => self.kd * pictures[picture as usize].sample(coordinates()),
        }
    }
    // ANCHOR_END: diffuse_reflectance

    /// Whether no light at all is reflected, wherever it comes from.
    #[must_use]
    pub fn is_black(&self) -> bool {
        self.kd == Rgb::ZERO && self.ks == Rgb::ZERO
    }
}

impl From<&MaterialRecord> for Material {
    /// A mirror or a glass, which this chapter does not know, becomes a matte surface of its colour.
    fn from(record: &MaterialRecord) -> Self {
        let matte =
            |kd: [f32; 3]| Self { kd: Rgb::from_array(kd), map_kd: None, ks: Rgb::ZERO, ns: 0.0 };
        match record.surface {
            SurfaceKind::Diffuse => Self {
                kd: Rgb::from_array(record.kd),
                map_kd: record.map_kd,
                ks: Rgb::from_array(record.ks),
                ns: record.ns,
            },
            SurfaceKind::Mirror => matte(record.kr),
            SurfaceKind::Glass => matte(record.kt),
        }
    }
}
