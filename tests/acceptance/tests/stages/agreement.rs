//! The same picture, bit for bit, whatever may not change it.

use acceptance::{Folder, STAGES};
use workbench::Image;

/// The hash of the floats of a picture.
fn hash(folder: &Folder, stage: &str, arguments: &str) -> u64 {
    folder.run(stage, &format!("{arguments} --quiet -o a.exr"), 0);
    Image::load_exr(&folder.path("a.exr")).expect("the picture is read").hash()
}

#[test]
fn threads_never_change_the_picture_and_the_seed_always_does() {
    let folder = Folder::with(&[]);
    for stage in STAGES {
        let picture = |option: &str| {
            hash(&folder, stage, &format!("whitted --size 48x32 --samples 2 {option}"))
        };
        let one = picture("--threads 1");
        assert_eq!([picture("--threads 2"), picture("--threads 5")], [one; 2], "{stage}: threads");
        assert_ne!(picture("--seed 1"), one, "{stage}: another seed");
    }
}

/// accuracy V14: neither what encloses the nodes of a tree nor how it is divided shows in the
/// picture.
#[test]
fn volumes_and_builders_never_change_the_picture() {
    let folder = Folder::with(&[]);
    let bytes = |option: &str| {
        let arguments = "whitted-teapot --size 40x25 --samples 1 --quiet -o a.exr";
        folder.run("bv-tree", &format!("{arguments} {option}"), 0);
        std::fs::read(folder.path("a.exr")).expect("the picture is read")
    };
    let expected = bytes("--volume none");
    for volume in ["aabb", "obb", "kdop6", "kdop14", "kdop18", "kdop26"] {
        for builder in ["median", "sah"] {
            let option = format!("--volume {volume} --builder {builder}");
            assert!(bytes(&option) == expected, "{option}: the bytes differ from --volume none");
        }
    }
}

/// accuracy V14: the tree's stage is the recursion's stage, over a tree.
#[test]
fn the_tree_draws_what_the_recursion_draws() {
    let folder = Folder::with(&[]);
    for scene in ["whitted", "nested-glass", "cornell-spheres", "touching-glass"] {
        let arguments = format!("{scene} --size 40x30 --samples 2");
        let [plain, tree] =
            ["mirror-refraction", "bv-tree"].map(|stage| hash(&folder, stage, &arguments));
        assert_eq!(plain, tree, "{scene}: without and with a tree");
    }
}

/// What the code leaves out is what the scene has none of: one scene for each of the three kinds of
/// code, and for each thing that may be missing.
#[test]
fn code_for_any_scene_draws_the_same_picture() {
    let folder = Folder::with(&[]);
    for stage in ["rendering-equation", "path-tracing", "light-sampling"] {
        for scene in ["cornell-box", "veach-plates", "two-mirrors", "whitted", "cornell-spheres"] {
            let arguments = format!("{scene} --size 24x24 --samples 2 --depth 4");
            let [chosen, any] = ["", "--for-any-scene"]
                .map(|option| hash(&folder, stage, &format!("{arguments} {option}")));
            assert_eq!(chosen, any, "{stage}, {scene}: the chosen code and that for any scene");
        }
    }
}

/// Where nothing shines back, the recursion is the shader of the chapter before.
#[test]
fn a_diffuse_scene_looks_the_same_in_chapters_2_to_4() {
    let folder = Folder::with(&[]);
    let hashes = ["blinn-phong", "mirror-refraction", "bv-tree"]
        .map(|stage| hash(&folder, stage, "cornell-box --size 40x40 --samples 2"));
    assert_eq!(hashes, [hashes[0]; 3], "the Cornell box in chapters 2, 3 and 4");
}
