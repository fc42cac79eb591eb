//! Nothing whose order depends on threads or on a hash: floats are added in the order of pixels and
//! samples, and no map is gone through whose order changes from run to run.
//!
//! Two rules, stricter than need be because they are simple: a map or a set with a hash is not even
//! named, since a sorted one does; and where a file divides work among threads, whatever it adds up or
//! reduces is on a list.

use crate::{Exception, check};

/// Adds up, perhaps in any order.
const ADDS: [&str; 5] = [".sum(", ".sum::<", ".product(", ".reduce(", ".reduce_with("];

/// Has an order of its own in every run.
const HASHED: [&str; 2] = ["HashMap", "HashSet"];

/// What in a line of `code` may depend on an order that nobody chose.
fn unordered(code: &str, line: &str) -> Vec<String> {
    let is_divided = code.contains("rayon");
    let adds = ADDS.iter().filter(|_| is_divided);
    adds.chain(&HASHED).filter(|word| line.contains(**word)).map(|word| (*word).into()).collect()
}

#[test]
fn nothing_depends_on_the_order_of_threads_or_of_a_hash() {
    check(
        |_| true,
        unordered,
        &[
            Exception {
                file: "00-workbench/src/film.rs",
                line: "u64::from(sum.taken",
                reason: "whole numbers are counted",
            },
            Exception {
                file: "00-workbench/src/film.rs",
                line: "u64::from(average.saturating_sub(sum.taken",
                reason: "whole numbers are counted",
            },
            Exception {
                file: "00-workbench/src/need.rs",
                line: "u64::from(share(i, unit))).sum::<u64>()",
                reason: "whole numbers are counted",
            },
            Exception {
                file: "00-workbench/src/probe.rs",
                line: "load(Ordering::Relaxed)).sum()",
                reason: "whole numbers are counted",
            },
            Exception {
                file: "04-bv-tree/src/builder.rs",
                line: "part.count).sum()",
                reason: "whole numbers are counted",
            },
            Exception {
                file: "04-bv-tree/src/split.rs",
                line: "chunks.reduce(",
                reason: "what is reduced are minima, maxima and whole numbers",
            },
        ],
    );
}

#[test]
fn a_planted_order_is_found() {
    let threads = "use rayon::iter::ParallelIterator;\n";
    for line in [
        "let mean = xs.par_iter().sum::<f32>() / n;",
        "xs.par_iter().copied().reduce(|| 0.0, |a, b| a + b)",
        "    .sum()",
    ] {
        assert_eq!(unordered(threads, line).len(), 1, "in `{line}`, among threads");
        assert!(unordered("", line).is_empty(), "in `{line}`, on one thread");
    }
    for line in ["for (k, v) in HashMap::from(pairs) {", "use std::collections::HashSet;"] {
        assert_eq!(unordered("", line).len(), 1, "in `{line}`");
    }
    for line in ["let sum = a + b;", "BTreeMap::new()", "self.summary()"] {
        assert!(unordered(threads, line).is_empty(), "in `{line}`");
    }
}
