//! Stage 00, the workbench: everything a renderer needs before the first ray.
//!
//! It reads the command line ([`Options`]) and the scene file ([`SceneFile`]), calls a chapter's
//! closure for every point of the film on all cores ([`Run::render`]), and writes the picture and
//! the statistics ([`Run::save`]). It does not know what a ray is, and the only formula in it is
//! the one that turns linear light into the bytes of a PNG file ([`srgb`]).

mod atomic_file;
mod corners;
mod error;
mod estimate;
mod exposure;
mod film;
mod film_point;
mod goal;
mod image;
mod interrupt;
mod mesh;
mod mtl;
mod need;
mod no_skip;
mod obj_lines;
mod options;
mod pace;
mod picture_file;
mod pixel_sum;
mod portion;
mod preview;
mod probe;
mod progress;
mod records;
mod run;
mod sampler;
mod scene_error;
mod scene_file;
mod scene_path;
mod spread;
pub mod srgb;
mod statistics;
mod suggestion;
mod summary;
mod text_lines;
mod texture;
mod tile;
mod toml_table;

pub use error::Error;
pub use estimate::Estimate;
pub use exposure::{Exposure, FilmSettings, expose, expose_estimate, expose_until};
pub use film::Film;
pub use film_point::FilmPoint;
pub use image::Image;
pub use no_skip::NoSkip;
pub use options::{NoExtra, Options, Stage, StatsTarget};
pub use probe::{Counter, Probe, Recorder, Unwatched};
pub use records::{
    CameraRecord, MaterialRecord, MeshRecord, PointLightRecord, QuadRecord, SphereRecord,
    SurfaceKind, TextureRecord,
};
pub use run::{Finished, Run, main};
pub use sampler::Sampler;
pub use scene_error::SceneError;
pub use scene_file::SceneFile;
pub use texture::Texture;
