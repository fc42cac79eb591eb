//! The stages' binaries: built once, and run as users run them.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use workbench::Image;

use crate::error::{Error, Result};

/// The stages that draw scenes, in the order of the chapters.
pub const STAGES: [&str; 7] = [
    "ray-casting",
    "blinn-phong",
    "mirror-refraction",
    "bv-tree",
    "rendering-equation",
    "path-tracing",
    "light-sampling",
];

/// The binaries, and a folder for what they leave behind.
#[derive(Debug)]
pub struct Stages {
    binaries: BTreeMap<String, PathBuf>,
    /// Generated scenes, converged pictures, and the picture that was just rendered.
    pub folder: PathBuf,
}

/// What a render left behind.
#[derive(Debug)]
pub struct Rendered {
    /// The picture.
    pub image: Image,
    /// What `--stats` wrote.
    pub stats: Value,
    /// Processor time of the whole process in seconds, in hundredths, if the system tells.
    pub cpu: Option<f64>,
}

impl Stages {
    /// Builds the stages for release, without flags: that is what users run.
    ///
    /// # Errors
    /// If Cargo cannot be started, or a stage cannot be built.
    pub fn build() -> Result<Self> {
        let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."));
        cargo.args(["build", "--release", "--bins", "--message-format", "json-render-diagnostics"]);
        cargo.args(STAGES.iter().flat_map(|stage| ["-p", stage]));
        cargo.stderr(Stdio::inherit());
        let output = cargo.output().map_err(|error| Error::new(format!("cargo: {error}")))?;
        if !output.status.success() {
            return Err(Error::new("the stages cannot be built"));
        }
        let binaries: BTreeMap<String, PathBuf> =
            String::from_utf8_lossy(&output.stdout).lines().filter_map(executable).collect();
        if let Some(missing) = STAGES.iter().find(|stage| !binaries.contains_key(**stage)) {
            return Err(Error::new(format!("cargo says not where the binary `{missing}` is")));
        }
        // target/release/STAGE
        let target = binaries["light-sampling"].ancestors().nth(2).unwrap_or(Path::new("."));
        let folder = target.join("time-vs-error");
        Self::at(binaries, folder)
    }

    /// Binaries that were built already.
    ///
    /// # Errors
    /// If the folder cannot be made.
    pub fn at(binaries: BTreeMap<String, PathBuf>, folder: PathBuf) -> Result<Self> {
        fs::create_dir_all(&folder).map_err(|error| Error::file(&folder, error))?;
        Ok(Self { binaries, folder })
    }

    /// Where the binary of a stage is.
    ///
    /// # Panics
    /// If there is no such stage.
    #[must_use]
    pub fn binary(&self, stage: &str) -> &Path {
        &self.binaries[stage]
    }

    /// Renders on one thread, so that the time of the render is that of the processor.
    ///
    /// `arguments` are the options, separated by spaces.
    ///
    /// # Errors
    /// If the stage fails, or what it wrote cannot be read.
    pub fn render(&self, stage: &str, scene: &Path, arguments: &str) -> Result<Rendered> {
        let picture = self.folder.join(format!("picture-{}.exr", std::process::id()));
        let mut command = Command::new(self.binary(stage));
        command.arg(scene).args(arguments.split_whitespace()).arg("-o").arg(&picture);
        command.args(["--threads", "1", "--quiet", "--stats", "-"]);
        let before = children_cpu();
        let output = command.output().map_err(|error| Error::file(self.binary(stage), error))?;
        let cpu = children_cpu().zip(before).map(|(after, before)| after - before);
        let stats = read_stats(stage, arguments, &output)?;
        let image = Image::load_exr(&picture)?;
        fs::remove_file(&picture).map_err(|error| Error::file(&picture, error))?;
        Ok(Rendered { image, stats, cpu })
    }
}

impl Rendered {
    /// A number of the statistics, such as `/seconds/render`; NaN if it is not there.
    #[must_use]
    pub fn number(&self, pointer: &str) -> f64 {
        self.stats.pointer(pointer).and_then(Value::as_f64).unwrap_or(f64::NAN)
    }

    /// Wall seconds of loading, building and rendering.
    #[must_use]
    pub fn seconds(&self) -> [f64; 3] {
        ["load", "build", "render"].map(|part| self.number(&format!("/seconds/{part}")))
    }

    /// All rays together.
    #[must_use]
    pub fn rays(&self) -> u64 {
        let rays = self.stats["rays"].as_object();
        rays.into_iter().flat_map(|rays| rays.values()).filter_map(Value::as_u64).sum()
    }
}

fn read_stats(stage: &str, arguments: &str, output: &Output) -> Result<Value> {
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(Error::new(format!("`{stage} {arguments}` failed: {}", said.trim())));
    }
    serde_json::from_slice(&output.stdout)
        .map_err(|error| Error::new(format!("the statistics of `{stage} {arguments}`: {error}")))
}

/// Name and path of the executable of a message of Cargo's, if it is about one.
fn executable(line: &str) -> Option<(String, PathBuf)> {
    let message: Value = serde_json::from_str(line).ok()?;
    let name = message["target"]["name"].as_str()?;
    Some((name.to_owned(), message["executable"].as_str()?.into()))
}

/// User and system time of all children that have ended, in seconds; Linux only.
///
/// The fields 16 and 17 of `/proc/self/stat` count hundredths of a second. The second field, a
/// name in parentheses, may hold spaces.
fn children_cpu() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    let mut fields = text.rsplit(')').next()?.split_whitespace();
    let user: f64 = fields.nth(13)?.parse().ok()?;
    let system: f64 = fields.next()?.parse().ok()?;
    Some((user + system) / 100.0)
}
