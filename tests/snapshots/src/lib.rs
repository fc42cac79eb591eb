//! Snapshots of pictures.
//!
//! A snapshot is two files in the `tests/snapshots/` of the crate whose test it is:
//!
//! - `NAME.snap`, a text: size, mean, minimum, maximum, and the hash of all floats. It notices a
//!   change in any bit, and a review of it shows what changed. insta keeps it.
//! - `NAME.png`, the picture that a person can open. It is compared pixel by pixel after decoding:
//!   an update of the encoder changes the bytes of a PNG, but not what it shows. We keep it
//!   ourselves: insta's binary snapshots compare bytes unless its internals are told otherwise.
//!
//! Both are accepted with `INSTA_UPDATE=always cargo test`. When the picture differs, the expected
//! one, the new one and their difference are put side by side in a PNG under `target/`, whose path
//! is printed.

mod difference;
mod stored;
mod summary;

use std::path::Path;
use stored::compare;
use summary::summary;
use workbench::Image;

/// Asserts that a picture is what it was when its snapshot was accepted.
///
/// ```no_run
/// let image = workbench::Image::new(32, 32);
/// picture_snapshots::assert_picture!("black-square", &image);
/// ```
///
/// The name is made of ASCII letters, digits, `-` and `_`, and is not used twice in a crate. The
/// files lie in the `tests/snapshots/` of the crate that contains this line.
#[macro_export]
macro_rules! assert_picture {
    ($name:expr, $image:expr $(,)?) => {
        $crate::assert_picture_in(::std::env!("CARGO_MANIFEST_DIR").as_ref(), $name, $image)
    };
}

/// [`assert_picture!`] for the crate in `crate_folder`.
///
/// # Panics
/// If a value is not finite, if the snapshot is missing, or if picture or text differ from it.
pub fn assert_picture_in(crate_folder: &Path, name: &str, image: &Image) {
    let safe = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    assert!(!name.is_empty() && name.chars().all(safe), "`{name}` is no name for a snapshot");
    assert_finite(name, image);

    // The picture comes first, so that its difference is written even when the text differs too.
    let compared = compare(crate_folder, name, image);
    if let Err(sentence) = &compared {
        eprintln!("{sentence}");
    }
    assert_text(crate_folder, name, &summary(image));
    assert!(compared.is_ok(), "the picture `{name}` is not the accepted one; see above");
}

/// A picture with a NaN in it would be stored as an odd colour, and then be right for ever after.
fn assert_finite(name: &str, image: &Image) {
    let broken = |pixel: &[f32; 3]| pixel.iter().any(|value| !value.is_finite());
    let count = image.pixels.iter().filter(|pixel| broken(pixel)).count();
    if let Some(first) = image.pixels.iter().position(broken) {
        let (x, y) = (first % image.width as usize, first / image.width as usize);
        let value = image.pixels[first];
        panic!(
            "`{name}` has {count} pixels that are not finite, the first is {value:?} at ({x}, {y})"
        );
    }
}

fn assert_text(crate_folder: &Path, name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path(stored::folder(crate_folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}
