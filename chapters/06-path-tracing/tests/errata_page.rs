//! The book's page of errata names the tests that show its rows.

use std::fs;
use std::path::{Path, PathBuf};

/// All Rust files below `folder`.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Names in code quotes that can only be those of tests.
fn names(page: &str) -> Vec<&str> {
    let quoted = page.split('`').skip(1).step_by(2);
    quoted.filter(|name| name.matches('_').count() >= 2 && !name.contains(' ')).collect()
}

#[test]
fn every_test_that_the_page_of_errata_names_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("book/pages/errata.md")).expect("the page is read");
    let mut files = Vec::new();
    sources(&root.join("chapters"), &mut files);
    let read = |file: &PathBuf| fs::read_to_string(file).expect("a source is read");
    let all: Vec<String> = files.iter().map(read).collect();
    let names = names(&page);
    assert!(names.len() > 20, "only {} tests are named", names.len());
    for name in names {
        let exists = all.iter().any(|text| text.contains(&format!("fn {name}(")));
        assert!(exists, "the page names `{name}`, which is no test of any chapter");
    }
}

/// And the other way round: what is called an erratum is on the page.
#[test]
fn every_test_of_an_erratum_is_named_on_the_page() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("book/pages/errata.md")).expect("the page is read");
    let mut files = Vec::new();
    sources(&root.join("chapters"), &mut files);
    for file in files {
        let text = fs::read_to_string(&file).expect("a source is read");
        for part in text.split("fn erratum_").skip(1) {
            let Some((name, _)) = part.split_once("()") else { continue };
            if name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
                assert!(page.contains(name), "the page does not name `erratum_{name}`");
            }
        }
    }
}
