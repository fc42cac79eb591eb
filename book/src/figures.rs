//! Figures: every picture, plot, table and number of the pages, made by the stages themselves.
//!
//! One function makes one file under `pages/figures/`. `figures` writes the files, and they are
//! committed; `figures --check` makes them again and fails if any differs, so the book cannot
//! drift away from the code.

mod blinn_phong;
pub(crate) mod bv_tree;
pub(crate) mod light_sampling;
mod mirror_refraction;
mod path_tracing;
pub(crate) mod ray_casting;
pub(crate) mod rendering_equation;
pub(crate) mod stability;
mod workbench;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::plot::Plot;
use crate::table::Table;
use crate::{Error, Result, folder};

/// Where the figures stand, seen from the book's folder.
pub const FOLDER: &str = "pages/figures";

/// Where a check leaves what it made differently, seen from the book's folder.
const DIFFERENT: &str = "../target/figures";

/// A file of the book, and the function that makes it.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Its path under `pages/figures/`, for example `01-ray-casting/facing-ratio.png`.
    pub file: &'static str,
    /// Makes it. The same bytes on every machine: no clock, no random seed but a fixed one.
    pub draw: fn() -> Drawing,
}

/// What a figure is made of.
#[derive(Clone, Debug)]
pub enum Drawing {
    /// A picture: `.png`, compared pixel by pixel after decoding.
    Picture(Picture),
    /// A plot or a diagram (`.svg`), a table or numbers (`.md`): compared exactly.
    Text(String),
}

impl From<Picture> for Drawing {
    fn from(picture: Picture) -> Self {
        Self::Picture(picture)
    }
}

impl From<Plot> for Drawing {
    fn from(plot: Plot) -> Self {
        Self::Text(plot.svg())
    }
}

impl From<Table> for Drawing {
    fn from(table: Table) -> Self {
        Self::Text(table.markdown())
    }
}

impl From<Numbers> for Drawing {
    fn from(numbers: Numbers) -> Self {
        Self::Text(numbers.text())
    }
}

/// Every figure of the book, chapter by chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [
        workbench::FIGURES,
        ray_casting::FIGURES,
        blinn_phong::FIGURES,
        mirror_refraction::FIGURES,
        bv_tree::FIGURES,
        rendering_equation::FIGURES,
        path_tracing::FIGURES,
        light_sampling::FIGURES,
        stability::FIGURES,
    ]
    .concat()
}

/// The scene file of a bare name like `whitted`, wherever the figures are made.
#[must_use]
pub fn scene_file(name: &str) -> PathBuf {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/scenes");
    scenes.join(name).with_extension("toml")
}

/// Makes the figures of the book at `root` whose file name contains `only`, and writes those that
/// differ from what is there.
///
/// # Errors
///
/// A file that cannot be written, or `only` fits no figure.
pub fn make(root: &Path, only: &str) -> Result<()> {
    let folder = root.join(FOLDER);
    for figure in matching(&all(), only)? {
        let start = Instant::now();
        let drawing = (figure.draw)();
        let what = match difference(&folder.join(figure.file), &drawing) {
            None => "is as it was".to_owned(),
            Some(difference) => {
                save(&folder.join(figure.file), &drawing)?;
                format!("written: {difference}")
            }
        };
        eprintln!("{} {what} ({:.1} s)", figure.file, start.elapsed().as_secs_f32());
    }
    Ok(())
}

