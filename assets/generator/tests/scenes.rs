//! The files of `assets/`: every scene loads, and what the generator made is what it makes.

use generator::{Blob, checker, write_obj, write_sphereflake, write_whole};
use std::fs;
use std::path::{Path, PathBuf};
use workbench::{Image, SceneFile};

fn assets() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the generator lies in assets/")
}

fn scene_files() -> Vec<PathBuf> {
    let entries = fs::read_dir(assets().join("scenes")).expect("assets/scenes exists");
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    let mut scenes: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    scenes.sort();
    scenes
}

/// `mesh` needs a file that is made, not kept: it is loaded from a copy that has one.
fn with_blob(scene: &Path, folder: &Path) -> PathBuf {
    for name in ["scenes", "meshes"] {
        fs::create_dir(folder.join(name)).expect("a folder");
    }
    write_whole(&folder.join("meshes/blob.obj"), |out| write_obj(out, &Blob { n: 320 }).map(drop))
        .expect("the blob is written");
    let copy = folder.join("scenes/mesh.toml");
    fs::copy(scene, &copy).expect("the scene is copied");
    copy
}

#[test]
fn every_scene_loads_without_a_notice() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let faults: Vec<String> = scene_files()
        .into_iter()
        .map(
            |path| if path.ends_with("mesh.toml") { with_blob(&path, folder.path()) } else { path },
        )
        .filter_map(|path| fault(&path))
        .collect();
    assert!(faults.is_empty(), "{} scenes are at fault:\n{}", faults.len(), faults.join("\n"));
}

/// What is wrong with a scene.
fn fault(path: &Path) -> Option<String> {
    let scene = match SceneFile::load(path) {
        Ok(scene) => scene,
        Err(error) => return Some(error.to_string()),
    };
    let shapes = scene.spheres.len() + scene.quads.len() + scene.meshes.len();
    if shapes > 0 && scene.notices.is_empty() {
        return None;
    }
    Some(format!("{}: {shapes} shapes, notices {:?}", path.display(), scene.notices))
}

/// A figure without a legend teaches nothing.
#[test]
fn every_scene_begins_with_what_it_shows() {
    for path in scene_files() {
        let text = fs::read_to_string(&path).expect("the scene is readable");
        assert!(text.starts_with("# "), "{} does not begin with a comment", path.display());
    }
}

#[test]
fn the_sphereflake_is_what_the_generator_makes() {
    let mut made = Vec::new();
    write_sphereflake(&mut made, 3).expect("a Vec takes everything");
    let kept = fs::read(assets().join("scenes/sphereflake.toml")).expect("the scene is readable");
    assert!(
        made == kept,
        "make it again: cargo run -p generator -- sphereflake --depth 3 -o assets/scenes/sphereflake.toml"
    );
}

#[test]
fn the_checkerboard_is_what_the_generator_makes() {
    let kept = Image::load_png(&assets().join("textures/checker.png")).expect("a PNG");
    assert!(
        kept.to_srgb8() == checker(16, 512).into_raw(),
        "make it again: cargo run -p generator -- checker -o assets/textures/checker.png"
    );
}

/// What a clone has to download.
#[test]
fn the_assets_stay_small() {
    let folders = ["scenes", "meshes", "textures"].map(|name| assets().join(name));
    let files = folders.iter().flat_map(|folder| fs::read_dir(folder).expect("a folder"));
    let kept = files.map(|file| file.expect("a readable folder"));
    let kept = kept.filter(|file| file.file_name() != "blob.obj");
    let bytes: u64 = kept.map(|file| file.metadata().expect("a file").len()).sum();
    assert!(bytes < 1_500_000, "scenes, meshes and textures take {bytes} bytes");
}
