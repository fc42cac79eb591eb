//! Every mutant of the bug zoo can be planted, and its test exists. Whether the test notices it, the
//! program `zoo` shows.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use stability::zoo::{Mutant, Target, Test, mutants};

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn every_mutant_can_be_planted() {
    for mutant in mutants() {
        let Mutant { name, file, .. } = mutant;
        let text = fs::read_to_string(workspace().join(file));
        let text = text.unwrap_or_else(|error| panic!("{name}: {file}: {error}"));
        let planted = mutant.plant(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(planted != text, "{name}: {file} stays as it is");
        // A change of the tests would be killed for the wrong reason.
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        assert!(code.contains(mutant.old), "{name}: the change is in the tests of {file}");
    }
}

#[test]
fn every_test_that_a_mutant_names_exists() {
    for Mutant { name, test, .. } in mutants() {
        let sources = sources(&test);
        let function = format!("fn {}()", test.name);
        let place = sources.iter().find(|text| text.contains(&function));
        assert!(place.is_some(), "{name}: no `{function}` in {} files of {test}", sources.len());
    }
}

#[test]
fn there_are_many_mutants_with_names_of_their_own() {
    let mutants = mutants();
    assert!(mutants.len() >= 25, "only {} mutants", mutants.len());
    let names: BTreeSet<_> = mutants.iter().map(|mutant| mutant.name).collect();
    assert_eq!(names.len(), mutants.len(), "some names occur twice: {names:?}");
    let changes: BTreeSet<_> = mutants.iter().map(|m| (m.file, m.old, m.new)).collect();
    assert_eq!(changes.len(), mutants.len(), "some changes occur twice: {changes:?}");
    for Mutant { name, lesson, .. } in mutants {
        assert!(!name.is_empty() && !lesson.is_empty(), "`{name}` teaches `{lesson}`");
        assert!(!name.contains('|'), "`{name}` would break the table");
    }
}

/// The text of every file that may hold `test`.
fn sources(test: &Test) -> Vec<String> {
    let folder = test.folder(&workspace());
    let folder = folder.unwrap_or_else(|| panic!("there is no package {}", test.package));
    let mut texts = Vec::new();
    match test.target {
        Target::Lib => read_all(&folder.join("src"), &mut texts),
        Target::Tests(program) => {
            let file = folder.join("tests").join(format!("{program}.rs"));
            texts.extend(fs::read_to_string(file));
            read_all(&folder.join("tests").join(program), &mut texts);
        }
    }
    texts
}

/// The text of every file below `folder`, which need not exist.
fn read_all(folder: &Path, texts: &mut Vec<String>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            read_all(&path, texts);
        } else {
            texts.extend(fs::read_to_string(path));
        }
    }
}
