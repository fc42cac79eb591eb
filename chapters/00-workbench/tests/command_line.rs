//! The command line through a real binary: exit status, what is said, and what is written.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use workbench::Image;

const SCENE: &str = "[camera]\neye = [0, 0, -5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [40, 30]\n";

struct Folder(tempfile::TempDir);

impl Folder {
    /// A working folder with a scene, `s.toml`.
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("s.toml"), SCENE).expect("the scene is written");
        Self(folder)
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbench"));
        command.current_dir(self.0.path()).args(arguments.split_whitespace());
        command
    }

    fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().expect("the binary starts")
    }

    /// What stands on standard error after a run that must end with `status`.
    fn expect(&self, arguments: &str, status: i32) -> String {
        let output = self.run(arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(status), "`{arguments}` said: {message}");
        message
    }

    /// The names of the files, sorted.
    fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("the folder is read");
        let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
        let mut names: Vec<String> = entries.map(|entry| name(entry.expect("an entry"))).collect();
        names.sort();
        names
    }
}

fn hash(path: &Path) -> u64 {
    Image::load_exr(path).expect("the picture is read").hash()
}

#[test]
fn the_picture_is_named_after_stage_and_scene() {
    let folder = Folder::new();
    let message = folder.expect("s.toml", 0);
    assert_eq!(folder.files(), ["s.toml", "workbench-s.png"], "the files");
    assert!(message.contains("workbench-s.png: 40×30 pixels, 1 sample a pixel"), "{message}");
    let image = Image::load_png(&folder.path("workbench-s.png")).expect("the picture is read");
    assert_eq!([image.width, image.height], [40, 30], "the size");
}

#[test]
fn threads_never_change_the_picture_and_the_seed_always_does() {
    let folder = Folder::new();
    let pictures = ["--threads 1", "--threads 2", "--threads 5", "", "--seed 1"].map(|option| {
        folder.expect(&format!("s.toml --samples 3 --quiet -o a.exr {option}"), 0);
        hash(&folder.path("a.exr"))
    });
    assert_eq!(pictures[..4], [pictures[0]; 4], "the hashes of 1, 2, 5 and all threads");
    assert_ne!(pictures[4], pictures[0], "the hash of another seed");
}

