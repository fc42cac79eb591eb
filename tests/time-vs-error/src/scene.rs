//! What is rendered, and where its right answer comes from.

use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use generator::Terrain;

use crate::error::{Error, Result};

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
            Source::Stored => None,
            Source::Terrain(side) => Some(2 * side * side),
        }
    }

    /// The scene's file; that of a terrain is written into `folder` first.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn file(&self, folder: &Path) -> Result<PathBuf> {
        match self.source {
            Source::Stored => Ok(assets().join("scenes").join(&self.name).with_extension("toml")),
            Source::Terrain(side) => write_terrain(&self.name, side, folder),
        }
    }
}

/// The folder of scenes, meshes and references.
#[must_use]
pub fn assets() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets")
}

fn write_terrain(name: &str, side: u32, folder: &Path) -> Result<PathBuf> {
    let mesh = folder.join(format!("{name}.obj"));
    let failed = |error| Error::file(&mesh, error);
    let mut file = BufWriter::new(File::create(&mesh).map_err(failed)?);
    generator::write_obj(&mut file, &Terrain { side, seed: 0 }).map_err(failed)?;
    drop(file.into_inner().map_err(|error| Error::file(&mesh, error))?);
    let scene = folder.join(format!("{name}.toml"));
    fs::write(&scene, TERRAIN.replace("MESH", &format!("{name}.obj")))
        .map_err(|error| Error::file(&scene, error))?;
    Ok(scene)
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
