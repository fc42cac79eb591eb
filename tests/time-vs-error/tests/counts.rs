//! What each stage does and skips, held by a snapshot.
//!
//! After a change that is meant to alter the counts, look at the difference and accept it with
//! `INSTA_UPDATE=always cargo test -p time-vs-error`.

use acceptance::binary;
use time_vs_error::counts::{count_all, text};
use time_vs_error::skips::weigh_all;
use time_vs_error::stages::{STAGES, Stages};

fn stages(folder: &tempfile::TempDir) -> Stages {
    let binaries = STAGES.iter().map(|&stage| (stage.to_owned(), binary(stage)));
    Stages::at(binaries.collect(), folder.path().to_owned()).expect("the folder is there")
}

#[test]
fn every_stage_does_and_skips_what_it_did() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let counted = count_all(&stages(&folder), [32, 32]).expect("every stage draws every scene");
    insta::assert_snapshot!(text(&counted));
}

/// The cutoff changes no more than one step of 8 bits, roulette draws other random numbers, and no
/// other skip changes a bit of the picture. What is skipped is counted with the skip and not without,
/// and no skip makes more tests than it saves, but that of a tree.
#[test]
fn a_skip_saves_work_and_not_the_picture() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let worths = weigh_all(&stages(&folder), [32, 32], 0).expect("every stage draws");
    for worth in worths {
        let skip = worth.skip;
        let [with, without] =
            worth.counts.each_ref().map(|c| c.tests("volume") + c.tests("primitive"));
        match skip.without.0 {
            "--no-skip trees_not_built" => {}
            _ if SAVES_NO_TEST.contains(&skip.without.0) => {
                assert_eq!(with, without, "{skip:?}: tests with and without");
            }
            _ => assert!(with < without, "{skip:?}: {with} tests with the skip, {without} without"),
        }
        match skip.without.0 {
            "--cutoff 0" => {
                let steps = worth.difference.map_or(0, |(_, byte)| byte);
                assert!(steps <= 1, "{skip:?}: {steps} steps of 8 bits");
            }
            // Its pictures are other samples.
            "--depth 16 --roulette off" => {
                assert!(worth.difference.is_some(), "{skip:?}: the very same picture");
            }
            _ => assert_eq!(worth.difference, None, "{skip:?}: the picture differs"),
        }
        if let Some(key) = skip.key() {
            let [with, without] = worth.counts.each_ref().map(|counts| counts.skipped[key]);
            assert!(with > 0 && without == 0, "{skip:?}: {with} skipped, {without} without");
        }
    }
}

/// Options that switch off skips of calculations, which are no tests.
const SAVES_NO_TEST: [&str; 5] = [
    "--for-any-scene",
    "--no-skip fresnel_splits",
    "--no-skip surface_points",
    "--no-skip texture_coordinates",
    "--no-skip textures_not_loaded",
];
