//! Errors over N as characters, both axes logarithmic.

use ray_casting::math::{exp2_f64, log2_f64};

use super::Course;

const WIDTH: usize = 61;
const HEIGHT: usize = 17;

/// The typical errors of all courses that are above `rounding`, in one frame; empty if none is.
pub(super) fn plot(courses: &[Course], runs: u64, rounding: f64) -> String {
    let point = |course: &Course, i: usize| {
        let row = &course.rows[i];
        [row.estimate.samples as f64, row.typical_error].map(|x| log2_f64(x.max(f64::MIN_POSITIVE)))
    };
    let points: Vec<(char, [f64; 2])> = courses
        .iter()
        .flat_map(|course| (0..course.rows.len()).map(move |i| (course, i)))
        .map(|(course, i)| (course.sampling.mark(), point(course, i)))
        .filter(|(_, [_, error])| *error > log2_f64(rounding))
        .collect();
    if points.is_empty() {
        return String::new();
    }
    let range = |axis: usize| {
        let values = points.iter().map(|(_, point)| point[axis]);
        let (low, high) = values.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        (low, (high - low).max(1e-9))
    };
    let ((left, width), (bottom, height)) = (range(0), range(1));

    let mut cells = vec![[' '; WIDTH]; HEIGHT];
    for (mark, [x, y]) in points {
        let column = ((x - left) / width * (WIDTH - 1) as f64).round() as usize;
        let row = ((bottom + height - y) / height * (HEIGHT - 1) as f64).round() as usize;
        let cell = &mut cells[row][column];
        *cell = if *cell == ' ' || *cell == mark { mark } else { '*' };
    }

    let names: Vec<String> = courses
        .iter()
        .map(|course| format!("{} {}", course.sampling.mark(), course.sampling.heading()))
        .collect();
    let mut text = format!("\nerror over {runs} runs (rms or median) against N\n");
    for (i, cells) in cells.iter().enumerate() {
        let exponent = bottom + height * (1.0 - i as f64 / (HEIGHT - 1) as f64);
        let label = if i % 4 == 0 { format!("{:.1e}", exp2_f64(exponent)) } else { String::new() };
        let line: String = cells.iter().collect();
        text += &format!("{label:>8} │{}\n", line.trim_end());
    }
    let n = |x: f64| format!("{:.0}", exp2_f64(x));
    text += &format!("         └{}\n", "─".repeat(WIDTH));
    text += &format!("          {:<30}{:>31}\n", n(left), n(left + width));
    text += &format!("  {}; * several\n", names.join("; "));
    text
}
