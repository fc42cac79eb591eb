//! Work that is skipped: counted, and done after all under `--no-skip`, without another picture.

use std::collections::BTreeMap;

use acceptance::Folder;
use serde_json::Value;
use workbench::Image;

use crate::scenes::scene;

/// The stages in which rays meet boundaries between media.
const REFRACTING: [&str; 5] =
    ["mirror-refraction", "bv-tree", "rendering-equation", "path-tracing", "light-sampling"];

/// The stages that search a tree.
const WITH_TREE: [&str; 4] = ["bv-tree", "rendering-equation", "path-tracing", "light-sampling"];

/// Something for every skip: shadows, a green light beside the white one, lamps that face away from
/// most of the scene, surfaces behind each other, a mirror, a body of index 1, one that is black,
/// and a picture that nothing wears.
const RICH: &str = "[[point_light]]\nposition = [-3, 4, 5]\nintensity = [0, 20, 0]\n\
    [materials.red]\nkd = [0.6, 0, 0]\n\
    [materials.black]\nkd = [0, 0, 0]\n\
    [materials.mirror]\nsurface = 'mirror'\nkr = [0.9, 0.9, 0.9]\n\
    [materials.air]\nsurface = 'glass'\nni = 1\n\
    [materials.lamp]\nke = [3, 4, 5]\n\
    [materials.unused]\nkd = [1, 1, 1]\nmap_kd = 'broken.png'\n\
    [[quad]]\nvertices = [[-4, -1, 4], [4, -1, 4], [4, -1, -4], [-4, -1, -4]]\n\
    material = 'white'\n\
    [[quad]]\nvertices = [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]]\nmaterial = 'lamp'\n\
    [[quad]]\nvertices = [[-1, 0, -3], [-1, 2, -3], [1, 2, -3], [1, 0, -3]]\nmaterial = 'lamp'\n";

/// Two walls, a lamp, and something that throws a shadow.
const WALLED: &str = "[materials.lamp]\nke = [3, 4, 5]\n\
    [[quad]]\nvertices = [[-4, -1, 4], [4, -1, 4], [4, -1, -4], [-4, -1, -4]]\n\
    material = 'white'\n\
    [[quad]]\nvertices = [[-4, -1, -4], [4, -1, -4], [4, 7, -4], [-4, 7, -4]]\n\
    material = 'white'\n\
    [[quad]]\nvertices = [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]]\nmaterial = 'lamp'\n\
    [[sphere]]\ncenter = [0, 0, 0]\nradius = 0.6\nmaterial = 'white'\n\
    [[sphere]]\ncenter = [1.5, 0, 0]\nradius = 0.6\nmaterial = 'white'\n";

/// The balls of the rich scene: x, z and material.
const BALLS: [(f32, f32, &str); 8] = [
    (-1.5, 0.0, "white"),
    (-1.2, 1.5, "air"),
    (0.0, 0.0, "red"),
    (0.2, -1.5, "white"),
    (1.5, 0.0, "mirror"),
    (1.2, 1.5, "black"),
    (-2.5, -1.5, "red"),
    (2.5, -1.5, "white"),
];

fn ball((x, z, material): (f32, f32, &str)) -> String {
    format!("[[sphere]]\ncenter = [{x}, -0.4, {z}]\nradius = 0.6\nmaterial = '{material}'\n")
}

/// A folder with the rich scene, one of seven white balls, and a picture without an end.
fn folder() -> Folder {
    let balls = BALLS.map(ball).concat();
    let tiny = BALLS.map(|(x, z, _)| ball((x, z, "white")))[..7].concat();
    let folder = Folder::with(&[
        ("rich.toml", &scene(&format!("{RICH}{balls}"))),
        ("tiny.toml", &scene(&tiny)),
        ("walled.toml", &scene(WALLED)),
    ]);
    let picture = Image::from_srgb8(1, 1, &[0, 10, 118]);
    picture.save(&folder.path("whole.png")).expect("a picture is written");
    let bytes = std::fs::read(folder.path("whole.png")).expect("and read");
    // The eight bytes of a PNG file, its header of 25, and the beginning of the texels.
    folder.write("broken.png", &bytes[..45]);
    folder
}

/// What one render did, and the hash of its picture.
#[derive(Debug)]
struct Work {
    rays: BTreeMap<String, u64>,
    volume_tests: u64,
    primitive_tests: u64,
    skipped: BTreeMap<String, u64>,
    picture: u64,
}