#[test]
fn quiet_says_nothing() {
    let folder = Folder::new();
    let output = folder.run("s.toml --quiet");
    assert!(output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
}

#[test]
fn statistics_go_to_a_file_or_to_standard_output() {
    let folder = Folder::new();
    folder.expect("s.toml --samples 2 --size 10x20 --seed 9 --threads 1 --stats s.json", 0);
    let text = fs::read_to_string(folder.path("s.json")).expect("the statistics are read");
    let file: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
    let expected = serde_json::json!({
        "stage": "workbench", "scene": "s", "size": [10, 20], "samples": 2, "threads": 1, "seed": 9,
        "seconds": file["seconds"],
        "rays": {"camera": 400, "shadow": 0, "reflection": 0, "refraction": 0, "scatter": 0},
        "tests": {"volume": 0, "primitive": 0},
        "skipped": {"shadow_rays_facing_away": 0, "shadow_rays_nothing_to_reflect": 0,
                    "branches_below_threshold": 0, "paths_ended_by_roulette": 0,
                    "paths_ended_by_depth": 0, "paths_ended_by_black": 0, "shadow_rays_delta": 0,
                    "any_hit_exits": 0, "surface_points": 0, "texture_coordinates": 0,
                    "textures_not_loaded": 0, "trees_not_built": 0, "fresnel_splits": 0,
                    "own_triangles": 0, "walls_left_out": 0, "samples_not_needed": 0},
        "non_finite_samples": 0, "estimated_error": null
    });
    assert_eq!(file, expected, "the statistics");
    for part in ["load", "build", "render"] {
        assert!(file["seconds"][part].is_f64(), "seconds of {part}: {}", file["seconds"]);
    }
    let output = folder.run("s.toml --stats - --pixel 1,2 --preview");
    let printed: serde_json::Value =
        serde_json::from_slice(&output.stdout).expect("nothing but JSON on standard output");
    assert_eq!(printed["rays"]["camera"], 1, "one pixel, one sample");
}

#[test]
fn a_pixel_is_told_and_not_written() {
    let folder = Folder::new();
    folder.expect("s.toml --samples 4 -o a.exr", 0);
    let output = folder.run("s.toml --samples 4 -o b.exr --pixel 7,3");
    let text = String::from_utf8_lossy(&output.stdout);
    let [r, g, b] = Image::load_exr(&folder.path("a.exr")).expect("it is read").pixel(7, 3);
    assert_eq!(text.matches("film point (7.").count(), 1, "only the first path is told: {text}");
    assert!(
        text.contains(&format!("pixel (7, 3): {r} {g} {b}, ")),
        "{r} {g} {b} is not in: {text}"
    );
    assert_eq!(folder.files(), ["a.exr", "s.toml"], "the files");
}

#[test]
fn the_preview_is_shown_even_when_quiet() {
    let folder = Folder::new();
    let output = folder.run("s.toml --preview --quiet");
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(text.lines().count(), 15, "30 rows, two a line: {text}");
}

#[test]
fn a_wrong_command_line_is_an_error_2_with_a_remedy() {
    let folder = Folder::new();
    let wrong = [
        ("s.toml --size 0x3", "at least 1"),
        ("s.toml --size 12", "640x480"),
        ("s.toml --size=-1x3", "640x480"),
        ("s.toml --size 99999x99999", "memory"),
        ("s.toml --size 4294967296x1", "640x480"),
        ("s.toml --samples 0", "1.."),
        ("s.toml --samples x", "invalid"),
        ("s.toml --depth -1", "-1"),
        ("s.toml --threads 0", "from 1 to"),
        ("s.toml --seed x", "invalid"),
        ("s.toml --pixel 1", "12,34"),
        ("s.toml --pixel 40,0", "columns are 0 to 39"),
        ("s.toml --time 10s", "--samples"),
        ("s.toml --time 10", "unit"),
        ("s.toml --error 1%", "--samples"),
        ("s.toml --error 1", "1%"),
        ("s.toml -o a.jpg", ".png"),
        ("s.toml -o a", ".exr"),
        ("s.toml -o a.png --stats a.png", "same file"),
        ("s.toml t.toml", "unexpected"),
        ("s.toml --sampels 3", "--samples"),
    ];
    for (arguments, part) in wrong {
        let message = folder.expect(arguments, 2);
        assert!(message.contains(part), "no `{part}` after `{arguments}`: {message}");
    }
    assert_eq!(folder.files(), ["s.toml"], "nothing is written");
}

#[test]
fn wrong_input_is_an_error_1_and_nothing_is_written() {
    let folder = Folder::new();
    fs::write(folder.path("w.toml"), SCENE.replace("fov", "fow")).expect("it is written");
    fs::create_dir(folder.path("d")).expect("it is created");
    fs::create_dir(folder.path("d.png")).expect("it is created");
    let files = folder.files();
    let wrong = [
        ("none.toml", "no such file"),
        ("d", "folder"),
        ("w.toml", "did you mean `fov`?"),
        ("s.toml -o none/a.png", "create it first"),
        ("s.toml -o d.png", "folder"),
        ("s.toml --stats none/s.json", "create it first"),
    ];
    for (arguments, part) in wrong {
        let message = folder.expect(arguments, 1);
        assert!(message.starts_with("error: "), "{message}");
        assert!(message.contains(part), "no `{part}` after `{arguments}`: {message}");
    }
    assert_eq!(folder.files(), files, "nothing is written");
}

#[test]
fn help_names_the_scene_of_the_stage_and_only_what_the_stage_takes() {
    let folder = Folder::new();
    let output = folder.run("--help");
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "the status");
    assert!(text.contains("[default: teapot]") && text.contains("--preview"), "{text}");
    assert!(!text.contains("--time"), "a stage that does not estimate offers --time: {text}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_1_and_leaves_no_half_file() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    symlink("/dev/full", folder.path("full.png")).expect("the link is made");
    for arguments in ["s.toml --quiet -o full.png", "s.toml --quiet -o a.png --stats /dev/full"] {
        let message = folder.expect(arguments, 1);
        assert!(message.contains("could not be written"), "{message}");
    }
    assert!(folder.path("full.png").is_symlink(), "the device is not replaced");
}

/// Ctrl-C keeps what there is.
#[cfg(unix)]
#[test]
fn an_interrupt_keeps_the_picture() {
    use std::io::Read;
    use std::process::Stdio;
    use std::time::Duration;

    let folder = Folder::new();
    for signal in ["-INT", "-TERM"] {
        let mut child = folder
            .command("s.toml --samples 4000000000 -o a.png")
            .stderr(Stdio::piped())
            .spawn()
            .expect("the binary starts");
        std::thread::sleep(Duration::from_millis(500));
        let sent = Command::new("kill").args([signal, &child.id().to_string()]).status();
        assert!(sent.is_ok_and(|status| status.success()), "the signal is sent");
        let status = child.wait().expect("the binary ends");
        let mut message = String::new();
        let mut stderr = child.stderr.take().expect("it is piped");
        stderr.read_to_string(&mut message).expect("it is text");
        assert_eq!(status.code(), Some(130), "{signal}: {message}");
        assert!(message.contains("interrupted: the picture holds "), "{message}");
        assert_eq!(folder.files(), ["a.png", "s.toml"], "the files after {signal}");
        fs::remove_file(folder.path("a.png")).expect("the picture is removed");
    }
}
