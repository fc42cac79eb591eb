//! Pictures on surfaces.

use glam::Vec2;
use ray_casting::{Rgb, Scene};
use workbench::{Error, Probe, SurfaceKind, Texture};

/// A picture that repeats in both directions.
pub struct Picture(Texture);

impl Picture {
    /// Loads all textures that the scene names.
    ///
    /// # Errors
    /// A file that cannot be read or decoded.
    pub fn load_all(scene: &Scene) -> Result<Vec<Self>, Error> {
        scene.textures.iter().map(|record| Ok(Self(Texture::load(record)?))).collect()
    }

    /// Loads those textures that a surface of the scene wears; the others are left without texels,
    /// and `probe` counts them.
    ///
    /// # Errors
    /// A file that cannot be read or decoded.
    pub fn load_worn<P: Probe>(scene: &Scene, probe: &P) -> Result<Vec<Self>, Error> {
        let matte = scene.used_materials().filter(|m| m.surface == SurfaceKind::Diffuse);
        let worn: Vec<u32> = matte.filter_map(|material| material.map_kd).collect();
        let load = |(index, record)| {
            let is_worn = worn.contains(&index);
            Ok(Self(Texture::load_if(is_worn, record, probe)?))
        };
        (0..).zip(&scene.textures).map(load).collect()
    }

    // ANCHOR: sample
    /// The linear colour at (u, v): u runs to the right, v upwards, and 1 is the picture's whole
    /// size.
    ///
    /// Bilinear: texel centres lie at half-integers, and the four around the point are mixed in
    /// proportion to how near they are. Mixing happens in linear light; the sRGB codes of the file
    /// are decoded first.
    #[must_use]
    pub fn sample(&self, coordinates: Vec2) -> Rgb {
        let size = Vec2::new(self.0.width as f32, self.0.height as f32);
        let wrapped = coordinates - coordinates.floor();
        let place = Vec2::new(wrapped.x, 1.0 - wrapped.y) * size - 0.5;
        let (corner, weight) = (place.floor(), place - place.floor());

        let texel = |dx: i32, dy: i32| {
            let x = (corner.x as i32 + dx).rem_euclid(self.0.width as i32);
            let y = (corner.y as i32 + dy).rem_euclid(self.0.height as i32);
            Rgb::from_array(self.0.texel(x as u32, y as u32))
        };
        let above = texel(0, 0).lerp(texel(1, 0), weight.x);
        let below = texel(0, 1).lerp(texel(1, 1), weight.x);
        above.lerp(below, weight.y)
    }
    // ANCHOR_END: sample
}