impl Work {
    fn of(folder: &Folder, stage: &str, arguments: &str) -> Self {
        let line = format!("{arguments} --samples 16 --quiet --stats - -o a.exr");
        let output = folder.run(stage, &line, 0);
        let all: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        let group = |name: &str| -> BTreeMap<String, u64> {
            let group = all[name].as_object().expect(name).iter();
            group.map(|(key, value)| (key.clone(), value.as_u64().expect(key))).collect()
        };
        let picture = Image::load_exr(&folder.path("a.exr")).expect("the picture is read");
        let tests = group("tests");
        Self {
            rays: group("rays"),
            volume_tests: tests["volume"],
            primitive_tests: tests["primitive"],
            skipped: group("skipped"),
            picture: picture.hash(),
        }
    }

    fn tests(&self) -> u64 {
        self.volume_tests + self.primitive_tests
    }
}

/// Renders with and without skipping `key`. The picture has to be the same, and there has to be
/// something to skip, all of it or nothing.
fn compare(folder: &Folder, stage: &str, scene: &str, key: &str) -> [Work; 2] {
    let with = Work::of(folder, stage, scene);
    let without = Work::of(folder, stage, &format!("{scene} --no-skip {key}"));
    assert_eq!(with.picture, without.picture, "{stage}, {key}: the picture with and without");
    assert!(with.skipped[key] > 10, "{stage}, {key}: {} skipped", with.skipped[key]);
    assert_eq!(without.skipped[key], 0, "{stage}, {key}: skipped without skipping");
    [with, without]
}

/// As many rays of this kind more, and none of any other.
fn assert_more_rays(stage: &str, [with, without]: &[Work; 2], kind: &str, more: u64) {
    for (ray, &count) in &with.rays {
        let expected = if ray == kind { count + more } else { count };
        assert_eq!(without.rays[ray], expected, "{stage}: rays of the kind {ray}, of {count}");
    }
    let [with, without] = [with.tests(), without.tests()];
    assert!(with < without, "{stage}: {with} tests with the skip, {without} without");
}

#[test]
fn shadow_rays_that_are_not_skipped_are_cast() {
    let folder = folder();
    let lit = ["shadow_rays_facing_away", "shadow_rays_nothing_to_reflect"];
    let stages = ["blinn-phong", "mirror-refraction", "bv-tree", "light-sampling"];
    let pairs = stages.iter().flat_map(|&stage| lit.map(|key| (stage, key)));
    for (stage, key) in pairs.chain([("light-sampling", "shadow_rays_delta")]) {
        let both = compare(&folder, stage, "rich.toml", key);
        assert_more_rays(stage, &both, "shadow", both[0].skipped[key]);
    }
}

/// Where the surface is black, the path goes on: by one ray, by as many as the stage branches into,
/// or by one and the question for a lamp, which is skipped in its turn.
#[test]
fn paths_that_are_not_ended_by_black_go_on() {
    let (folder, key) = (folder(), "paths_ended_by_black");
    for (stage, rays) in [("rendering-equation", 2), ("path-tracing", 1), ("light-sampling", 1)] {
        let both = compare(&folder, stage, "rich.toml", key);
        assert_more_rays(stage, &both, "scatter", rays * both[0].skipped[key]);
        let [asked, more] = both.each_ref().map(|work| {
            work.skipped["shadow_rays_facing_away"] + work.skipped["shadow_rays_nothing_to_reflect"]
        });
        let questions = if stage == "light-sampling" { both[0].skipped[key] } else { 0 };
        assert_eq!(more, asked + questions, "{stage}: lamps that were asked for nothing");
    }
}

#[test]
fn shadow_rays_that_do_not_stop_at_the_first_hit_test_more() {
    let folder = folder();
    for stage in ["ray-casting", "blinn-phong", "mirror-refraction", "bv-tree", "light-sampling"] {
        let both = compare(&folder, stage, "rich.toml", "any_hit_exits");
        assert_more_rays(stage, &both, "shadow", 0);
    }
}

/// These skips save calculations that nothing else counts: all rays, tests and other skips stay.
#[test]
fn what_is_calculated_for_nothing_changes_no_other_count() {
    let folder = folder();
    let every = ["surface_points", "textures_not_loaded"];
    let shading = ["blinn-phong"].into_iter().chain(REFRACTING);
    let pairs = shading.clone().chain(["ray-casting"]).map(|stage| (stage, every[0]));
    let pairs = pairs.chain(shading.map(|stage| (stage, "texture_coordinates")));
    let pairs = pairs.chain(REFRACTING.map(|stage| (stage, "fresnel_splits")));
    for (stage, key) in pairs {
        let [with, mut without] = compare(&folder, stage, "rich.toml", key);
        without.skipped.insert(key.to_owned(), with.skipped[key]);
        assert_eq!(with.skipped, without.skipped, "{stage}, {key}: what else is skipped");
        let work = [&with, &without].map(|work| (&work.rays, work.tests()));
        assert_eq!(work[0], work[1], "{stage}, {key}: rays and tests");
    }
}

