//! Inputs that a fuzzer has found, and some that show it the way: none of them is a problem any more.

use std::fs;
use std::path::Path;

use stability::replay::TARGETS;

/// Every file in `tests/fuzz/regressions/TARGET` goes through its target.
#[test]
fn what_was_found_once_stays_mended() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/regressions");
    for (name, target) in TARGETS {
        let files = fs::read_dir(folder.join(name));
        let files = files.unwrap_or_else(|error| panic!("no inputs of {name}: {error}"));
        let mut count = 0;
        for file in files {
            let path = file.expect("the folder is read").path();
            println!("{}", path.display());
            target(&fs::read(&path).expect("the input is read"));
            count += 1;
        }
        assert!(count > 0, "{name} has {count} inputs");
    }
}

/// Each target that can be fuzzed is one that is replayed.
#[test]
fn every_target_is_replayed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/fuzz_targets");
    let mut files: Vec<String> = fs::read_dir(folder)
        .expect("the targets are listed")
        .map(|file| file.expect("the folder is read").path())
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    let mut names = TARGETS.map(|(name, _)| name.to_owned()).to_vec();
    files.sort();
    names.sort();
    assert_eq!(files, names, "the files of tests/fuzz/fuzz_targets");
}
