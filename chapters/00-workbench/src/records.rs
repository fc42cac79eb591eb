//! The records of a scene file: plain data, in the units of the file, checked but not interpreted.
//!
//! Colours are linear RGB with Rec. 709 primaries, lengths are in scene units, angles in degrees.
//! Every number is finite; which further promises hold is said at each field.

use std::path::PathBuf;

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraRecord {
    /// Where the pinhole is, in scene units.
    pub eye: [f32; 3],
    /// A point that is seen in the middle of the picture; never equal to `eye`.
    pub target: [f32; 3],
    /// The direction that is upwards in the picture; not zero, never parallel to the view
    /// direction.
    pub up: [f32; 3],
    /// The vertical angle of view in degrees, between 0 and 180 (both exclusive).
    pub fov: f32,
    /// Width and height of the picture in pixels, both at least 1.
    pub size: [u32; 2],
}

/// The review's three kinds of surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SurfaceKind {
    /// Reflects light in all directions.
    #[default]
    Diffuse,
    /// Reflects light in one direction.
    Mirror,
    /// Reflects and refracts.
    Glass,
}

/// What a surface is made of. Colours are at least 0; what the file leaves out is black.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialRecord {
    /// The name in the scene file or in the MTL file.
    pub name: String,
    /// Which of the fields below matter.
    pub surface: SurfaceKind,
    /// Diffuse reflectance (albedo).
    pub kd: [f32; 3],
    /// Reflectance of the Blinn-Phong highlight.
    pub ks: [f32; 3],
    /// Exponent of the highlight, at least 0; 1 when left out.
    pub ns: f32,
    /// Reflectance of a mirror.
    pub kr: [f32; 3],
    /// Index of refraction of the inside, above 0; 1.5 when left out. The outside is 1.
    pub ni: f32,
    /// Tint of glass; white when left out.
    pub kt: [f32; 3],
    /// Emitted radiance, constant over the front hemisphere.
    pub ke: [f32; 3],
    /// Index of the picture that multiplies `kd` in
    /// [`SceneFile::textures`](crate::SceneFile::textures).
    pub map_kd: Option<u32>,
}

impl MaterialRecord {
    /// A black diffuse surface with everything else at its default.
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            surface: SurfaceKind::Diffuse,
            kd: [0.0; 3],
            ks: [0.0; 3],
            ns: 1.0,
            kr: [0.0; 3],
            ni: 1.5,
            kt: [1.0; 3],
            ke: [0.0; 3],
            map_kd: None,
        }
    }
}

/// A picture that a material uses. Its header has been read; its pixels have not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureRecord {
    /// The PNG file.
    pub path: PathBuf,
    /// Width and height in texels, both at least 1 and within the limit on textures.
    pub size: [u32; 2],
}

/// A light without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLightRecord {
    /// Where it is, in scene units.
    pub position: [f32; 3],
    /// I of equations 1 and 2; at least 0.
    pub intensity: [f32; 3],
}

/// A sphere; its front is the outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereRecord {
    /// Its centre, in scene units.
    pub center: [f32; 3],
    /// Its radius in scene units, above 0.
    pub radius: f32,
    /// Index into [`SceneFile::materials`](crate::SceneFile::materials).
    pub material: u32,
}

/// A planar, convex quadrilateral; its front is where its vertices run counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadRecord {
    /// The corners, in scene units. Triangles (0, 1, 2) and (0, 2, 3) both have an area.
    pub vertices: [[f32; 3]; 4],
    /// Index into [`SceneFile::materials`](crate::SceneFile::materials).
    pub material: u32,
}

/// A triangle mesh, as its file has it: `scale`, `rotate` and `translate` are not applied yet.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshRecord {
    /// The OBJ file.
    pub path: PathBuf,
    /// The vertices, in the file's units.
    pub positions: Vec<[f32; 3]>,
    /// Empty, or one a position: as long as the file has it, zero where it has none.
    pub normals: Vec<[f32; 3]>,
    /// Empty, or one a position; v grows upwards in the picture. Zero where the file has none.
    pub texture_coordinates: Vec<[f32; 2]>,
    /// Indices into `positions`; never empty, every index exists, no triangle is without area.
    pub triangles: Vec<[u32; 3]>,
    /// Indices into [`SceneFile::materials`](crate::SceneFile::materials): one a triangle, or a
    /// single one for all of them.
    pub materials: Vec<u32>,
    /// The factor that comes first, above 0.
    pub scale: f32,
    /// Then the angles around x, y and z, in that order, in degrees.
    pub rotate: [f32; 3],
    /// Then the translation, in scene units.
    pub translate: [f32; 3],
}