/// Nothing is found where these do not look.
#[test]
fn triangles_that_cannot_be_met_are_tested_for_nothing() {
    let folder = folder();
    let own = WITH_TREE.map(|stage| (stage, "rich.toml", "own_triangles"));
    let walls = ("light-sampling", "walled.toml", "walls_left_out");
    for (stage, scene, key) in own.into_iter().chain([walls]) {
        let [with, mut without] = compare(&folder, stage, scene, key);
        without.skipped.insert(key.to_owned(), with.skipped[key]);
        for other in ["own_triangles", "surface_points", "any_hit_exits"] {
            // What is met first, and how often, depends on where one looks.
            without.skipped.insert(other.to_owned(), with.skipped[other]);
        }
        assert_eq!(with.skipped, without.skipped, "{stage}, {key}: what else is skipped");
        assert_eq!(with.rays, without.rays, "{stage}, {key}: rays");
        let [few, many] = [with.tests(), without.tests()];
        assert!(few < many, "{stage}, {key}: {few} tests, {many} without the skip");
    }
}

/// What is wrong with a picture that nobody needs is found out only by who loads it.
#[test]
fn a_picture_that_nothing_wears_is_not_loaded() {
    let folder = folder();
    for stage in ["ray-casting", "blinn-phong"].into_iter().chain(REFRACTING) {
        let skipped = Work::of(&folder, stage, "rich.toml").skipped["textures_not_loaded"];
        assert_eq!(skipped, 1, "{stage}: pictures not loaded");
        let line = "rich.toml --no-skip textures_not_loaded";
        let complaint = folder.complaint(stage, line, 1);
        assert!(complaint.contains("broken.png"), "{stage}: {complaint}");
    }
    folder.write("broken.png", &std::fs::read(folder.path("whole.png")).expect("a picture"));
    for stage in ["ray-casting", "blinn-phong"].into_iter().chain(REFRACTING) {
        let with = Work::of(&folder, stage, "rich.toml");
        let without = Work::of(&folder, stage, "rich.toml --no-skip textures_not_loaded");
        assert_eq!(without.skipped["textures_not_loaded"], 0, "{stage}: pictures not loaded");
        assert_eq!(with.picture, without.picture, "{stage}: the picture");
    }
}

/// In a tree the same hits are found, with tests of volumes in addition.
#[test]
fn a_tree_over_few_primitives_finds_the_same() {
    let folder = folder();
    for stage in WITH_TREE {
        let with = Work::of(&folder, stage, "tiny.toml");
        let without = Work::of(&folder, stage, "tiny.toml --no-skip trees_not_built");
        assert_eq!(with.picture, without.picture, "{stage}: the picture");
        let skipped = [&with, &without].map(|work| work.skipped["trees_not_built"]);
        assert_eq!(skipped, [1, 0], "{stage}: trees not built");
        assert_eq!(with.rays, without.rays, "{stage}: rays");
        let [none, some] = [with.volume_tests, without.volume_tests];
        assert!(none == 0 && some > 0, "{stage}: {none} tests of volumes, {some} with a tree");
    }
}

/// What has an option of its own to be switched off.
const OTHERWISE: [&str; 3] =
    ["branches_below_threshold", "paths_ended_by_roulette", "paths_ended_by_depth"];

/// Nothing is skipped but what has an option of its own, and the picture is still the same.
#[test]
fn all_skips_at_once_change_no_picture() {
    let folder = folder();
    folder.write("broken.png", &std::fs::read(folder.path("whole.png")).expect("a picture"));
    for stage in ["ray-casting", "blinn-phong"].into_iter().chain(REFRACTING) {
        for scene in ["rich.toml", "tiny.toml"] {
            let with = Work::of(&folder, stage, scene);
            let without = Work::of(&folder, stage, &format!("{scene} --no-skip all"));
            assert_eq!(with.picture, without.picture, "{stage} {scene}: the picture");
            for (key, count) in without.skipped {
                let expected = if OTHERWISE.contains(&&*key) { with.skipped[&key] } else { 0 };
                assert_eq!(count, expected, "{stage} {scene}: {key}");
            }
        }
    }
}

#[test]
fn what_has_an_option_of_its_own_is_refused_with_its_name() {
    let folder = folder();
    for (key, option) in [
        ("branches_below_threshold", "--cutoff 0"),
        ("paths_ended_by_roulette", "--roulette off"),
        ("paths_ended_by_depth", "--depth"),
        ("shadow_rays", "`shadow_rays_delta`"),
    ] {
        let complaint = folder.complaint("light-sampling", &format!("--no-skip {key}"), 2);
        assert!(complaint.contains(option), "{key}: {complaint}");
    }
}
