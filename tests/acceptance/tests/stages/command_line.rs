//! A command line that is wrong: status 2, a remedy, and no file.

use acceptance::{ESTIMATING, Folder, STAGES};

use crate::scenes::{BALL, scene};

#[test]
fn a_wrong_option_is_an_error_2() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    let wrong = [
        ("--size 0x3", "at least 1"),
        ("--size 12", "640x480"),
        ("--size 99999x99999", "memory"),
        ("--size 65536x8192", "memory"),
        ("--samples 0", "1.."),
        ("--depth -1", "-1"),
        ("--threads 0", "from 1 to"),
        ("--seed x", "invalid"),
        ("--pixel 24,0", "columns are 0 to 23"),
        ("-o a.jpg", ".png"),
        ("-o a.png --stats a.png", "same file"),
        ("--sampels 3", "--samples"),
    ];
    for (stage, (option, part)) in STAGES.iter().flat_map(|s| wrong.map(|w| (s, w))) {
        let message = folder.complaint(stage, &format!("s.toml {option}"), 2);
        assert!(message.contains(part), "{stage} {option}: no `{part}` in: {message}");
    }
    let estimating = ["--time 0s", "--time=-1s", "--error 0%", "--error 5", "--error nan%"];
    for stage in STAGES {
        let options: &[&str] =
            if ESTIMATING.contains(&stage) { &estimating } else { &["--time 10s", "--error 1%"] };
        for option in options {
            let message = folder.complaint(stage, &format!("s.toml {option}"), 2);
            let name = option.split([' ', '=']).next().expect("a name");
            assert!(message.contains(name), "{stage} {option}: no `{name}` in: {message}");
        }
    }
    let own = [
        ("ray-casting", "--show nromal", "normal"),
        ("blinn-phong", "--terms al", "all"),
        ("mirror-refraction", "--cutoff=-1", "cutoff"),
        ("mirror-refraction", "--cutoff nan", "cutoff"),
        ("bv-tree", "--volume aab", "aabb"),
        ("bv-tree", "--builder sha", "sah"),
        ("bv-tree", "--cutoff 2", "cutoff"),
        ("rendering-equation", "--branching 0", "branching"),
        ("rendering-equation", "--density cos", "cosine"),
        ("path-tracing", "--roulette 0", "roulette"),
        ("path-tracing", "--roulette nan", "roulette"),
        ("path-tracing", "--roulette off", "--depth"),
        ("light-sampling", "--estimator both", "mis"),
        ("light-sampling", "--heuristic powre", "power"),
    ];
    for (stage, option, part) in own {
        let message = folder.complaint(stage, &format!("s.toml {option}"), 2);
        assert!(message.contains(part), "{stage} {option}: no `{part}` in: {message}");
    }
    assert_eq!(folder.files(), ["s.toml"], "nothing is written");
}

#[test]
fn every_stage_explains_itself() {
    let folder = Folder::with(&[]);
    for stage in STAGES {
        let output = folder.run(stage, "--help", 0);
        let text = String::from_utf8_lossy(&output.stdout);
        for part in [stage, "--samples", "--pixel", "[default: "] {
            assert!(text.contains(part), "{stage} --help has no `{part}`: {text}");
        }
    }
}

#[test]
fn a_result_that_cannot_be_written_is_an_error_1() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    for stage in STAGES {
        for (option, part) in [
            ("-o none/a.png", "create it first"),
            ("-o s.toml/a.png", "s.toml"),
            ("--stats s.toml/s.json", "s.toml"),
            ("-o a.png --stats none/s.json", "create it first"),
        ] {
            let message = folder.complaint(stage, &format!("s.toml {option}"), 1);
            assert!(message.starts_with("error: "), "{stage} {option}: {message}");
            assert!(message.contains(part), "{stage} {option}: no `{part}` in: {message}");
        }
    }
    assert_eq!(folder.files(), ["s.toml"], "nothing is written");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_1() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    if !std::path::Path::new("/dev/full").exists() {
        return;
    }
    for name in ["full.png", "full.exr"] {
        std::os::unix::fs::symlink("/dev/full", folder.path(name)).expect("the link is made");
    }
    let check = |stage: &str, option: &str, message: &str| {
        assert!(message.starts_with("error: "), "{stage} {option}: {message}");
        assert!(message.contains("could not be written: No space"), "{stage} {option}: {message}");
    };
    for stage in STAGES {
        for option in ["-o full.png", "-o full.exr", "-o a.png --stats /dev/full"] {
            check(stage, option, &folder.complaint(stage, &format!("s.toml --quiet {option}"), 1));
        }
        for option in ["--stats -", "--preview", "--pixel 1,1"] {
            let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
            let mut command = folder.command(stage, &format!("s.toml --quiet {option} -o a.png"));
            let output = command.stdout(full.expect("the device")).output().expect("it starts");
            check(stage, option, &String::from_utf8_lossy(&output.stderr));
            assert_eq!(output.status.code(), Some(1), "{stage} {option}: the status");
        }
    }
    assert!(folder.path("full.png").is_symlink(), "the device is not replaced");
}

/// Who pipes the story of a path into `head` has seen enough of it.
#[cfg(unix)]
#[test]
fn a_reader_who_goes_away_is_no_error() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    for stage in STAGES {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let mut command = folder.command(stage, "s.toml --quiet --pixel 1,1");
        let output = command.stdout(writer).output().expect("the stage starts");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!((output.status.code(), &*message), (Some(0), ""), "{stage}");
    }
}
