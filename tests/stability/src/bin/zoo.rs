//! Plants the mistakes of the bug zoo and shows which test notices each.
//!
//! `cargo run --release -p stability --bin zoo -- --only roulette`

use std::path::Path;
use std::process::ExitCode;
use std::{env, error, fs};

use clap::Parser;
use stability::zoo::{hunt, mutants};

/// The table that the book shows.
const TABLE: &str = "book/pages/measurements/stability/zoo.md";

#[derive(Parser)]
struct Options {
    /// Only the mutants whose name or file contains this
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    only: String,
    /// Write the table of the book, if all are killed
    #[arg(long, conflicts_with = "only")]
    write: bool,
}

fn main() -> Result<ExitCode, Box<dyn error::Error>> {
    let options = Options::parse();
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize()?;
    // target/release/zoo: beside `release` there is room.
    let program = env::current_exe()?;
    let target = program.ancestors().nth(2).ok_or("the program lies in no target folder")?;
    let mut chosen = mutants();
    chosen.retain(|m| m.name.contains(&options.only) || m.file.contains(&options.only));
    let fates = hunt::hunt(&workspace, &target.join("zoo"), &chosen, |line| println!("{line}"))?;
    let killed = fates.iter().filter(|fate| fate.is_killed()).count();
    println!("\n{}\n{killed} of {} mutants are killed.", hunt::table(&fates), fates.len());
    if killed < fates.len() || fates.is_empty() {
        return Ok(ExitCode::FAILURE);
    }
    if options.write {
        let path = workspace.join(TABLE);
        fs::create_dir_all(path.parent().unwrap_or(&workspace))?;
        fs::write(&path, hunt::table(&fates))?;
    }
    Ok(ExitCode::SUCCESS)
}
