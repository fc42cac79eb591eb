//! Runs a case: in chunks, on all cores, with the same result for any number of them.

use std::fs;
use std::path::PathBuf;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::case::{Case, Check};
use crate::random::Random;
use crate::trial::{Found, Trial};

/// Rays of a case in `cargo test`, if a ray is cheap.
pub const QUICK: u64 = 1_000_000;

/// Rays of one chunk: enough to pay for what a case sets up, few enough to keep all cores busy.
const CHUNK: u64 = 1 << 16;

/// Runs `case` with `rays` plain rays, or as many dearer ones as take the time of those. `None` if
/// it is not tried here.
///
/// `done` is told of every chunk, how many plain rays it was worth.
#[must_use]
pub fn run(case: &Case, rays: u64, seed: u64, done: &(impl Fn(u64) + Sync)) -> Option<Found> {
    match case.check {
        Check::Exact(check) => {
            let mut trial = Trial::new(1, Random::new(seed, 0));
            check(&mut trial);
            done(rays);
            Some(trial.finish())
        }
        Check::Random { check, cost } => {
            let rays = (rays / cost).max(1);
            let chunk = (CHUNK / cost).max(1);
            let seed = seed ^ hash(case.id);
            let one = |i: u64| {
                let size = chunk.min(rays - i * chunk);
                let mut trial = Trial::new(size, Random::new(seed, i));
                check(&mut trial);
                done(size * cost);
                trial.finish()
            };
            // Chunks keep their order, so "the first failure" does not depend on the cores.
            let chunks = (0..rays.div_ceil(chunk)).into_par_iter();
            Some(chunks.map(one).reduce(Found::default, Found::and))
        }
        Check::Elsewhere { .. } | Check::Absent { .. } => None,
    }
}

/// Asserts that one case of a table holds: what [`catalogue!`](crate::catalogue!) makes tests of.
///
/// # Panics
///
/// If it does not hold, or if the test that shows it is not where the table says.
pub fn assert(cases: &[Case], id: &str) {
    let case = cases.iter().find(|case| case.id == id);
    let case = case.expect("the macro makes the table and the tests of the same rows");
    if let Some(found) = run(case, QUICK, statistics::seed(0), &|_| {}) {
        assert!(
            found.holds(),
            "{id}: {} of {} failed, worst error {:.3e}; the first:\n{}",
            found.failures,
            found.tried,
            found.worst,
            found.first.as_deref().unwrap_or("nothing was tried")
        );
    }
    if let Check::Elsewhere { file, test } = case.check {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
        let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{id}: {file}: {e}"));
        let has = text.contains(&format!("fn {test}()"));
        assert!(has, "{id}: {file} has no test `{test}`");
        let cites = text.lines().any(|line| line.trim_start().starts_with("//") && cites(line, id));
        assert!(cites, "{id}: no comment of {file} cites it");
    }
}

/// Whether a line names `id` as a word.
fn cites(line: &str, id: &str) -> bool {
    line.split(|c: char| !c.is_alphanumeric()).any(|word| word == id)
}

/// FNV-1a: another seed for each case.
fn hash(text: &str) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, step)
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::case::{Case, Check};
    use crate::trial::Trial;

    fn counts(trial: &mut Trial) {
        for _ in 0..trial.rays {
            let u = trial.random.unit();
            trial.within(u, 0.9, || format!("{u}"));
        }
    }

    fn case(cost: u64) -> Case {
        Case { id: "X1", fact: "", check: Check::Random { check: counts, cost } }
    }

    #[test]
    fn every_ray_is_tried_once_and_a_dear_one_counts_for_several() {
        for (rays, cost, tried) in [(1, 1, 1), (200_000, 1, 200_000), (200_000, 1_000, 200)] {
            let found = run(&case(cost), rays, 0, &|_| {}).expect("the case is tried");
            assert_eq!(found.tried, tried, "{rays} rays of cost {cost}");
        }
    }

    #[test]
    fn what_is_found_does_not_depend_on_the_threads() {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("threads start").install(|| run(&case(1), 1_000_000, 0, &|_| {}))
        };
        let one = on(1).expect("the case is tried");
        assert!(one.failures > 0 && one.first.is_some(), "{one:?}");
        assert_eq!(Some(one), on(3), "one thread against three");
    }
}
