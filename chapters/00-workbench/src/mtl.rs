//! Materials of an OBJ file, from the MTL file beside it.
//!
//! `tobj` reads the values; the lines are checked before, because it panics on a colour of fewer
//! than three numbers and does not say which line is wrong.

use std::fmt::Write as _;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use crate::text_lines::{TextLines, finite, keyword};
use crate::{MaterialRecord, SceneError, SurfaceKind, texture::Textures};

/// Reads the materials of an MTL file. Keys that the scene file has no counterpart for are ignored.
pub(crate) fn load(
    path: &Path,
    textures: &mut Textures,
    notices: &mut Vec<String>,
) -> Result<Vec<MaterialRecord>, SceneError> {
    let file = File::open(path).map_err(|error| SceneError::read(path, error))?;
    let mut lines = TextLines::new(path, BufReader::new(file));
    let (mut tidy, mut line, mut named) = (String::new(), String::new(), false);
    while lines.read(&mut line)? {
        let (keyword, rest) = keyword(&line);
        named |= keyword == "newmtl";
        if named {
            tidy_up(&mut tidy, path, keyword, rest, textures)
                .map_err(|reason| lines.error(format!("`{keyword}` {reason}")))?;
        }
    }
    let (materials, _) = tobj::load_mtl_buf(&mut tidy.as_bytes())
        .map_err(|error| SceneError::file(path, format!("could not be read: {error}")))?;
    Ok(materials.iter().map(|material| record(material, path, notices)).collect())
}

/// Appends a checked line to `tidy`, if it says something that we know.
fn tidy_up(
    tidy: &mut String,
    path: &Path,
    keyword: &str,
    rest: &str,
    textures: &mut Textures,
) -> Result<(), String> {
    // Names may contain a #.
    let numbers = rest.split('#').next().unwrap_or_default().trim();
    // Writing to a string cannot fail.
    let _ = match keyword {
        "newmtl" if rest.trim().is_empty() => return Err("needs a name".to_owned()),
        "newmtl" => writeln!(tidy, "newmtl {}", rest.trim()),
        "Kd" | "Ks" | "Ke" | "Tf" => {
            let [r, g, b] = color(numbers)?;
            writeln!(tidy, "{keyword} {r} {g} {b}")
        }
        "Ns" => writeln!(tidy, "Ns {}", number(numbers, |n| n >= 0.0, "at least 0")?),
        "Ni" => writeln!(tidy, "Ni {}", number(numbers, |n| n > 0.0, "above 0")?),
        "illum" => {
            let rule = "a whole number from 0 to 10";
            let right = |n: f32| (0.0..=10.0).contains(&n) && n.fract() == 0.0;
            writeln!(tidy, "illum {}", number(numbers, right, rule)?)
        }
        "map_Kd" => {
            if rest.starts_with('-') {
                return Err("has options, which are not supported; write only the file".to_owned());
            }
            let texture = path.with_file_name(rest.trim().replace('\\', "/"));
            // Only a number goes through `tobj`, so that the error can name this line.
            writeln!(tidy, "map_Kd {}", textures.index_of(&texture)?)
        }
        _ => Ok(()),
    };
    Ok(())
}

/// One number that stands for grey, or three; at least 0.
fn color(numbers: &str) -> Result<[f32; 3], String> {
    let values: Vec<f32> = numbers.split_whitespace().map(finite).collect::<Result<_, _>>()?;
    let color = match values[..] {
        [grey] => [grey; 3],
        [r, g, b] => [r, g, b],
        _ => return Err(format!("has {} numbers; it must have three", values.len())),
    };
    match color.iter().find(|&&value| value < 0.0) {
        Some(negative) => Err(format!("has the value {negative}; it must be at least 0")),
        None => Ok(color),
    }
}

fn number(text: &str, right: impl Fn(f32) -> bool, rule: &str) -> Result<f32, String> {
    let number = finite(text)?;
    if right(number) { Ok(number) } else { Err(format!("is {number}; it must be {rule}")) }
}

/// The record of a material: `illum` 3 and 5 is a mirror, whose `Ks` is kr; 4, 6, 7 and 9 is glass,
/// whose `Tf` is kt; everything else is diffuse.
fn record(material: &tobj::Material, path: &Path, notices: &mut Vec<String>) -> MaterialRecord {
    let default = MaterialRecord::new(&material.name);
    let surface = match material.illumination_model {
        Some(3 | 5) => SurfaceKind::Mirror,
        Some(4 | 6 | 7 | 9) => SurfaceKind::Glass,
        Some(model @ (8 | 10)) => {
            let (path, name) = (path.display(), &material.name);
            notices.push(format!("`{path}`: `{name}` has `illum {model}` and is shown as diffuse"));
            SurfaceKind::Diffuse
        }
        _ => SurfaceKind::Diffuse,
    };
    let specular = material.specular.unwrap_or_default();
    let is_mirror = surface == SurfaceKind::Mirror;
    MaterialRecord {
        surface,
        kd: material.diffuse.unwrap_or(default.kd),
        ks: if is_mirror { default.ks } else { specular },
        ns: material.shininess.unwrap_or(default.ns),
        kr: if is_mirror { specular } else { default.kr },
        ni: material.optical_density.unwrap_or(default.ni),
        kt: material
            .unknown_param
            .get("Tf")
            .and_then(|text| color(text).ok())
            .unwrap_or(default.kt),
        ke: material.emissive.unwrap_or(default.ke),
        map_kd: material.diffuse_texture.as_ref().and_then(|index| index.parse().ok()),
        ..default
    }
}
