//! What each stage does and skips, held by a snapshot.
//!
//! After a change that is meant to alter the counts, look at the difference and accept it with
//! `INSTA_UPDATE=always cargo test -p time-vs-error`.

use acceptance::binary;
use time_vs_error::counts::{count_all, text, weigh_all};
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

/// Volumes change no bit of the picture, nor does code for what is not there; the cutoff changes no
/// more than one step of 8 bits; and none of the skips makes more tests than it saves.
#[test]
fn a_skip_saves_tests_and_not_the_picture() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let worths = weigh_all(&stages(&folder), [32, 32], 0).expect("every stage draws");
    for worth in worths {
        let skip = worth.skip;
        let [with, without] =
            worth.counts.each_ref().map(|c| c.tests("volume") + c.tests("primitive"));
        if skip.without.0 == "--for-any-scene" {
            assert_eq!(with, without, "{skip:?}: tests of two pieces of code for the same");
        } else {
            assert!(with < without, "{skip:?}: {with} tests with the skip, {without} without");
        }
        match skip.without.0 {
            "--volume none" | "--for-any-scene" => {
                assert_eq!(worth.difference, None, "{skip:?}: the picture differs");
            }
            "--cutoff 0" => {
                let steps = worth.difference.map_or(0, |(_, byte)| byte);
                assert!(steps <= 1, "{skip:?}: {steps} steps of 8 bits");
            }
            // Roulette draws other random numbers: its pictures are other samples.
            _ => assert!(worth.difference.is_some(), "{skip:?}: the very same picture"),
        }
    }
}
