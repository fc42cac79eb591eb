//! The command line.

use crate::{
    Blob, FileError, ObjSize, Surface, Terrain, TessellatedSpheres, checker, rings_for, side_for,
    sphereflake, write_obj, write_sphereflake, write_whole,
};
use clap::builder::RangedU64ValueParser;
use clap::{Args, Parser, Subcommand};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use std::io;
use std::path::{Path, PathBuf};

/// Makes meshes, scenes and textures of any size. The same options give the same bytes everywhere.
#[derive(Parser, Debug)]
#[command(name = "generator", version)]
pub struct Options {
    #[command(subcommand)]
    kind: Kind,
}

#[derive(Subcommand, Debug)]
enum Kind {
    /// A closed, bumpy ball as an OBJ file
    Blob {
        /// About how many triangles
        #[arg(long, value_name = "N", default_value = "204160", value_parser = triangles())]
        triangles: u64,
        /// Exactly how many sectors and rings instead: R gives 2R(R-1) triangles
        #[arg(long, value_name = "R", conflicts_with = "triangles", value_parser = rings())]
        rings: Option<u32>,
        #[command(flatten)]
        output: Output,
    },
    /// A fractal landscape as an OBJ file
    Terrain {
        /// About how many triangles
        #[arg(long, value_name = "N", default_value = "1000000", value_parser = triangles())]
        triangles: u64,
        /// Exactly how many squares along an edge instead: S gives 2S² triangles
        #[arg(long, value_name = "S", conflicts_with = "triangles", value_parser = side())]
        side: Option<u32>,
        /// Which landscape
        #[arg(long, default_value_t = 0)]
        seed: u32,
        #[command(flatten)]
        output: Output,
    },
    /// Haines' recursive spheres as a scene file, or as an OBJ file when --rings is given
    Sphereflake {
        /// Generations after the first sphere: D gives (9^(D+1)-1)/8 spheres
        #[arg(long, value_name = "D", default_value_t = 4, value_parser = depth())]
        depth: u32,
        /// Make every sphere of 2R(R-1) triangles
        #[arg(long, value_name = "R", value_parser = rings())]
        rings: Option<u32>,
        #[command(flatten)]
        output: Output,
    },
    /// The red and yellow checkerboard as a PNG file
    Checker {
        /// Tiles along an edge
        #[arg(long, default_value_t = 16, value_parser = tiles())]
        tiles: u32,
        /// Pixels along the edge of a tile
        #[arg(long, default_value_t = 32, value_parser = pixels())]
        pixels: u32,
        #[command(flatten)]
        output: Output,
    },
}

/// Where to write.
#[derive(Args, Debug)]
struct Output {
    /// The file to write
    #[arg(short = 'o', long = "output", value_name = "FILE")]
    path: PathBuf,
}

// The largest numbers keep vertex indices well within 32 bits, as every reader wants them.
fn triangles() -> RangedU64ValueParser<u64> {
    RangedU64ValueParser::new().range(1..=1_000_000_000)
}
fn rings() -> RangedU64ValueParser<u32> {
    RangedU64ValueParser::new().range(3..=22_361)
}
fn side() -> RangedU64ValueParser<u32> {
    RangedU64ValueParser::new().range(1..=22_361)
}
fn tiles() -> RangedU64ValueParser<u32> {
    RangedU64ValueParser::new().range(1..=256)
}
fn pixels() -> RangedU64ValueParser<u32> {
    RangedU64ValueParser::new().range(1..=64)
}
fn depth() -> RangedU64ValueParser<u32> {
    RangedU64ValueParser::new().range(0..=7)
}

/// Makes what was asked for, and returns a sentence about it.
///
/// # Errors
/// If the file cannot be written, or would hold more vertices than an index can count.
pub fn run(options: &Options) -> Result<String, FileError> {
    match &options.kind {
        Kind::Blob { triangles, rings, output } => {
            let n = rings.unwrap_or_else(|| rings_for(*triangles));
            save_obj(&output.path, &Blob { n })
        }
        Kind::Terrain { triangles, side, seed, output } => {
            let side = side.unwrap_or_else(|| side_for(*triangles));
            save_obj(&output.path, &Terrain { side, seed: *seed })
        }
        Kind::Sphereflake { depth, rings: None, output } => {
            write_whole(&output.path, |out| write_sphereflake(out, *depth))?;
            Ok(format!("{}: {} spheres", output.path.display(), (9_u64.pow(depth + 1) - 1) / 8))
        }
        Kind::Sphereflake { depth, rings: Some(rings), output } => {
            save_flake_mesh(&output.path, *depth, *rings)
        }
        Kind::Checker { tiles, pixels, output } => {
            let picture = checker(*tiles, tiles * pixels);
            write_whole(&output.path, |out| {
                let smallest = CompressionType::Best;
                let encoder = PngEncoder::new_with_quality(out, smallest, FilterType::NoFilter);
                picture.write_with_encoder(encoder).map_err(io::Error::other)
            })?;
            Ok(format!("{}: {tiles} x {tiles} tiles", output.path.display()))
        }
    }
}

fn save_flake_mesh(path: &Path, depth: u32, rings: u32) -> Result<String, FileError> {
    let spheres = sphereflake(depth);
    let vertices = spheres.len() as u64 * (u64::from(rings) * u64::from(rings - 1) + 2);
    if vertices > u64::from(i32::MAX.unsigned_abs()) {
        let sentence =
            format!("{vertices} vertices are too many: take a smaller depth or fewer rings");
        let source = io::Error::new(io::ErrorKind::InvalidInput, sentence);
        return Err(FileError { path: path.to_owned(), source });
    }
    save_obj(path, &TessellatedSpheres { spheres, rings })
}

fn save_obj(path: &Path, surface: &impl Surface) -> Result<String, FileError> {
    let mut written = ObjSize::default();
    write_whole(path, |out| {
        written = write_obj(out, surface)?;
        Ok(())
    })?;
    let ObjSize { vertices, triangles } = written;
    Ok(format!("{}: {triangles} triangles, {vertices} vertices", path.display()))
}
