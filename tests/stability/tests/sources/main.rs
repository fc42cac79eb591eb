//! What the text of the chapters must not contain: a magic epsilon, a function whose digits depend on
//! the platform, an order that depends on the threads or on a hash.
//!
//! The rules read text, not syntax: they know comments, strings and `#[cfg(test)]`, and nothing else of
//! Rust. What they complain about and is right all the same stands in a list of exceptions, each with
//! its reason; an exception that is no longer needed is an error as well.

mod code;
mod epsilons;
mod functions;
mod order;

use std::fs;
use std::path::{Path, PathBuf};

/// Something that is allowed in one file.
pub(crate) struct Exception {
    /// Seen from `chapters`.
    file: &'static str,
    /// What the line contains.
    line: &'static str,
    /// Why it is right.
    reason: &'static str,
}

/// Files that are tests, though no `#[cfg(test)]` stands in them.
const TESTS: [&str; 2] = ["00-workbench/src/run/tests.rs", "01-ray-casting/src/conformance/"];

/// Every source file of a chapter: its name, seen from `chapters`, and its text.
fn sources() -> Vec<(String, String)> {
    let chapters = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../chapters");
    let mut files = Vec::new();
    for chapter in children(&chapters) {
        let source = chapter.join("src");
        if source.is_dir() {
            collect(&source, &mut files);
        }
    }
    let name = |path: &PathBuf| {
        let path = path.strip_prefix(&chapters).expect("it was found there");
        path.to_string_lossy().replace('\\', "/")
    };
    let read =
        |path: &PathBuf| fs::read_to_string(path).unwrap_or_else(|e| panic!("{path:?}: {e}"));
    let mut sources: Vec<(String, String)> =
        files.iter().map(|path| (name(path), read(path))).collect();
    sources.retain(|(name, _)| !TESTS.iter().any(|test| name.starts_with(test)));
    sources.sort();
    sources
}

fn children(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{folder:?}: {e}"));
    entries.map(|entry| entry.expect("an entry of a folder is read").path()).collect()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for path in children(folder) {
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// Asserts that `rule`, told all code of a file and a line of it, finds nothing in the files that
/// `is_read` names, but what is excepted.
pub(crate) fn check(
    is_read: impl Fn(&str) -> bool,
    rule: impl Fn(&str, &str) -> Vec<String>,
    exceptions: &[Exception],
) {
    let (mut lines, mut faults, mut needed) = (0, Vec::new(), vec![false; exceptions.len()]);
    for (file, text) in sources().iter().filter(|(file, _)| is_read(file)) {
        let code = code::code(text);
        for (number, line) in code::lines(&code) {
            lines += 1;
            for what in rule(&code, line) {
                let is_excuse = |e: &Exception| e.file == file && line.contains(e.line);
                match exceptions.iter().position(is_excuse) {
                    Some(i) => needed[i] = true,
                    None => faults.push(format!("{file}:{number}: {what} in `{}`", line.trim())),
                }
            }
        }
    }
    assert!(lines > 4000, "only {lines} lines of code were read");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    for (Exception { file, line, reason }, needed) in exceptions.iter().zip(needed) {
        assert!(needed, "{file} no longer needs `{line}`, which was allowed because {reason}");
    }
}