/// Makes the figures whose file name contains `only` again, and compares them with the book's.
///
/// What differs is written to `target/figures/`, to be looked at.
///
/// # Errors
///
/// One line for each figure that differs, and for each file that no figure makes any more.
pub fn check(root: &Path, only: &str) -> Result<String> {
    let figures = matching(&all(), only)?;
    let folder = root.join(FOLDER);
    let mut differences = Vec::new();
    for figure in &figures {
        let drawing = (figure.draw)();
        if let Some(difference) = difference(&folder.join(figure.file), &drawing) {
            save(&root.join(DIFFERENT).join(figure.file), &drawing)?;
            differences.push(format!("\n  {}: {difference}", figure.file));
        }
    }
    if only.is_empty() {
        let made: BTreeSet<_> = figures.iter().map(|figure| folder.join(figure.file)).collect();
        let unknown = folder::files(&folder)?.into_iter().filter(|file| !made.contains(file));
        differences.extend(unknown.map(|file| {
            let file = file.strip_prefix(&folder).unwrap_or(&file).display();
            format!("\n  {file}: no figure makes this file")
        }));
    }
    if differences.is_empty() {
        Ok(format!("{} figures are what the stages make today", figures.len()))
    } else {
        let list = differences.concat();
        Err(Error::msg(format!("figures that have drifted (fresh ones: target/figures):{list}")))
    }
}

fn matching(figures: &[Figure], only: &str) -> Result<Vec<Figure>> {
    let found: Vec<_> = figures.iter().copied().filter(|f| f.file.contains(only)).collect();
    if found.is_empty() {
        return Err(Error::msg(format!("no figure's file name contains `{only}`")));
    }
    Ok(found)
}

/// How a fresh drawing differs from the file in the book, in words; `None` if it does not.
fn difference(file: &Path, drawing: &Drawing) -> Option<String> {
    match drawing {
        Drawing::Picture(picture) => match Picture::load(file) {
            Ok(old) => old.difference(picture),
            Err(error) => Some(error.to_string()),
        },
        Drawing::Text(text) => match fs::read_to_string(file) {
            Ok(old) => text_difference(&old, text),
            Err(error) => Some(error.to_string()),
        },
    }
}

fn text_difference(old: &str, new: &str) -> Option<String> {
    let differs = |&(_, (old, new)): &(usize, (&str, &str))| old != new;
    let pairs = old.lines().chain([""]).zip(new.lines().chain([""])).enumerate();
    match pairs.into_iter().find(differs) {
        Some((i, (old, new))) => Some(format!("line {}: `{old}` is now `{new}`", i + 1)),
        None if old != new => Some("its number of lines or its ending".to_owned()),
        None => None,
    }
}

fn save(file: &Path, drawing: &Drawing) -> Result<()> {
    match drawing {
        Drawing::Picture(picture) => folder::write(file, picture.png()?),
        Drawing::Text(text) => folder::write(file, text),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{Drawing, all, difference, save, text_difference};
    use crate::picture::Picture;

    #[test]
    fn no_two_figures_write_the_same_file() {
        let files: BTreeSet<_> = all().iter().map(|figure| figure.file).collect();
        assert_eq!(files.len(), all().len(), "{files:?}");
    }

    #[test]
    fn a_figure_equals_itself_after_saving_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let picture = Picture::new(2, 1, vec![1, 2, 3, 255, 4, 5, 6, 255]);
        let mut other = picture.clone();
        other.rgba[4] += 1;
        for (name, drawing, other) in [
            ("a/p.png", Drawing::Picture(picture), Drawing::Picture(other)),
            ("a/t.md", Drawing::Text("x\n".into()), Drawing::Text("y\n".into())),
        ] {
            let file = folder.path().join(name);
            assert!(difference(&file, &drawing).is_some(), "{name} does not exist yet");
            save(&file, &drawing).expect("the folder can be written");
            assert_eq!(difference(&file, &drawing), None, "{name} is what was saved");
            assert!(difference(&file, &other).is_some(), "{name} is not the other one");
        }
    }

    #[test]
    fn the_first_line_that_differs_is_shown() {
        assert_eq!(text_difference("a\nb\n", "a\nb\n"), None, "the same text");
        let shown = text_difference("a\nb\n", "a\nc\n").expect("b is not c");
        assert_eq!(shown, "line 2: `b` is now `c`", "the line and both texts");
        assert!(text_difference("a\n", "a\nb\n").is_some(), "a line more");
        assert!(text_difference("a\n", "a").is_some(), "another ending");
    }
}
