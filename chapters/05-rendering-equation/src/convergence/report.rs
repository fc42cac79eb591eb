//! The study as text: a table for each density, and one plot.

use std::fmt::Write;

use super::terminal_plot::plot;
use super::{Course, Sampling, Study};

/// What the study of these densities finds.
pub(super) fn report(study: &Study, densities: &[Sampling]) -> String {
    let exact = study.integrand.integral();
    let mut text = format!("{} = {exact:.8}\n", study.integrand.formula());
    let courses: Vec<Course> = densities.iter().map(|&density| study.course(density)).collect();
    for course in &courses {
        text.push_str(&table(study, course));
    }
    text + &plot(&courses, study.runs, study.rounding())
}

// Writing to a String cannot fail, so the results are dropped.
fn table(study: &Study, course: &Course) -> String {
    let exact = study.integrand.integral();
    let mut text = format!("\n{}\n", course.sampling.heading());
    let _ = writeln!(
        text,
        "{:>12} {:>12} {:>12} {:>15} {:>15}",
        "N",
        "estimate",
        "error",
        "standard error",
        if study.has_infinite_variance(course.sampling) { "median error" } else { "rms error" }
    );
    for row in &course.rows {
        let (estimate, typical) = (&row.estimate, row.typical_error);
        let (error, standard) = (estimate.mean - exact, estimate.standard_error());
        let (n, mean) = (estimate.samples, estimate.mean);
        let _ = writeln!(
            text,
            "{n:>12} {mean:>12.7} {error:>+12.2e} {standard:>15.2e} {typical:>15.2e}"
        );
    }
    text + &verdict(study, course)
}

/// The slope beside the predicted one, and what is wrong with the density, if something is.
fn verdict(study: &Study, course: &Course) -> String {
    let Some(slope) = course.slope else {
        return "no slope: f/p is the same for every sample, and nothing is left but rounding\n"
            .to_owned();
    };
    let mut text = format!(
        "slope of log error against log N: {:.3} ± {:.3}, expected {:.3} for large N\n",
        slope.exponent,
        slope.standard_error,
        study.expected_slope(course.sampling)
    );
    if study.has_infinite_variance(course.sampling) {
        let m = course.sampling.power_at_horizon();
        let a = study.integrand.power_at_horizon().unwrap_or_default();
        let _ = writeln!(
            text,
            "The variance is infinite: near the horizon f²/p grows as 1/cos^{} θ, and the integral \
             of that does not exist.\nA few samples in places where p is too small decide, and the \
             standard error knows only of those that came.",
            m - 2 * a
        );
    }
    text
}
