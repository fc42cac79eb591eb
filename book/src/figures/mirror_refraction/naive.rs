//! The recursion once more, with one mistake at a time.

use blinn_phong::{Picture as Texture, Shader, Terms};
use glam::Vec3;
use mirror_refraction::fresnel::{fresnel, reflect, refract};
use mirror_refraction::{Media, Surface};
use ray_casting::{Intersect, LinearSearch, Ray, Rgb, Scene, SurfacePoint};
use workbench::{FilmSettings, Image, Unwatched, expose};

/// What is forgotten, or done the wrong way round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Mistake {
    /// None: what the stage draws, where faces do not touch.
    Nothing,
    /// ηₜ/ηᵢ in the place of ηᵢ/ηₜ.
    FlippedRatio,
    /// The square root of whatever comes.
    NoTotalReflection,
    /// No ray at all where the law of refraction has none, and the rest is not reflected either.
    LostTotalReflection,
    /// Reflection and refraction are added as they are.
    NoShares,
    /// 4 % is reflected at any angle.
    ConstantShare,
    /// The medium beyond a face is that of the face's material, also on the way out.
    NeverLeaves,
    /// Every body as if it lay in the open.
    InTheOpen,
}

/// Less than the stage's depth, because no branch is cut for its small weight.
const DEPTH: u32 = 6;

/// What the light of a NaN is shown as: a red that no number of good samples can hide.
const MARK: Rgb = Rgb::new(1e6, 0.0, 0.0);

struct Tracer<'a> {
    scene: &'a Scene,
    surfaces: Vec<Surface>,
    geometry: LinearSearch<'a, Unwatched>,
    shader: Shader<'a, LinearSearch<'a, Unwatched>, Unwatched>,
    mistake: Mistake,
}

/// The picture of a scene at [`DEPTH`]; what is not a number is red.
pub(super) fn draw(scene: &Scene, mistake: Mistake, settings: &FilmSettings) -> Image {
    let textures = Texture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let tracer = Tracer {
        scene,
        surfaces: scene.materials.iter().map(Surface::from).collect(),
        geometry: LinearSearch::new(&scene.geometry, &Unwatched),
        shader: Shader::new(scene, &textures, &geometry, &Unwatched, Terms::All),
        mistake,
    };
    expose(settings, |point, _| {
        let radiance = tracer.radiance(scene.camera.ray(point), 0, Media::OUTSIDE);
        if radiance.is_finite() { radiance } else { MARK }
    })
}

impl Tracer<'_> {
    fn radiance(&self, ray: Ray, events: u32, media: Media) -> Rgb {
        if events > DEPTH {
            return Rgb::ZERO;
        }
        let Some(hit) = self.geometry.intersect(&ray) else { return self.scene.background };
        let surface = self.scene.surface(&ray, &hit);
        match self.surfaces[surface.material as usize] {
            Surface::Diffuse(_) => self.shader.incident_radiance(ray),
            Surface::Mirror { kr } => {
                let reflected = reflect(surface.wo, surface.facing_normal());
                kr * self.radiance(surface.spawn(reflected), events + 1, media)
            }
            Surface::Glass { ior, kt } => {
                let (eta, beyond) = self.cross(&surface, ior, media);
                self.glass(&surface, eta, kt, events, [media, beyond])
            }
        }
    }

    /// η, and what is beyond the face.
    fn cross(&self, surface: &SurfacePoint, ior: f32, media: Media) -> (f32, Media) {
        let mut beyond = media;
        if surface.is_front() || self.mistake == Mistake::NeverLeaves {
            beyond.enter(surface.material, ior);
        } else {
            beyond.leave(surface.material);
        }
        let eta = match self.mistake {
            Mistake::InTheOpen if surface.is_front() => 1.0 / ior,
            Mistake::InTheOpen => ior,
            Mistake::FlippedRatio => beyond.ior() / media.ior(),
            _ => media.ior() / beyond.ior(),
        };
        (eta, beyond)
    }

    /// L = F L(reflected) + (1 − F) k_t L(refracted), or what the mistake makes of it.
    fn glass(
        &self,
        surface: &SurfacePoint,
        eta: f32,
        kt: Rgb,
        events: u32,
        [media, beyond]: [Media; 2],
    ) -> Rgb {
        let normal = surface.facing_normal();
        let reflected = || {
            let ray = surface.spawn(reflect(surface.wo, normal));
            self.radiance(ray, events + 1, media)
        };
        let refracted =
            |direction: Vec3| kt * self.radiance(surface.spawn(direction), events + 1, beyond);

        match (refract(surface.wo, normal, eta), self.mistake) {
            // The root of a negative number, and all that is made of it.
            (None, Mistake::NoTotalReflection) => Rgb::splat(f32::NAN),
            (None, Mistake::LostTotalReflection) => Rgb::ZERO,
            (None, _) => reflected(),
            (Some(to), Mistake::NoShares) => reflected() + refracted(to.direction),
            (Some(to), Mistake::ConstantShare) => {
                0.04 * reflected() + 0.96 * refracted(to.direction)
            }
            // Nothing happens here; to reflect a share of 0 would only take time.
            (Some(to), _) if eta == 1.0 => refracted(to.direction),
            (Some(to), _) => {
                let cos_theta_i = normal.dot(surface.wo).clamp(0.0, 1.0);
                let f = fresnel(cos_theta_i, to.cos_theta_t, eta);
                f * reflected() + (1.0 - f) * refracted(to.direction)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::stage::{self, PANEL};
    use super::{DEPTH, Mistake, draw};
    use mirror_refraction::Limits;
    use workbench::{FilmSettings, Unwatched};

    /// So a wrong picture is wrong by its mistake alone.
    #[test]
    fn without_a_mistake_the_picture_is_the_stages() {
        let settings = FilmSettings { size: [60, 40], ..PANEL };
        for name in ["whitted", "nested-glass", "glass-slab"] {
            let scene = stage::scene(name);
            let limits = Limits::new(Some(DEPTH), 0.0);
            let expected = stage::draw(&scene, limits, &settings, &Unwatched);
            let drawn = draw(&scene, Mistake::Nothing, &settings);
            let pairs = expected.pixels.iter().zip(&drawn.pixels);
            let worst =
                pairs.flat_map(|(a, b)| [0, 1, 2].map(|i| (a[i] - b[i]).abs())).fold(0.0, f32::max);
            assert!(worst <= 1e-5, "{name}: {worst}");
        }
    }
}
