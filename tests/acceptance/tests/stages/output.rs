//! What a stage writes and prints.

use std::fs;

use acceptance::{ESTIMATING, Folder, STAGES};
use serde_json::Value;
use workbench::Image;

use crate::scenes::{BALL, scene};

const KEYS: [(&str, &[&str]); 4] = [
    ("seconds", &["build", "load", "render"]),
    ("rays", &["camera", "reflection", "refraction", "scatter", "shadow"]),
    ("tests", &["primitive", "volume"]),
    (
        "skipped",
        &[
            "any_hit_exits",
            "branches_below_threshold",
            "fresnel_splits",
            "own_triangles",
            "paths_ended_by_black",
            "paths_ended_by_depth",
            "paths_ended_by_roulette",
            "samples_not_needed",
            "shadow_rays_delta",
            "shadow_rays_facing_away",
            "shadow_rays_nothing_to_reflect",
            "surface_points",
            "texture_coordinates",
            "textures_not_loaded",
            "trees_not_built",
            "walls_left_out",
        ],
    ),
];

/// Scripts rely on them: keys are added, never renamed.
#[test]
fn statistics_have_the_promised_keys() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    for stage in STAGES {
        folder.run(stage, "s.toml --samples 3 --seed 5 --threads 2 --quiet --stats s.json", 0);
        let text = fs::read_to_string(folder.path("s.json")).expect("the statistics are read");
        let all: Value = serde_json::from_str(&text).expect("they are JSON");
        assert_eq!(all["stage"], stage, "stage");
        assert_eq!(all["scene"], "s", "{stage}: scene");
        assert_eq!(all["size"], serde_json::json!([24, 16]), "{stage}: size");
        assert_eq!((&all["samples"], &all["seed"]), (&3.into(), &5.into()), "{stage}: numbers");
        assert_eq!(all["threads"], 2, "{stage}: threads");
        assert_eq!(all["non_finite_samples"], 0, "{stage}: non-finite samples");
        for (group, keys) in KEYS {
            let mut found: Vec<&String> = all[group].as_object().expect(group).keys().collect();
            found.sort();
            assert_eq!(found, keys, "{stage}: keys of {group}");
            let sound = |value: &Value| value.as_f64().is_some_and(|number| number >= 0.0);
            let values = all[group].as_object().expect(group);
            assert!(values.values().all(sound), "{stage}: {group} is {values:?}");
        }
        assert_eq!(all["rays"]["camera"], 24 * 16 * 3, "{stage}: camera rays");
    }
}

/// The counts, but for `threads` and the times.
fn counts(folder: &Folder, stage: &str, arguments: &str) -> Value {
    let output = folder.run(stage, &format!("{arguments} --quiet --stats -"), 0);
    let mut all: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let keys = all.as_object_mut().expect("an object");
    keys.remove("threads");
    keys.remove("seconds");
    all
}

#[test]
fn counts_do_not_depend_on_threads() {
    let folder = Folder::with(&[]);
    for stage in STAGES.into_iter().filter(|&stage| stage != "workbench") {
        let count = |threads: u32| {
            let size = "--size 48x32 --samples 2";
            counts(&folder, stage, &format!("whitted {size} --threads {threads} -o a.exr"))
        };
        let one = count(1);
        assert_eq!([count(2), count(5)], [one.clone(), one], "{stage}: counts of 1, 2, 5 threads");
    }
}

#[test]
fn a_pixel_is_told_and_not_written() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    for stage in STAGES {
        folder.run(stage, "s.toml --samples 4 --quiet -o whole.exr", 0);
        let output = folder.run(stage, "s.toml --samples 4 -o one.exr --pixel 12,8", 0);
        let text = String::from_utf8_lossy(&output.stdout);
        let whole = Image::load_exr(&folder.path("whole.exr")).expect("the picture is read");
        let [r, g, b] = whole.pixel(12, 8);
        let last = format!("pixel (12, 8): {r} {g} {b}, ");
        let told = text.lines().last().is_some_and(|line| line.starts_with(&last));
        assert!(told, "{stage} does not end with `{last}`: {text}");
        if ESTIMATING.contains(&stage) {
            let paths = text.matches("camera ray").count();
            assert_eq!(paths, 1, "{stage}, the first path alone: {text}");
        } else if stage != "workbench" {
            assert_eq!(
                text.matches("hits Hit").count(),
                1,
                "{stage}, the first path alone: {text}"
            );
        }
        fs::remove_file(folder.path("whole.exr")).expect("it is removed");
        assert_eq!(folder.files(), ["s.toml"], "{stage}: the files");
    }
}

/// `--pixel` promises every ray, hit and weight of the first path.
#[test]
fn the_story_of_a_path_has_every_ray_with_its_weight() {
    let folder = Folder::with(&[]);
    let recursions = ["mirror-refraction", "bv-tree"];
    for stage in recursions.into_iter().chain(ESTIMATING) {
        for pixel in ["21,43", "43,40", "32,5"] {
            let depth = if stage == "rendering-equation" { "--depth 3" } else { "" };
            let options = format!("--size 64x64 --samples 1 --pixel {pixel} {depth}");
            let arguments = format!("cornell-spheres {options} --stats stats.json");
            let output = folder.run(stage, &arguments, 0);
            let story = String::from_utf8_lossy(&output.stdout);
            let text = fs::read_to_string(folder.path("stats.json")).expect("the statistics");
            let all: Value = serde_json::from_str(&text).expect("they are JSON");
            let rays = ["camera", "reflection", "refraction", "scatter"]
                .map(|kind| all["rays"][kind].as_u64().expect("a count"));
            let is_ray = |line: &&str| line.contains(" from ") && line.contains(" along ");
            let told = story.lines().filter(is_ray).count();
            assert_eq!(told as u64, rays.iter().sum::<u64>(), "{stage}, {pixel}: {story}");
            let ends = ["hits", "leaves the scene"].map(|end| story.matches(end).count());
            assert_eq!(ends.iter().sum::<usize>(), told, "{stage}, {pixel}, its ends: {story}");
            let weights = ["weight", "β ="].map(|weight| story.matches(weight).count());
            assert!(weights.iter().sum::<usize>() + 1 >= told, "{stage}, its weights: {story}");
        }
    }
}

/// What a stage cannot show it says, and nothing else: chapter 7 finds the point lights, unless it
/// waits to meet them.
#[test]
fn only_who_cannot_find_point_lights_says_so() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    for (stage, options, is_blind) in [
        ("rendering-equation", "", true),
        ("path-tracing", "", true),
        ("light-sampling", "--estimator scatter", true),
        ("light-sampling", "--estimator light", false),
        ("light-sampling", "--estimator mis", false),
    ] {
        let line = format!("s.toml --samples 4 {options} -o a.png");
        let summary = folder.complaint(stage, &line, 0);
        let says_so = summary.contains("never hits a point light");
        assert_eq!(says_so, is_blind, "{stage} {options}: {summary}");
    }
}

#[test]
fn only_the_picture_is_left_behind() {
    for stage in STAGES {
        let folder = Folder::with(&[("s.toml", &scene(BALL))]);
        folder.run(stage, "s.toml --samples 1", 0);
        let picture = format!("{stage}-s.png");
        let mut files = vec![picture.clone(), "s.toml".to_owned()];
        files.sort();
        assert_eq!(folder.files(), files, "{stage}: the files");
        let image = Image::load_png(&folder.path(&picture)).expect("the picture is read");
        assert_eq!([image.width, image.height], [24, 16], "{stage}: the size");
    }
}
