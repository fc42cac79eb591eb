//! Plants one mutant after the other and looks which test notices it.

use std::fmt::Write as _;
use std::io;
use std::path::Path;
use std::time::Instant;

use crate::zoo::check::{self, Verdict};
use crate::zoo::mutant::{Mutant, Test};
use crate::zoo::scratch::Scratch;

/// What became of a mutant.
#[derive(Clone, Debug)]
pub struct Fate {
    /// The mutant.
    pub mutant: Mutant,
    /// What its test said.
    pub verdict: Verdict,
}

impl Fate {
    /// Whether the test has noticed it.
    #[must_use]
    pub fn is_killed(&self) -> bool {
        self.verdict == Verdict::Failed
    }
}

/// Runs the tests of `mutants` on sound sources, then with each mutant, and tells `say` of each.
///
/// `folder` is where the copy of the workspace lies.
///
/// # Errors
///
/// A test does not pass on sound sources, a mutant cannot be planted, or a file cannot be written.
pub fn hunt(
    workspace: &Path,
    folder: &Path,
    mutants: &[Mutant],
    say: impl Fn(String),
) -> io::Result<Vec<Fate>> {
    let scratch = Scratch::copy(workspace, folder)?;
    let mut tests: Vec<Test> = Vec::new();
    for mutant in mutants {
        if !tests.contains(&mutant.test) {
            tests.push(mutant.test);
        }
    }
    for test in &tests {
        match check::run(&scratch, test)? {
            Verdict::Passed => say(format!("passes    {test}")),
            other => return Err(io::Error::other(format!("{test}, without a mutant: {other:?}"))),
        }
    }
    mutants
        .iter()
        .map(|mutant| {
            let start = Instant::now();
            let sound = scratch.read(mutant.file)?;
            scratch.write(mutant.file, &mutant.plant(&sound).map_err(io::Error::other)?)?;
            let verdict = check::run(&scratch, &mutant.test);
            scratch.write(mutant.file, &sound)?;
            let fate = Fate { mutant: *mutant, verdict: verdict? };
            say(format!("{} ({:.0} s)", sentence(&fate), start.elapsed().as_secs_f64()));
            Ok(fate)
        })
        .collect()
}

/// One line for the terminal; more if something is to be done.
fn sentence(fate: &Fate) -> String {
    let Mutant { name, lesson, file, test, .. } = fate.mutant;
    match &fate.verdict {
        Verdict::Failed => format!("killed    {name}: {test}"),
        Verdict::Passed => format!("SURVIVED  {name} ({file}; {lesson}): {test} does not notice"),
        Verdict::NothingRun => format!("SURVIVED  {name} ({file}): {test} is no test"),
        Verdict::Endless => format!("ENDLESS   {name} ({file}): {test} did not end"),
        Verdict::NotCompiled(said) => format!("NO CODE   {name} ({file}):\n{said}"),
    }
}

/// The table of the book.
#[must_use]
pub fn table(fates: &[Fate]) -> String {
    let mut text = "| mutant | in | killed by |\n|---|---|---|\n".to_owned();
    for fate in fates.iter().filter(|fate| fate.is_killed()) {
        let Mutant { name, file, test, .. } = fate.mutant;
        let place = file.rsplit('/').next().unwrap_or(file);
        let fact = test.name.replace('_', " ");
        let _ = writeln!(text, "| {name} | `{place}` | {}: {fact} |", test.package);
    }
    text
}
