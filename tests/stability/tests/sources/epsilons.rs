//! No constant that is meant to be "small enough": what is small enough depends on the scene, so each
//! bound is derived from γ(n) and the numbers in play.

use crate::code::{code, is_name, lines};
use crate::{Exception, check};

/// What is not zero and smaller is taken for an epsilon.
const SMALL: f64 = 0.02;

/// Names of the standard library for small numbers.
const NAMES: [&str; 2] = ["EPSILON", "MIN_POSITIVE"];

/// The float literals of a line of code that are between 0 and [`SMALL`], and the names of such.
fn small_numbers(line: &str) -> Vec<String> {
    let small = |literal: &String| value(literal).is_some_and(|x| 0.0 < x && x < SMALL);
    let literals = words(line).filter(small);
    let names = words(line).filter(|word| NAMES.contains(&word.as_str()));
    literals.chain(names).collect()
}

/// Names and numbers.
fn words(line: &str) -> impl Iterator<Item = String> {
    let chars: Vec<char> = line.chars().collect();
    let mut i = 0;
    std::iter::from_fn(move || {
        while i < chars.len() && !is_name(chars[i]) {
            i += 1;
        }
        let start = i;
        let is_number = i < chars.len() && chars[i].is_ascii_digit();
        let is_field = start > 0 && chars[start - 1] == '.';
        while i < chars.len() && (is_name(chars[i]) || is_number && !is_field && goes_on(&chars, i))
        {
            i += 1;
        }
        (i > start).then(|| chars[start..i].iter().collect())
    })
}

/// Whether the point or the sign at `i` belongs to the number before it.
fn goes_on(chars: &[char], i: usize) -> bool {
    let next = chars.get(i + 1).copied().unwrap_or(' ');
    match chars[i] {
        // Neither a range, nor a method of a whole number.
        '.' => next.is_ascii_digit() || !(is_name(next) || next == '.'),
        '-' | '+' => matches!(chars[i - 1], 'e' | 'E') && next.is_ascii_digit(),
        _ => false,
    }
}

/// What a literal stands for, if it is a decimal one.
fn value(word: &str) -> Option<f64> {
    let is_decimal = word.starts_with(|c: char| c.is_ascii_digit()) && !word.starts_with("0x");
    let plain = word.replace('_', "");
    let plain = plain.trim_end_matches("f32").trim_end_matches("f64");
    if is_decimal { plain.parse().ok() } else { None }
}

#[test]
fn there_is_no_magic_epsilon() {
    check(
        // The workbench does not know what a ray is.
        |file| !file.starts_with("00-workbench/"),
        |_, line| small_numbers(line),
        &[
            Exception {
                file: "01-ray-casting/src/math.rs",
                line: "const UNIT_ROUNDOFF",
                reason: "it is u, of which all bounds are made",
            },
            Exception {
                file: "01-ray-casting/src/triangle.rs",
                line: "const DOUBLE",
                reason: "it counts roundings of double precision",
            },
            Exception {
                file: "01-ray-casting/src/surface_point.rs",
                line: "const DOUBLE_ROUNDING",
                reason: "it counts roundings of double precision",
            },
            Exception {
                file: "04-bv-tree/src/plane.rs",
                line: "const DOUBLE",
                reason: "it counts roundings of double precision",
            },
            Exception {
                file: "05-rendering-equation/src/convergence.rs",
                line: "1e-6 * self.integrand.integral()",
                reason: "no ray meets it: an error below that is one of rounding, and left out of a plot",
            },
            Exception {
                file: "05-rendering-equation/src/convergence/terminal_plot.rs",
                line: "f64::MIN_POSITIVE",
                reason: "no ray meets it: a plot of logarithms",
            },
            Exception {
                file: "05-rendering-equation/src/convergence/terminal_plot.rs",
                line: "(high - low).max(1e-9)",
                reason: "no ray meets it: a plot of at least some height",
            },
        ],
    );
}

#[test]
fn a_planted_epsilon_is_found() {
    for (line, found) in [
        ("if t > 1e-4 {", "1e-4"),
        ("let t_min = 0.001;", "0.001"),
        ("origin + 1.0e-3_f32 * n", "1.0e-3_f32"),
        ("-0.01,", "0.01"),
        ("x.max(1E-8)", "1E-8"),
        ("0.000_1f32..1.0", "0.000_1f32"),
        ("let t = hit.0 - 0.0001;", "0.0001"),
        ("origin + f32::EPSILON * n", "EPSILON"),
        ("f64::MIN_POSITIVE", "MIN_POSITIVE"),
    ] {
        assert_eq!(small_numbers(line), [found], "in `{line}`");
    }
}

#[test]
fn what_is_no_epsilon_is_not_found() {
    for line in [
        "0.5 * x + 0.02",
        "for i in 0..10 {",
        "pair.0.1",
        "let x = 1e3 - 2.0e+2;",
        "0.0 + 0. + 0e0",
        "f32::from_bits(0x0000_0001)",
        "let e4 = a1e-4;",
        "1.0 / 1024.0 - 1.",
        "2.max(3)",
    ] {
        assert!(small_numbers(line).is_empty(), "{:?} in `{line}`", small_numbers(line));
    }
    let text = "// 1e-4\nlet s = \"0.001\";\n#[cfg(test)]\nmod tests { const E: f32 = 1e-6; }\n";
    let code = code(text);
    let found: Vec<String> = lines(&code).flat_map(|(_, line)| small_numbers(line)).collect();
    assert!(found.is_empty(), "{found:?} in a comment, a string or a test");
}
