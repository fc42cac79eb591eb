//! What is rendered, and where its right answer comes from.

use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use generator::{Blob, Surface, Terrain};

use crate::error::{Error, Result};
use crate::folder;

/// A scene at a size, with its right answer.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name in `assets/scenes`, or `terrain-N`.
    pub name: String,
    /// Width and height of the picture.
    pub size: [u32; 2],
    /// What the error is the distance to.
    pub answer: Answer,
    source: Source,
}

#[derive(Clone, Copy, Debug)]
enum Source {
    Stored,
    /// A terrain with so many squares along its edge.
    Terrain(u32),
    /// The ball of the scene `mesh`, too large to be kept in the workspace.
    Ball,
}

/// Where the right answer comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// Nobody asks: only times are compared.
    None,
    /// The white furnace, whose picture is known in closed form.
    Furnace,
    /// A picture in `assets/reference`.
    Reference(&'static str),
    /// The course's own picture with so many samples, light sampling, and this depth.
    Own {
        /// Most scattering events on a path.
        depth: u32,
        /// Samples a pixel.
        samples: u32,
    },
}

impl Scene {
    /// A scene of `assets/scenes`.
    #[must_use]
    pub fn stored(name: &str, size: [u32; 2], answer: Answer) -> Self {
        Self { name: name.to_owned(), size, answer, source: Source::Stored }
    }

    /// The scene `mesh`: a bumpy ball of 204 160 triangles.
    #[must_use]
    pub fn mesh(size: [u32; 2]) -> Self {
        let answer = Answer::Reference("mesh");
        Self { name: "mesh".to_owned(), size, answer, source: Source::Ball }
    }

    /// A landscape of 2 · `side`² triangles under one light, of which only times are wanted.
    #[must_use]
    pub fn terrain(side: u32, size: [u32; 2]) -> Self {
        let name = format!("terrain-{}", 2 * side * side);
        Self { name, size, answer: Answer::None, source: Source::Terrain(side) }
    }

    /// The triangles of a terrain.
    #[must_use]
    pub fn triangles(&self) -> Option<u32> {
        match self.source {
            Source::Stored | Source::Ball => None,
            Source::Terrain(side) => Some(2 * side * side),
        }
    }

    /// The scene's file; if its mesh is not kept, both are written into `folder` first.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn file(&self, folder: &Path) -> Result<PathBuf> {
        match self.source {
            Source::Stored => Ok(stored(&self.name)),
            Source::Terrain(side) => write_terrain(&self.name, side, folder),
            Source::Ball => write_ball(folder),
        }
    }
}

/// The folder of scenes, meshes and references.
#[must_use]
pub fn assets() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets")
}

/// The file of a scene that the workspace keeps.
#[must_use]
pub fn stored(name: &str) -> PathBuf {
    assets().join("scenes").join(name).with_extension("toml")
}

fn write_terrain(name: &str, side: u32, folder: &Path) -> Result<PathBuf> {
    let mesh = format!("{name}.obj");
    write_mesh(&folder.join(&mesh), &Terrain { side, seed: 0 })?;
    let scene = folder.join(format!("{name}.toml"));
    folder::write(&scene, TERRAIN.replace("MESH", &mesh))?;
    Ok(scene)
}

fn write_ball(folder: &Path) -> Result<PathBuf> {
    write_mesh(&folder.join("blob.obj"), &Blob { n: 320 })?;
    let file = stored("mesh");
    let text = fs::read_to_string(&file).map_err(|error| Error::file(&file, error))?;
    let scene = folder.join("mesh.toml");
    folder::write(&scene, text.replace("../meshes/blob.obj", "blob.obj"))?;
    Ok(scene)
}

fn write_mesh(path: &Path, surface: &impl Surface) -> Result<()> {
    let failed = |error| Error::file(path, error);
    let mut file = BufWriter::new(File::create(path).map_err(failed)?);
    generator::write_obj(&mut file, surface).map_err(failed)?;
    file.into_inner().map(drop).map_err(|error| Error::file(path, error))
}

/// The landscape fills the picture from edge to edge, whatever its number of triangles.
const TERRAIN: &str = "\
background = [0.2, 0.4, 0.8]

[camera]
eye    = [0, 60, 45]
target = [0, 0, 0]
fov    = 40
size   = [64, 64]

[materials.rock]
kd = [0.5, 0.45, 0.4]

[[point_light]]
position  = [-60, 90, 40]
intensity = [13000, 13000, 13000]

[[mesh]]
file = \"MESH\"
material = \"rock\"
";
