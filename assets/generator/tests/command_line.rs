//! The command line, through the real binary.

use std::path::Path;
use std::process::{Command, Output};

fn generator(folder: &Path, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_generator"))
        .args(arguments.split(' '))
        .current_dir(folder)
        .output()
        .expect("the generator starts")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder exists");
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.expect("readable").file_name();
    let mut names: Vec<_> = entries.map(|e| name(e).to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn every_kind_is_written_whole_and_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for arguments in [
        "blob --triangles 1000 -o a.obj",
        "terrain --side 10 --seed 2 -o b.obj",
        "sphereflake --depth 1 -o c.toml",
        "sphereflake --depth 1 --rings 4 -o d.obj",
        "checker --tiles 4 --pixels 2 -o e.png",
    ] {
        let output = generator(folder.path(), arguments);
        assert!(output.status.success(), "{arguments}: {}", said(&output));
    }
    let expected = ["a.obj", "b.obj", "c.toml", "d.obj", "e.png"];
    assert_eq!(names(folder.path()), expected, "files in the folder");
}

#[test]
fn the_same_options_give_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for kind in ["blob --triangles 5000", "terrain --triangles 5000", "sphereflake --depth 2"] {
        let bytes = |name: &str| {
            generator(folder.path(), &format!("{kind} -o {name}"));
            std::fs::read(folder.path().join(name)).expect("a file was written")
        };
        assert!(bytes("one") == bytes("two"), "{kind} differs between two runs");
    }
}

#[test]
fn a_file_that_cannot_be_written_is_named_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("taken")).expect("a folder");
    for target in ["missing/blob.obj", "taken"] {
        let output = generator(folder.path(), &format!("blob --rings 4 -o {target}"));
        assert_eq!(output.status.code(), Some(1), "{target}: {}", said(&output));
        assert!(said(&output).contains(target), "{target} is not named: {}", said(&output));
    }
    assert_eq!(names(folder.path()), ["taken"], "files in the folder");
}

#[test]
fn sizes_that_make_no_mesh_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (arguments, status) in [
        ("blob --rings 2 -o a.obj", 2),
        ("blob --triangles 0 -o a.obj", 2),
        ("blob --rings 5 --triangles 9 -o a.obj", 2),
        ("terrain --side 0 -o a.obj", 2),
        ("sphereflake --depth 8 -o a.toml", 2),
        ("blob --rings 5", 2),
        ("sphereflake --depth 6 --rings 1000 -o a.obj", 1),
    ] {
        let output = generator(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments}: {}", said(&output));
    }
    assert_eq!(names(folder.path()), [""; 0], "files in the folder");
}
