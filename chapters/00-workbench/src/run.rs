//! One run of a stage: from the command line to the picture.

use std::cell::{Cell, OnceCell, RefCell};
use std::env;
use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use console::Term;

use crate::exposure::{check_size, film, in_passes};
use crate::statistics::{Seconds, Statistics, group};
use crate::{
    Counter, Error, Exposure, Film, FilmPoint, Options, Probe, Recorder, Sampler, Stage,
    StatsTarget, atomic_file, interrupt, preview, progress, scene_path, statistics,
};

/// Parses the command line, calls `render`, prints what went wrong, and returns the exit status.
///
/// 0: done; 1: the input is at fault, or a file could not be written; 2: the command line is at
/// fault; 130: interrupted, the picture holds what there was.
pub fn main<E: Args>(
    stage: &'static Stage,
    render: impl FnOnce(&Run<E>) -> Result<Finished, Error>,
) -> ExitCode {
    let options = match Options::parse_for(stage, env::args_os()) {
        Ok(options) => options,
        Err(error) => {
            // Nowhere is left to report a failure to print.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let finished = Run::start(stage, options).and_then(|run| render(&run));
    match finished {
        Ok(Finished { interrupted: false }) => ExitCode::SUCCESS,
        Ok(Finished { interrupted: true }) => ExitCode::from(interrupt::STATUS),
        Err(error) => {
            write_stderr(&format!("error: {error}\n"));
            error.exit_code()
        }
    }
}

/// What [`Run::save`] returns, so that no `main.rs` forgets to save.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Finished {
    interrupted: bool,
}

/// One run of a stage.
#[derive(Debug)]
pub struct Run<E: Args> {
    /// The command line.
    pub options: Options<E>,
    stage: &'static Stage,
    recorder: Option<Recorder>,
    notices: RefCell<Vec<String>>,
    seconds: Cell<Seconds>,
    samples: Cell<u32>,
    scene_path: OnceCell<PathBuf>,
}

impl<E: Args> Run<E> {
    /// A run that has not loaded anything yet; Ctrl-C is listened to from here on.
    fn start(stage: &'static Stage, options: Options<E>) -> Result<Self, Error> {
        interrupt::listen()?;
        if let Some(threads) = options.threads {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
            pool.map_err(|error| Error::Threads(error.to_string()))?;
        }
        Ok(Self::new(stage, options))
    }

    fn new(stage: &'static Stage, options: Options<E>) -> Self {
        let recorder = match (&options.stats, options.pixel) {
            (None, None) => None,
            (Some(StatsTarget::StandardOutput), _) => Some(Recorder::new().telling_stderr()),
            _ => Some(Recorder::new()),
        };
        Self {
            options,
            stage,
            recorder,
            notices: RefCell::default(),
            seconds: Cell::default(),
            samples: Cell::new(0),
            scene_path: OnceCell::new(),
        }
    }

    /// Most scattering events on a path: what the command line says, else the stage.
    #[must_use]
    pub fn depth(&self) -> Option<u32> {
        self.options.depth.or(self.stage.depth)
    }

    /// The recorder, if `--stats` or `--pixel` asks for one; without it, render with
    /// [`Unwatched`](crate::Unwatched).
    #[must_use]
    pub fn recorder(&self) -> Option<&Recorder> {
        self.recorder.as_ref()
    }

    /// Calls `load` with the path of the scene file, and measures its time.
    ///
    /// Whether the results can be written is found out here, before anything takes long.
    pub fn load<T, Er: Into<Error>>(
        &self,
        load: impl FnOnce(&Path) -> Result<T, Er>,
    ) -> Result<T, Error> {
        let path = scene_path::resolve(&self.options.scene)?;
        let path = self.scene_path.get_or_init(|| path);
        self.check_targets()?;
        let (loaded, seconds) = timed(|| load(path));
        self.seconds.update(|all| Seconds { load: all.load + seconds, ..all });
        loaded.map_err(Into::into)
    }

    /// Calls `build`, and measures its time.
    pub fn build<T>(&self, build: impl FnOnce() -> T) -> T {
        let (built, seconds) = timed(build);
        self.seconds.update(|all| Seconds { build: all.build + seconds, ..all });
        built
    }

    /// Says a sentence in the summary, once.
    pub fn note(&self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        let mut notices = self.notices.borrow_mut();
        if !notices.contains(&sentence) {
            notices.push(sentence);
        }
    }

    /// Renders on all cores: calls `radiance` for every sample of every pixel.
    ///
    /// Size and samples are those of the command line, else of the scene, else of the stage; with
    /// `--time` alone, as many samples as there is time for. The
    /// first two numbers of the sampler have placed the film point in its pixel; the rest are for
    /// `radiance`. Under `--pixel`, only that pixel is rendered, by one thread.
    pub fn render<P: Probe, R: Into<[f32; 3]>>(
        &self,
        exposure: Exposure,
        probe: &P,
        radiance: impl Fn(FilmPoint, &mut Sampler) -> R + Sync,
    ) -> Result<Film, Error> {
        let size = self.options.size.unwrap_or(exposure.size);
        check_size(size).map_err(Error::Memory)?;
        let samples = match (self.options.samples, self.options.time) {
            (Some(samples), _) => samples,
            (None, Some(_)) => u32::MAX,
            (None, None) => exposure.samples.unwrap_or(self.stage.samples),
        };
        self.samples.set(samples);
        self.check_pixel(size)?;

        let mut film = film(size, self.options.pixel)?;
        interrupt::keep_the_picture();
        let (film, seconds) = timed(|| {
            self.expose(&mut film, samples, &radiance);
            film
        });
        self.seconds.update(|all| Seconds { render: all.render + seconds, ..all });
        probe.count(Counter::CameraRays, film.total_samples());
        Ok(film)
    }

    /// Adds samples to the film until there are enough, the time is over or Ctrl-C is pressed.
    fn expose<R: Into<[f32; 3]>>(
        &self,
        film: &mut Film,
        samples: u32,
        radiance: &(impl Fn(FilmPoint, &mut Sampler) -> R + Sync),
    ) {
        let [width, height] = film.size();
        let pixels =
            if self.options.pixel.is_some() { 1 } else { u64::from(width) * u64::from(height) };
        let hidden = self.options.quiet || self.options.pixel.is_some();
        let bar = progress::bar(pixels * u64::from(samples), samples, film.tile_count(), hidden);
        let deadline = self.options.time.and_then(|time| Instant::now().checked_add(time));
        let stop = || interrupt::stop() || deadline.is_some_and(|end| Instant::now() >= end);
        // The first pass takes one sample a pixel: under `--pixel`, that is the path to tell of.
        self.set_telling(self.options.pixel.is_some());
        in_passes(samples, |pass| {
            film.expose(self.options.seed, pass, radiance, &stop, &|done| {
                bar.inc(done);
            });
            self.set_telling(false);
            !stop()
        });
        bar.finish_and_clear();
    }

    fn set_telling(&self, telling: bool) {
        if let Some(recorder) = &self.recorder {
            recorder.set_telling(telling);
        }
    }

    /// Writes the picture, the statistics, the preview and the summary.
    ///
    /// Under `--pixel` there is no picture: the pixel's value is printed instead.
    pub fn save(&self, film: &Film) -> Result<Finished, Error> {
        let image = film.image();
        match self.options.pixel {
            Some([x, y]) => {
                let [r, g, b] = image.pixel(0, 0);
                let [samples, _] = film.samples();
                let sentence = format!("pixel ({x}, {y}): {r} {g} {b}, samples: {samples}");
                say(self.stdout_is_taken(), &sentence);
            }
            None => image.save(&self.output())?,
        }
        if let Some(target) = &self.options.stats {
            self.write_statistics(film, target)?;
        }
        if self.options.preview && self.options.pixel.is_none() {
            let columns = u32::from(Term::stdout().size().1);
            say(self.stdout_is_taken(), preview::half_blocks(&image, columns).trim_end());
        }
        let interrupted = interrupt::stop();
        if !self.options.quiet {
            write_stderr(&self.summary(film, interrupted));
        }
        Ok(Finished { interrupted })
    }

    /// Where the picture goes.
    fn output(&self) -> PathBuf {
        let default = || PathBuf::from(format!("{}-{}.png", self.stage.name, self.scene_name()));
        self.options.output.clone().unwrap_or_else(default)
    }

    /// The name of the scene file without its extension.
    fn scene_name(&self) -> String {
        let path = self.scene_path.get().unwrap_or(&self.options.scene);
        path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Whether standard output belongs to the statistics.
    fn stdout_is_taken(&self) -> bool {
        self.options.stats == Some(StatsTarget::StandardOutput)
    }

    fn check_targets(&self) -> Result<(), Error> {
        if self.options.pixel.is_none() {
            atomic_file::check_writable(&self.output())?;
        }
        match &self.options.stats {
            Some(StatsTarget::File(path)) => atomic_file::check_writable(path),
            _ => Ok(()),
        }
    }

    fn check_pixel(&self, [width, height]: [u32; 2]) -> Result<(), Error> {
        match self.options.pixel {
            Some([x, y]) if x >= width || y >= height => Err(Error::CommandLine(format!(
                "`--pixel {x},{y}` is outside of the picture; columns are 0 to {}, rows 0 to {}",
                width - 1,
                height - 1
            ))),
            _ => Ok(()),
        }
    }

    fn write_statistics(&self, film: &Film, target: &StatsTarget) -> Result<(), Error> {
        let groups = |name| self.recorder.as_ref().map(|r| group(r, name)).unwrap_or_default();
        let statistics = Statistics {
            stage: self.stage.name,
            scene: &self.scene_name(),
            size: film.size(),
            samples: film.samples()[1],
            threads: rayon::current_num_threads(),
            seed: self.options.seed,
            seconds: self.seconds.get(),
            rays: groups("rays"),
            tests: groups("tests"),
            skipped: groups("skipped"),
            non_finite_samples: film.non_finite_samples(),
        };
        statistics::write(&statistics, target)
    }

    /// The summary: the picture, the time, and what else the user should know.
    fn summary(&self, film: &Film, interrupted: bool) -> String {
        let [width, height] = film.size();
        let Seconds { load, build, render } = self.seconds.get();
        let threads = match rayon::current_num_threads() {
            1 => "1 thread".to_owned(),
            threads => format!("{threads} threads"),
        };
        let mut text = String::new();
        // Writing to a string cannot fail.
        if self.options.pixel.is_none() {
            let _ = writeln!(
                text,
                "{}: {width}×{height} pixels, {} a pixel; load {load:.3} s, build {build:.3} s, \
                 render {render:.3} s, {threads}",
                self.output().display(),
                samples_text(film.samples()),
            );
        }
        let interruption = interrupted.then(|| {
            let held = samples_text(film.samples());
            format!("interrupted: the picture holds {held} a pixel of {}", self.samples.get())
        });
        let notices = self.notices.borrow();
        let sentences =
            interruption.into_iter().chain(non_finite(film)).chain(notices.iter().cloned());
        for sentence in sentences {
            let _ = writeln!(text, "note: {sentence}");
        }
        text
    }
}

/// What to say of samples that are not finite.
fn non_finite(film: &Film) -> Option<String> {
    let [x, y] = film.first_non_finite_pixel()?;
    let count = film.non_finite_samples();
    Some(format!(
        "{count} samples were not finite and are left out, the first at `--pixel {x},{y}`"
    ))
}

/// "16 samples", or "3 to 4 samples".
fn samples_text([fewest, most]: [u32; 2]) -> String {
    match (fewest, most) {
        (1, 1) => "1 sample".to_owned(),
        _ if fewest == most => format!("{most} samples"),
        _ => format!("{fewest} to {most} samples"),
    }
}

/// What `work` returns, and how many seconds it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64())
}

/// Prints a line that was asked for. A reader who has gone away needs it no more.
pub(crate) fn say(to_stderr: bool, line: &str) {
    if to_stderr {
        write_stderr(&format!("{line}\n"));
    } else {
        let _ = writeln!(io::stdout(), "{line}");
    }
}

/// Writes to standard output; a full disk behind it is an error like any other.
pub(crate) fn write_stdout(text: &str) -> Result<(), Error> {
    let mut stdout = io::stdout();
    let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
    written.map_err(|source| Error::Write { path: PathBuf::from("standard output"), source })
}

/// Writes to standard error; if that fails, there is nowhere to say so.
fn write_stderr(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}
