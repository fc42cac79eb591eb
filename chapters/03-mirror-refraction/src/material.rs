//! What this chapter knows of a material.

use blinn_phong::Material;
use ray_casting::Rgb;
use workbench::{MaterialRecord, SurfaceKind};

/// The review's three kinds of surface.
///
/// In Whitted's own model one surface can be all three at once, each with its own coefficient
/// \[Whitted80]; the review makes them exclude each other (errata 13), and so does the scene file.
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    /// Reflects the lights, as in chapter 2. The recursion ends here.
    Diffuse(Material),
    /// Reflects in one direction, on both sides.
    Mirror {
        /// k_r: the share of the light that is reflected.
        kr: Rgb,
    },
    /// The boundary of a transparent body: reflects and refracts.
    Glass {
        /// η: index of refraction of the inside, above 0.
        ior: f32,
        /// k_t: the share of the refracted light that is let through, at each crossing.
        kt: Rgb,
    },
}

impl From<&MaterialRecord> for Surface {
    fn from(record: &MaterialRecord) -> Self {
        match record.surface {
            SurfaceKind::Diffuse => Self::Diffuse(Material::from(record)),
            SurfaceKind::Mirror => Self::Mirror { kr: Rgb::from_array(record.kr) },
            SurfaceKind::Glass => Self::Glass { ior: record.ni, kt: Rgb::from_array(record.kt) },
        }
    }
}
