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

use crate::exposure::{LARGEST_ESTIMATE, LARGEST_PICTURE, check_size, film};
use crate::goal::Goal;
use crate::pace::Pace;
use crate::statistics::{Seconds, Statistics, group};
use crate::{
    Counter, Error, Exposure, Film, FilmPoint, Options, Probe, Recorder, Sampler, Stage,
    StatsTarget, atomic_file, interrupt, preview, progress, scene_path, statistics, summary,
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
    /// The samples a pixel that end the render, if they do.
    samples: Cell<Option<u32>>,
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
        let unskipped = options.no_skip.as_ref().map_or(&[][..], |no_skip| &no_skip.0);
        let recorder = || Recorder::new().without_skipping(unskipped);
        let recorder = match (&options.stats, options.pixel) {
            (None, None) if unskipped.is_empty() => None,
            (Some(StatsTarget::StandardOutput), _) => Some(recorder().telling_stderr()),
            _ => Some(recorder()),
        };
        Self {
            options,
            stage,
            recorder,
            notices: RefCell::default(),
            seconds: Cell::default(),
            samples: Cell::default(),
            scene_path: OnceCell::new(),
        }
    }

    /// Most scattering events on a path: what the command line says, else the stage.
    #[must_use]
    pub fn depth(&self) -> Option<u32> {
        self.options.depth.or(self.stage.depth)
    }

    /// The recorder, if `--stats`, `--pixel` or `--no-skip` asks for one; without it, render with
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
    /// `--time` or `--error` and without `--samples`, as many samples as there is time for or as
    /// the error needs. The first two numbers of the sampler have placed the film point in its
    /// pixel; the rest are for `radiance`. Under `--pixel`, only that pixel is rendered, by one
    /// thread.
    pub fn render<P: Probe, R: Into<[f32; 3]>>(
        &self,
        exposure: Exposure,
        probe: &P,
        radiance: impl Fn(FilmPoint, &mut Sampler) -> R + Sync,
    ) -> Result<Film, Error> {
        let size = self.options.size.unwrap_or(exposure.size);
        let largest = if self.stage.estimates { LARGEST_ESTIMATE } else { LARGEST_PICTURE };
        check_size(size, largest).map_err(match self.options.size {
            Some(_) => Error::CommandLine,
            None => Error::Memory,
        })?;
        let is_open = self.options.time.is_some() || self.options.error.is_some();
        let default = || (!is_open).then(|| exposure.samples.unwrap_or(self.stage.samples));
        self.samples.set(self.options.samples.or_else(default));
        self.check_pixel(size)?;

        let Options { pixel, error, .. } = self.options;
        let shares = error.is_some() && self.skips(Counter::SamplesNotNeeded);
        let mut film = film(size, pixel, self.stage.estimates, shares)?;
        interrupt::keep_the_picture();
        let (film, seconds) = timed(|| {
            self.expose(&mut film, &radiance);
            film
        });
        self.seconds.update(|all| Seconds { render: all.render + seconds, ..all });
        probe.count(Counter::CameraRays, film.total_samples());
        if shares {
            probe.count(Counter::SamplesNotNeeded, film.samples_below_average());
        }
        Ok(film)
    }

    /// Whether this kind of work is skipped: it is, except under `--no-skip`.
    fn skips(&self, counter: Counter) -> bool {
        self.recorder.as_ref().is_none_or(|recorder| recorder.skips(counter))
    }

    /// Adds samples to the film until there are enough, the error is small enough, the time is over
    /// or Ctrl-C is pressed.
    fn expose<R: Into<[f32; 3]>>(
        &self,
        film: &mut Film,
        radiance: &(impl Fn(FilmPoint, &mut Sampler) -> R + Sync),
    ) {
        let Options { time, error, pixel, seed, .. } = self.options;
        let goal = Goal { samples: self.samples.get().unwrap_or(u32::MAX), error };
        let pace = Pace::new(time);
        let hidden = self.options.quiet || pixel.is_some();
        let mut bar = progress::Bar::new(&goal, time.is_some(), film, hidden);
        let stop = || interrupt::stop() || pace.is_over();
        // The first pass takes one sample a pixel: under `--pixel`, that is the path to tell of.
        self.set_telling(pixel.is_some());
        goal.pursue(film, |film, portion| {
            bar.show_error(film, &goal);
            let mut left = portion;
            while left.most() > 0 && !stop() {
                let part = left.part(pace.samples(film.average_samples()));
                film.expose(seed, part, radiance, &stop, &|done| bar.add(done));
                self.set_telling(false);
                left = left.without(part);
                bar.show_time(pace.total(film.average_samples()));
            }
            !stop()
        });
        bar.finish();
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
                let error = summary::error(film);
                let sentence = format!("pixel ({x}, {y}): {r} {g} {b}, samples: {samples}{error}");
                say(self.stdout_is_taken(), &sentence)?;
            }
            None => image.save(&self.output())?,
        }
        if let Some(target) = &self.options.stats {
            self.write_statistics(film, target)?;
        }
        if self.options.preview && self.options.pixel.is_none() {
            let columns = u32::from(Term::stdout().size().1);
            say(self.stdout_is_taken(), preview::half_blocks(&image, columns).trim_end())?;
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
            estimated_error: film.estimated_error(),
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
                "{}: {width}×{height} pixels, {} a pixel{}; load {load:.3} s, build {build:.3} s, \
                 render {render:.3} s, {threads}",
                self.output().display(),
                summary::samples(film),
                summary::error(film),
            );
        }
        let notices = self.notices.borrow();
        let sentences = interrupted
            .then(|| summary::interruption(film, self.samples.get()))
            .into_iter()
            .chain(summary::missed_error(film, self.options.error))
            .chain(summary::non_finite(film))
            .chain(notices.iter().cloned());
        for sentence in sentences {
            let _ = writeln!(text, "note: {sentence}");
        }
        text
    }
}

/// What `work` returns, and how many seconds it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64())
}

/// Prints a line that was asked for. A reader who has gone away needs it no more; a full disk is an
/// error like any other.
pub(crate) fn say(to_stderr: bool, line: &str) -> Result<(), Error> {
    let line = format!("{line}\n");
    if to_stderr {
        write_stderr(&line);
        return Ok(());
    }
    match write_stdout(&line) {
        Err(Error::Write { source, .. }) if source.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}

/// Writes to standard output.
pub(crate) fn write_stdout(text: &str) -> Result<(), Error> {
    let mut stdout = io::stdout();
    let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
    written.map_err(|source| Error::Write { path: PathBuf::from("standard output"), source })
}

/// Writes to standard error; if that fails, there is nowhere to say so.
fn write_stderr(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

#[cfg(test)]
mod tests;
