//! From the name of a scene to its file.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{SceneError, suggestion};

/// The scene file that `name` means: a file, or the bare name of one in `assets/scenes/`.
///
/// That folder is looked for in the working folder and the folders around it, then in the
/// workspace that this program was compiled in.
pub(crate) fn resolve(name: &Path) -> Result<PathBuf, SceneError> {
    if name.exists() && !name.is_dir() {
        return Ok(name.to_owned());
    }
    let folders = scene_folders();
    if let Some(bare) = bare_name(name) {
        let found = folders.iter().map(|folder| folder.join(format!("{bare}.toml")));
        if let Some(path) = found.into_iter().find(|path| path.is_file()) {
            return Ok(path);
        }
    }
    let reason = if name.is_dir() {
        "this is a folder; name a scene file in it".to_owned()
    } else {
        let known: Vec<String> = folders.iter().flat_map(|folder| scenes_in(folder)).collect();
        let wanted = name.file_stem().unwrap_or_default().to_string_lossy();
        let remark = suggestion::remark(&wanted, known.iter().map(String::as_str));
        format!("there is no such file, nor a scene of that name in assets/scenes/; {remark}")
    };
    Err(SceneError::file(name, reason))
}

/// The folders of scenes, nearest first.
fn scene_folders() -> Vec<PathBuf> {
    let working = env::current_dir().unwrap_or_default();
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    let around = working.ancestors().chain(workspace).map(|folder| folder.join("assets/scenes"));
    let mut folders: Vec<PathBuf> = around.filter(|folder| folder.is_dir()).collect();
    folders.dedup();
    folders
}

/// The name, if it is nothing but a name.
fn bare_name(name: &Path) -> Option<&str> {
    let text = name.to_str()?;
    let bare = name.components().count() == 1 && name.file_name().is_some();
    bare.then(|| text.strip_suffix(".toml").unwrap_or(text))
}

/// The bare names of the scenes in a folder, sorted.
fn scenes_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|entry| entry.path());
    let scenes = paths.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let mut names: Vec<String> =
        scenes.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::{bare_name, resolve};

    #[test]
    fn an_existing_file_is_taken_as_it_is() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("any.name");
        fs::write(&path, "").expect("the file is written");
        assert_eq!(resolve(&path).expect("the file is found"), path, "the path");
    }

    #[test]
    fn a_folder_and_a_missing_file_are_errors_that_say_so() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let message = resolve(folder.path()).expect_err("a folder is no scene").to_string();
        assert!(message.contains("is a folder"), "{message}");
        let message = resolve(Path::new("no/such.toml")).expect_err("it is missing").to_string();
        assert!(message.contains("no such file"), "{message}");
    }

    #[test]
    fn only_a_lone_name_is_a_bare_name() {
        assert_eq!(bare_name(Path::new("teapot")), Some("teapot"), "a name");
        assert_eq!(bare_name(Path::new("teapot.toml")), Some("teapot"), "with its extension");
        for path in ["a/teapot", "../teapot", "..", "/", ""] {
            assert_eq!(bare_name(Path::new(path)), None, "`{path}`");
        }
    }
}
