//! The stored PNG: found, compared, and replaced when that is asked for.

use crate::difference::{Difference, side_by_side};
use std::fs;
use std::path::{Path, PathBuf};
use workbench::Image;

/// Where the snapshots of a crate lie.
pub(crate) fn folder(crate_folder: &Path) -> PathBuf {
    crate_folder.join("tests").join("snapshots")
}

/// Compares a picture with the stored one as a PNG shows it, in 8-bit sRGB, pixel by pixel.
///
/// `INSTA_UPDATE=always` stores what differs instead, `unseen` what is missing: the same words as
/// for the text beside it.
///
/// # Errors
/// A sentence that says how much differs, and which file shows it.
pub(crate) fn compare(crate_folder: &Path, name: &str, image: &Image) -> Result<(), String> {
    let path = folder(crate_folder).join(format!("{name}.png"));
    let update = std::env::var("INSTA_UPDATE").unwrap_or_default();
    let always = matches!(update.as_str(), "always" | "force" | "1");

    if !path.exists() {
        if always || update == "unseen" {
            return store(&path, image);
        }
        let shown = show(crate_folder, name, image);
        let path = path.display();
        return Err(format!("`{path}` is missing; the new picture is {shown}. {HOW_TO_ACCEPT}"));
    }
    let stored = Image::load_png(&path).map_err(|error| error.to_string())?;
    let Some(difference) = Difference::between(&stored, image) else {
        return Ok(());
    };
    if always {
        return store(&path, image);
    }
    let shown = show(crate_folder, name, &side_by_side(&stored, image));
    Err(format!(
        "`{}` shows another picture: {difference}.\nExpected | got | difference: {shown}\n\
         {HOW_TO_ACCEPT}",
        path.display()
    ))
}

const HOW_TO_ACCEPT: &str = "Accept the new picture with `INSTA_UPDATE=always cargo test`.";

fn store(path: &Path, image: &Image) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|error| format!("`{}`: {error}", folder.display()))?;
    }
    image.save(path).map_err(|error| error.to_string())
}

/// Writes a picture under the target folder, and returns its path, or why there is none.
fn show(crate_folder: &Path, name: &str, image: &Image) -> String {
    let crate_name = crate_folder.file_name().unwrap_or_default().to_string_lossy();
    let path = target_folder().join("picture-snapshots").join(format!("{crate_name}-{name}.png"));
    match store(&path, image) {
        Ok(()) => format!("`{}`", path.display()),
        Err(sentence) => format!("not there ({sentence})"),
    }
}

/// The target folder: Cargo puts tests into its `debug/deps` or `release/deps`.
fn target_folder() -> PathBuf {
    let test = std::env::current_exe().unwrap_or_default();
    let deps = test.ancestors().find(|folder| folder.ends_with("deps"));
    let target = deps.and_then(|deps| deps.ancestors().nth(2));
    target.map_or_else(std::env::temp_dir, Path::to_owned)
}
