//! The stage through its own binary, as a user has it.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

/// Runs the stage in a folder of its own, with these arguments, separated by spaces.
fn run(arguments: &str) -> (Output, TempDir) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(env!("CARGO_BIN_EXE_path-tracing"))
        .current_dir(&folder)
        .env("RAYON_NUM_THREADS", "1")
        .args(arguments.split_whitespace())
        .output();
    (output.expect("the stage starts"), folder)
}

/// Status and message of a run that should fail.
fn failure(arguments: &str) -> (Option<i32>, String) {
    let (output, folder) = run(arguments);
    let files = folder.path().read_dir().expect("the folder is read").count();
    assert_eq!(files, 0, "`{arguments}` left a file");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The statistics of a run that should succeed.
fn statistics(arguments: &str) -> Value {
    let (output, _) = run(&format!("{arguments} --quiet --stats - -o picture.exr"));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "`{arguments}` said: {message}");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("`{arguments}`: {e}"))
}

fn scene(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    folder.join(name).with_extension("toml").to_string_lossy().into_owned()
}

#[test]
fn without_roulette_a_depth_must_be_given() {
    for roulette in ["off", "1"] {
        let arguments =
            format!("{} --size 4x4 --samples 1 --roulette {roulette}", scene("furnace"));
        let (status, message) = failure(&arguments);
        assert_eq!(status, Some(2), "{message}");
        assert!(message.contains("nothing ends a path: give `--depth D`"), "{message}");
        let (output, _) = run(&format!("{arguments} --depth 3"));
        assert!(
            output.status.success(),
            "with a depth: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
}

#[test]
fn a_probability_that_is_none_is_refused() {
    for roulette in ["0", "nan", "2", "-0.5", "maybe"] {
        let (status, message) = failure(&format!("{} --roulette={roulette}", scene("furnace")));
        assert_eq!(status, Some(2), "{roulette}: {message}");
        assert!(message.contains("a number above 0, at most 1"), "{roulette}: {message}");
    }
}

/// `--error` ends where the error is small enough, and the statistics say how large it is then.
#[test]
fn a_render_to_an_error_states_it() {
    let arguments = format!("{} --size 16x16 --error 5%", scene("furnace"));
    let statistics = statistics(&arguments);
    let error = statistics["estimated_error"].as_f64().expect("an error");
    let samples = statistics["samples"].as_u64().expect("samples");
    assert!(0.0 < error && error <= 0.05, "the error is {error}");
    assert!((16..2000).contains(&samples), "{samples} samples");
}

/// `--time` leaves a whole picture, and every pixel has its samples.
#[test]
fn a_render_for_a_time_ends_with_a_picture() {
    let statistics = statistics(&format!("{} --size 16x16 --time 100ms", scene("cornell-box")));
    let samples = statistics["samples"].as_u64().expect("samples");
    assert!(samples >= 1, "{samples} samples");
    assert_eq!(statistics["non_finite_samples"], 0, "samples that are not finite");
    let seconds = statistics["seconds"]["render"].as_f64().expect("a time");
    assert!((0.05..10.0).contains(&seconds), "{seconds} s");
}

/// Every way to end a path is counted, and each path ends in one of them or leaves the scene.
#[test]
fn ends_of_paths_are_counted() {
    let statistics = statistics(&format!("{} --size 16x16 --samples 16", scene("cornell-box")));
    let count = |key: &str| statistics["skipped"][key].as_u64().expect(key);
    let paths = statistics["rays"]["camera"].as_u64().expect("camera rays");
    let [roulette, black] = ["paths_ended_by_roulette", "paths_ended_by_black"].map(count);
    assert_eq!(paths, 16 * 16 * 16, "paths");
    assert_eq!(count("paths_ended_by_depth"), 0, "there is no depth");
    assert!(roulette > 0 && black > 0 && roulette + black < paths, "{roulette}, {black}");
}

/// Under `--pixel`, the story of the path has a beginning, its rays, and an end.
#[test]
fn the_story_of_a_path_is_told_to_its_end() {
    let arguments = format!("{} --size 16x16 --samples 1 --depth 2", scene("cornell-box"));
    for pixel in ["8,8", "3,12", "12,3"] {
        let (output, _) = run(&format!("{arguments} --pixel {pixel}"));
        let story = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(story.starts_with("camera ray from"), "{story}");
        let ends = ["the depth ends", "leaves the scene", "reflects nothing", "roulette ends"];
        let told = ends.iter().filter(|end| story.contains(*end)).count();
        assert_eq!(told, 1, "one end: {story}");
    }
}
