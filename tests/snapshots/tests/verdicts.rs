//! When `assert_picture!` passes and when it fails.
//!
//! insta reads `INSTA_UPDATE` and `CI` once in a process, and a failing assertion ends a test, so
//! each verdict is that of a process of its own: this very program, told to run [`child`] alone.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use tempfile::TempDir;
use workbench::Image;

/// A small picture; `variant` says what is wrong with it.
fn picture(variant: &str) -> Image {
    let mut image = Image::new(if variant == "wider" { 9 } else { 8 }, 6);
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        *pixel = [i as f32 / 48.0, 0.25, 1.0 - i as f32 / 48.0];
    }
    match variant {
        "pixel" => image.pixels[20][1] = 0.5,
        "last bit" => image.pixels[20][1] = 0.25_f32.next_up(),
        "nan" => image.pixels[20][1] = f32::NAN,
        "infinite" => image.pixels[0][2] = f32::INFINITY,
        _ => {}
    }
    image
}

/// What the tests below run in an environment of their own; without that, it has nothing to do.
#[test]
fn child() {
    let Ok(folder) = std::env::var("PICTURE_FOLDER") else {
        return;
    };
    let variant = std::env::var("PICTURE_VARIANT").expect("the variant is given by the parent");
    picture_snapshots::assert_picture_in(folder.as_ref(), "gradient", &picture(&variant));
}

const ACCEPT: (&str, &str) = ("INSTA_UPDATE", "always");
const CHECK: (&str, &str) = ("INSTA_UPDATE", "no");

/// A crate in a temporary folder. Its name tells the pictures under `target/` apart.
struct Crate {
    _temporary: TempDir,
    path: PathBuf,
}

impl Crate {
    fn new(name: &str) -> Self {
        let temporary = tempfile::tempdir().expect("a temporary folder");
        let path = temporary.path().join(name);
        fs::create_dir(&path).expect("a folder of the crate");
        Self { _temporary: temporary, path }
    }

    /// A crate whose picture has been accepted.
    fn accepted(name: &str) -> Self {
        let made = Self::new(name);
        let (passes, text) = made.verdict("right", ACCEPT);
        assert!(passes, "accepting failed:\n{text}");
        made
    }

    /// Whether the assertion passes for a picture in an environment, and what it prints.
    fn verdict(&self, variant: &str, environment: (&str, &str)) -> (bool, String) {
        let program = std::env::current_exe().expect("a test knows its program");
        let output = Command::new(program)
            .args(["child", "--exact", "--nocapture"])
            .env_remove("CI")
            .env_remove("INSTA_UPDATE")
            .env_remove("INSTA_FORCE_PASS")
            .env("PICTURE_FOLDER", &self.path)
            .env("PICTURE_VARIANT", variant)
            .env(environment.0, environment.1)
            .output()
            .expect("the test program starts");
        let text = [output.stdout, output.stderr].concat();
        (output.status.success(), String::from_utf8_lossy(&text).into_owned())
    }
}

#[test]
fn an_accepted_picture_passes_and_lies_in_the_crate_as_text_and_png() {
    let package = Crate::accepted("passes");
    let (passes, text) = package.verdict("right", CHECK);
    assert!(passes, "the same picture failed:\n{text}");
    let stored = package.path.join("tests/snapshots");
    let snapshot = fs::read_to_string(stored.join("gradient.snap")).expect("the text is stored");
    assert!(snapshot.contains("size     8 x 6"), "stored text:\n{snapshot}");
    let png = Image::load_png(&stored.join("gradient.png")).expect("the PNG is stored");
    assert_eq!(png.to_srgb8(), picture("right").to_srgb8(), "pixels of the stored PNG");
}

#[test]
fn a_missing_snapshot_fails_and_writes_nothing_under_ci() {
    for environment in [CHECK, ("CI", "true")] {
        let package = Crate::new("missing");
        let (passes, text) = package.verdict("right", environment);
        assert!(!passes, "{environment:?} passed:\n{text}");
        assert!(text.contains("INSTA_UPDATE=always"), "no word on how to accept it:\n{text}");
        let left = fs::read_dir(&package.path).expect("the folder exists").count();
        assert_eq!(left, 0, "{environment:?} left files in the crate");
    }
}

#[test]
fn a_changed_pixel_fails_with_numbers_and_a_picture_of_the_difference() {
    let package = Crate::accepted("changed-pixel");
    let (passes, text) = package.verdict("pixel", CHECK);
    assert!(!passes, "a changed pixel passed:\n{text}");
    assert!(text.contains("1 of 48 pixels differ, by up to 51 of 255 at (4, 2)"), "{text}");
    let path = text.split("difference: `").nth(1).and_then(|rest| rest.split('`').next());
    let path = path.unwrap_or_else(|| panic!("no path is printed:\n{text}"));
    let shown = Image::load_png(path.as_ref()).expect("the difference is a PNG");
    assert_eq!([shown.width, shown.height], [24, 6], "size of the three pictures");
}

#[test]
fn a_changed_pixel_fails_without_any_environment_too() {
    let package = Crate::accepted("no-environment");
    let (passes, text) = package.verdict("pixel", ("PICTURE_NOTHING", ""));
    assert!(!passes, "a changed pixel passed:\n{text}");
    let png = Image::load_png(&package.path.join("tests/snapshots/gradient.png"));
    let png = png.expect("the PNG is still there").to_srgb8();
    assert_eq!(png, picture("right").to_srgb8(), "the stored PNG was changed");
}

#[test]
fn a_changed_bit_that_no_png_can_show_fails_by_its_hash() {
    let package = Crate::accepted("last-bit");
    let (passes, text) = package.verdict("last bit", CHECK);
    assert!(!passes, "a changed bit passed:\n{text}");
    assert!(!text.contains("pixels differ"), "the PNG should be equal:\n{text}");
}

#[test]
fn another_size_fails() {
    let package = Crate::accepted("another-size");
    let (passes, text) = package.verdict("wider", CHECK);
    assert!(!passes, "a wider picture passed:\n{text}");
    assert!(text.contains("8 x 6 pixels were expected, 9 x 6 were got"), "{text}");
}

#[test]
fn a_value_that_is_not_finite_can_never_be_accepted() {
    let package = Crate::accepted("not-finite");
    for variant in ["nan", "infinite"] {
        for environment in [ACCEPT, CHECK] {
            let (passes, text) = package.verdict(variant, environment);
            assert!(!passes, "{variant} passed under {environment:?}:\n{text}");
            assert!(text.contains("not finite"), "{text}");
        }
    }
}

#[test]
fn a_changed_picture_replaces_the_old_one_when_it_is_accepted() {
    let package = Crate::accepted("replaced");
    let (passes, text) = package.verdict("pixel", ACCEPT);
    assert!(passes, "accepting failed:\n{text}");
    let (passes, text) = package.verdict("pixel", CHECK);
    assert!(passes, "the accepted picture failed:\n{text}");
    let (passes, text) = package.verdict("right", CHECK);
    assert!(!passes, "the old picture passed:\n{text}");
}
