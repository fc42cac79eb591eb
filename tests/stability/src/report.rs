//! The table of the long tier.

use std::fmt::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use std::{fs, io};

use indicatif::{ProgressBar, ProgressStyle};
use statistics::grouped;

use crate::case::{Case, Check};
use crate::catalogue;
use crate::laboratory::run;
use crate::trial::Found;

/// What the command line asks for.
#[derive(Clone, Debug)]
pub struct Options {
    /// Plain rays a case.
    pub rays: u64,
    /// Ids, components, and parts of facts; none for all.
    pub only: Vec<String>,
    /// Of the random inputs.
    pub seed: u64,
    /// Where to write the table as Markdown, if anywhere.
    pub write: Option<PathBuf>,
}

/// One line of the table.
struct Row {
    case: Case,
    found: Found,
    time: Duration,
}

/// Runs the chosen cases, prints them one by one, and says whether all of them hold.
///
/// # Errors
///
/// If no case fits, or the file cannot be written.
pub fn report(options: &Options) -> io::Result<bool> {
    let chosen = chosen(&options.only);
    if chosen.is_empty() {
        return Err(io::Error::other(format!("no case that is tried fits {:?}", options.only)));
    }
    let bar = bar(options.rays * chosen.len() as u64)?;
    println!("{:5} {:>14} {:>9} {:>10} {:>8}  fact", "case", "tried", "failed", "worst", "seconds");
    let mut rows = Vec::new();
    for case in chosen {
        bar.set_message(case.id);
        let start = Instant::now();
        let Some(found) = run(&case, options.rays, options.seed, &|n| bar.inc(n)) else { continue };
        let row = Row { case, found, time: start.elapsed() };
        bar.suspend(|| print(&row));
        rows.push(row);
    }
    bar.finish_and_clear();
    if let Some(file) = &options.write {
        fs::write(file, markdown(&rows, options))?;
    }
    Ok(rows.iter().all(|row| row.found.holds()))
}

/// The cases that are tried here, and fit one of `only`.
fn chosen(only: &[String]) -> Vec<Case> {
    let all = catalogue().into_iter().flat_map(|(component, cases)| {
        let fits = move |case: &Case| {
            let fit =
                |text: &String| case.id == text || component == text || case.fact.contains(text);
            only.is_empty() || only.iter().any(fit)
        };
        cases.iter().copied().filter(fits)
    });
    all.filter(|case| matches!(case.check, Check::Exact(_) | Check::Random { .. })).collect()
}

fn bar(length: u64) -> io::Result<ProgressBar> {
    let style = ProgressStyle::with_template("{wide_bar} {msg}, {percent} %, {eta} left");
    let style = style.map_err(io::Error::other)?;
    Ok(ProgressBar::new(length).with_style(style))
}

fn print(row: &Row) {
    let Found { tried, failures, worst, first } = &row.found;
    let (id, fact, seconds) = (row.case.id, row.case.fact, row.time.as_secs_f64());
    println!("{id:5} {tried:14} {failures:9} {worst:10.3e} {seconds:8.1}  {fact}");
    if let Some(first) = first {
        println!("      the first failure: {first}");
    }
}

/// The same as a table of the book, without the seconds, which no other run would repeat.
fn markdown(rows: &[Row], options: &Options) -> String {
    let mut text = String::from("| case | tried | failed | largest error | fact |\n");
    text.push_str("|---|---:|---:|---:|---|\n");
    for Row { case, found, .. } in rows {
        let fact = case.fact.replace('_', " ");
        // A case that measures nothing has no error.
        let worst = if found.worst == 0.0 { String::new() } else { format!("{:.3}", found.worst) };
        let (id, tried, failed) = (case.id, grouped(found.tried), grouped(found.failures));
        writeln!(text, "| {id} | {tried} | {failed} | {worst} | {fact} |")
            .expect("a string takes everything");
    }
    let (rays, seed) = (short(options.rays), options.seed);
    let only = options.only.join(",");
    let only = if only.is_empty() { only } else { format!(" --only {only}") };
    writeln!(
        text,
        "\nMade by: `cargo run --release -p stability -- --rays {rays} --seed {seed}{only}`. An error \
         is in the unit that the case's comment states: as a rule in units in the last place, or of u."
    )
    .expect("a string takes everything");
    text
}

/// 1e9 for 1000000000.
fn short(n: u64) -> String {
    let zeros = (0..20).take_while(|&k| n.is_multiple_of(10_u64.pow(k))).last().unwrap_or(0);
    if zeros > 3 { format!("{}e{zeros}", n / 10_u64.pow(zeros)) } else { n.to_string() }
}

#[cfg(test)]
mod tests {
    use super::{chosen, short};
    use crate::catalogue;

    #[test]
    fn cases_are_chosen_by_id_by_fact_and_by_component() {
        let chosen =
            |only: &[&str]| chosen(&only.iter().map(|&s| s.to_owned()).collect::<Vec<_>>());
        assert_eq!(chosen(&["S3"]).len(), 1, "one id");
        assert_eq!(chosen(&["S3", "S6"]).len(), 2, "two ids");
        assert!(chosen(&["sphere"]).len() > 5, "a component");
        assert!(chosen(&["self_that_nobody_has"]).is_empty(), "nothing");
    }

    #[test]
    fn large_numbers_can_be_read() {
        assert_eq!(short(1_000_000_000), "1e9", "a power of ten");
        assert_eq!(short(25_000_000), "25e6", "a round number");
        assert_eq!(short(1_234_567), "1234567", "no round number");
    }

    /// 163 rows: nothing of the catalogue is forgotten, and nothing stands in it twice.
    #[test]
    fn the_catalogue_is_complete() {
        let counts = [
            ("S", 17),
            ("P", 6),
            ("T", 18),
            ("B", 15),
            ("O", 8),
            ("K", 6),
            ("V", 14),
            ("C", 8),
            ("F", 15),
            ("BP", 12),
            ("M", 14),
            ("E", 16),
            ("I", 7),
            ("G", 7),
        ];
        let ids = counts.iter().flat_map(|&(name, n)| (1..=n).map(move |i| format!("{name}{i}")));
        let ids: Vec<String> = ids.collect();
        assert_eq!(ids.len(), 163, "the catalogue");
        let all = catalogue();
        let found: Vec<&str> =
            all.iter().flat_map(|(_, cases)| cases.iter().map(|case| case.id)).collect();
        for id in &ids {
            let times = found.iter().filter(|&found| found == id).count();
            assert_eq!(times, 1, "{id} stands in the tables {times} times");
        }
        assert_eq!(found.len(), ids.len(), "an id that the catalogue does not know");
    }
}
