//! A scene: where everything is, and what it is made of.

use std::path::Path;

use glam::{DVec3, Vec2, Vec3};
use workbench::{
    Error, Exposure, MaterialRecord, Probe, SceneError, SceneFile, Texture, TextureRecord,
};

use crate::attributes::Attributes;
use crate::camera::Camera;
use crate::exact_point::ExactPoint;
use crate::geometry::Geometry;
use crate::hit::Hit;
use crate::light::PointLight;
use crate::math;
use crate::ray::Ray;
use crate::rgb::Rgb;
use crate::scene_builder::SceneBuilder;
use crate::surface_point::{SurfacePoint, rounding_box};

/// Everything a scene file describes, in the form in which rays want it.
pub struct Scene {
    /// Where the rays start.
    pub camera: Camera,
    /// How far the camera's target is, in scene units.
    pub focus: f32,
    /// Size of the picture and samples a pixel, as far as the file says.
    pub exposure: Exposure,
    /// What can be hit.
    pub geometry: Geometry,
    /// What the triangles carry besides their shape.
    pub attributes: Attributes,
    /// Plain records: each chapter reads them into its own table.
    pub materials: Vec<MaterialRecord>,
    /// Pictures on surfaces, not loaded yet.
    pub textures: Vec<TextureRecord>,
    /// Point lights of the file, then the stand-ins for its lamps.
    pub lights: Vec<PointLight>,
    /// Iₐ of equation 3.
    pub ambient: Rgb,
    /// Radiance of a ray that leaves the scene.
    pub background: Rgb,
    /// What the user should know about the file, one sentence each.
    pub notices: Vec<String>,
}

impl Scene {
    /// Reads a scene file and the meshes it names.
    ///
    /// # Errors
    /// Whatever is wrong with one of the files, with its name, line and remedy.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        SceneBuilder::from_file(SceneFile::load(path)?)
    }

    /// The point lights of the file, without the stand-ins for lamps.
    pub fn point_lights(&self) -> impl Iterator<Item = &PointLight> {
        self.lights.iter().filter(|light| light.lamp.is_empty())
    }

    /// The materials that something is made of.
    pub fn used_materials(&self) -> impl Iterator<Item = &MaterialRecord> {
        let mut used = vec![false; self.materials.len()];
        self.attributes.materials.iter().for_each(|&i| used[i as usize] = true);
        self.materials.iter().zip(used).filter(|(_, used)| *used).map(|(material, _)| material)
    }

    /// Passes over the pictures that the scene names, for a stage that knows no textures.
    ///
    /// # Errors
    /// None, unless `--no-skip` wants the pictures loaded: then what is wrong with one of them.
    pub fn pass_over_textures<P: Probe>(&self, probe: &P) -> Result<(), Error> {
        self.textures
            .iter()
            .try_for_each(|record| Texture::load_if(false, record, probe).map(|_| ()))
    }

    /// Everything that all kinds of shading need to know about a hit.
    ///
    /// Position and normal are computed in double precision, once per nearest hit: the position is
    /// then wrong by its own rounding alone, and a spawned ray need move by hardly more than that.
    ///
    /// Inlined whatever its size, as is all that happens between two searches: a point that is handed
    /// over in memory is stored in parts and read as a whole, and the processor waits for that.
    #[inline(always)]
    #[must_use]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> SurfacePoint {
        let ExactPoint { position, extent, normal } = self.geometry.point(ray, hit);
        self.surface_at(position, extent, normal.as_vec3(), ray, hit)
    }

    /// The surface at a point of which everything is known that takes double precision.
    #[inline(always)]
    pub(crate) fn surface_at(
        &self,
        position: DVec3,
        extent: DVec3,
        geometric_normal: Vec3,
        ray: &Ray,
        hit: &Hit,
    ) -> SurfacePoint {
        let position = position.as_vec3();
        SurfacePoint {
            position,
            position_error: rounding_box(position, extent.as_vec3()),
            geometric_normal,
            wo: -ray.direction,
            material: self.attributes.materials[hit.primitive as usize],
            hit: *hit,
        }
    }

    /// The unit normal that shading uses, on the viewer's side of the surface.
    ///
    /// Interpolated from the vertices where the mesh has normals, else the geometric one. Which
    /// side of the surface a ray is on is never decided by it.
    #[inline]
    #[must_use]
    pub fn shading_normal(&self, surface: &SurfacePoint) -> Vec3 {
        let facing = surface.facing_normal();
        if self.attributes.normals.is_empty() {
            return facing;
        }
        let Some(&corners) = self.geometry.triangles.get(surface.hit.primitive as usize) else {
            return facing;
        };
        let normal = self.attributes.normal(corners, surface.hit.barycentric);
        match normal.try_normalize() {
            Some(normal) if normal.dot(facing) > 0.0 => normal,
            Some(normal) if normal.dot(facing) < 0.0 => -normal,
            _ => facing,
        }
    }

    /// Texture coordinates (u, v) of a hit.
    ///
    /// On a quad they run from (0, 0) at its first vertex to (1, 1) at its third, on a mesh they
    /// come from its file, on a sphere u is the longitude from +z toward +x and v the latitude from
    /// the south pole, both from 0 to 1.
    #[must_use]
    pub fn texture_coordinates(&self, surface: &SurfacePoint) -> Vec2 {
        match self.geometry.triangles.get(surface.hit.primitive as usize) {
            Some(&corners) => self.attributes.texture_coordinates(corners, surface.hit.barycentric),
            None => longitude_latitude(surface.geometric_normal),
        }
    }
}

/// Texture coordinates of the point of a sphere whose unit normal is `normal`.
fn longitude_latitude(normal: Vec3) -> Vec2 {
    use std::f32::consts::{FRAC_1_PI, TAU};
    let longitude = math::atan2(normal.x, normal.z) / TAU;
    let latitude = math::acos(-normal.y.clamp(-1.0, 1.0)) * FRAC_1_PI;
    Vec2::new(if longitude < 0.0 { longitude + 1.0 } else { longitude }, latitude)
}
