//! One render as a line of the CSV file.

use crate::csv;

/// The columns of `results.csv`, in order, with what they hold.
pub const COLUMNS: [(&str, &str); 26] = [
    ("question", "what the render belongs to"),
    ("scene", "its name in assets/scenes, or terrain-N with N triangles"),
    ("width", "of the picture, in pixels"),
    ("height", "of the picture, in pixels"),
    ("stage", "the package of the chapter that rendered it"),
    ("setting", "a short name of what distinguishes it from the others of the question"),
    ("options", "the stage's options"),
    ("samples", "paths (or camera rays) a pixel"),
    ("seed", "the seed, which is also the number of the round"),
    ("rays", "all rays of the render, of all kinds"),
    ("load_seconds", "wall time of loading the scene"),
    ("build_seconds", "wall time of building tree and lights"),
    ("render_seconds", "wall time of the render alone, on one thread"),
    ("cpu_seconds", "processor time of the whole process, in hundredths; empty if unknown"),
    ("mean", "mean over pixels and channels, linear"),
    ("rmse", "root of the mean of (x - r)^2; r is the right picture"),
    ("rel_mse", "mean of (x - r)^2 / (r^2 + 0.01), less rel_mse_reference"),
    ("rel_mse_trimmed", "the same without the worst 0.1 % of the pixels, at least one"),
    ("rel_mse_reference", "expected relMSE of a perfect picture, because r has noise too"),
    ("bias", "mean of the picture / mean of the right one - 1"),
    ("bias_reference", "standard error of the right picture's own mean, relative to it"),
    ("flip", "mean of LDR-FLIP, 0 (the same) to 1, of the sRGB pictures"),
    ("rel_mse_shading", "stages 02-04: relMSE of the stage's own converged picture"),
    ("rel_mse_sampling", "stages 02-04: relMSE against the stage's own converged picture"),
    ("non_finite", "samples that were not finite"),
    ("picture", "fingerprint of every bit of the picture"),
];

/// The columns from `rmse` to `rel_mse_sampling`; see [`Measure`].
pub type Measures = [Option<f64>; 9];

/// A measured render.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which render it is.
    pub key: Key,
    /// The setting's short name.
    pub setting: String,
    /// All rays.
    pub rays: u64,
    /// Seconds of loading, of building, of rendering.
    pub seconds: [f64; 3],
    /// Processor time of the process.
    pub cpu: Option<f64>,
    /// Mean of the picture.
    pub mean: f64,
    /// What the picture is worth, if there is a right one.
    pub errors: Measures,
    /// Samples that were not finite.
    pub non_finite: u64,
    /// The picture's hash.
    pub picture: u64,
}

/// What distinguishes one render from all others.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Key {
    /// The question.
    pub question: String,
    /// The scene's name.
    pub scene: String,
    /// Width and height.
    pub size: [u32; 2],
    /// The stage.
    pub stage: String,
    /// Its options.
    pub options: String,
    /// Samples a pixel.
    pub samples: u32,
    /// The seed.
    pub seed: u64,
}

/// A place in [`Row::errors`]; the order of the columns from `rmse` on.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "COLUMNS says it")]
pub enum Measure {
    Rmse,
    RelMse,
    Trimmed,
    OwnOfReference,
    Bias,
    BiasOfReference,
    Flip,
    Shading,
    Sampling,
}

impl Row {
    /// The value of a measure, if it was taken.
    #[must_use]
    pub fn error(&self, measure: Measure) -> Option<f64> {
        self.errors[measure as usize]
    }

    /// Seconds of loading, of building, of rendering, see [`spent`].
    #[must_use]
    pub fn spent(&self) -> [f64; 3] {
        spent(self.seconds, self.cpu)
    }

    /// The line of the CSV file, without its end.
    #[must_use]
    pub fn line(&self) -> String {
        let Key { question, scene, size, stage, options, samples, seed } = &self.key;
        let [load, build, render] = self.seconds;
        let optional = |value: &Option<f64>| value.map(number).unwrap_or_default();
        let mut cells = vec![
            question.clone(),
            scene.clone(),
            size[0].to_string(),
            size[1].to_string(),
            stage.clone(),
            self.setting.clone(),
            options.clone(),
            samples.to_string(),
            seed.to_string(),
            self.rays.to_string(),
            format!("{load:.6}"),
            format!("{build:.6}"),
            format!("{render:.6}"),
            self.cpu.map(|cpu| format!("{cpu:.2}")).unwrap_or_default(),
            number(self.mean),
        ];
        cells.extend(self.errors.iter().map(optional));
        cells.push(self.non_finite.to_string());
        cells.push(format!("{:016x}", self.picture));
        csv::line(&cells)
    }

    /// The row of a line; `None` if the line is not whole.
    #[must_use]
    pub fn parse(line: &str) -> Option<Self> {
        let cells = csv::cells(line)?;
        if cells.len() != COLUMNS.len() {
            return None;
        }
        let real = |i: usize| cells[i].parse::<f64>().ok();
        let optional = |i: usize| if cells[i].is_empty() { Some(None) } else { real(i).map(Some) };
        let mut errors = [None; 9];
        for (i, error) in errors.iter_mut().enumerate() {
            *error = optional(15 + i)?;
        }
        Some(Self {
            key: Key {
                question: cells[0].clone(),
                scene: cells[1].clone(),
                size: [cells[2].parse().ok()?, cells[3].parse().ok()?],
                stage: cells[4].clone(),
                options: cells[6].clone(),
                samples: cells[7].parse().ok()?,
                seed: cells[8].parse().ok()?,
            },
            setting: cells[5].clone(),
            rays: cells[9].parse().ok()?,
            seconds: [real(10)?, real(11)?, real(12)?],
            cpu: optional(13)?,
            mean: real(14)?,
            errors,
            non_finite: cells[24].parse().ok()?,
            // A hash that was cut off is no hash.
            picture: (cells[25].len() == 16)
                .then(|| u64::from_str_radix(&cells[25], 16).ok())??,
        })
    }
}

/// What a process spent on loading, on building and on rendering: its processor time, shared out as
/// the clock saw the three; or what the clock said, if the processor time is not known to a tenth.
///
/// On an idle machine the two are the same, with one thread. On one that is shared, the clock
/// counts what others did meanwhile. Processor time comes in hundredths of a second.
#[must_use]
pub fn spent(seconds: [f64; 3], cpu: Option<f64>) -> [f64; 3] {
    const KNOWN: f64 = 0.1;
    let all: f64 = seconds.iter().sum();
    match cpu {
        Some(cpu) if cpu >= KNOWN && cpu < all => seconds.map(|part| part * cpu / all),
        _ => seconds,
    }
}

/// The first line of the file.
#[must_use]
pub fn header() -> String {
    csv::line(&COLUMNS.map(|(name, _)| name.to_owned()))
}

/// Seven digits, which is more than any of the measures is worth.
fn number(value: f64) -> String {
    format!("{value:.6e}")
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{COLUMNS, Key, Row, header, spent};

    pub(crate) fn example(setting: &str, samples: u32, seed: u64) -> Row {
        Row {
            key: Key {
                question: "density".into(),
                scene: "cornell-box".into(),
                size: [64, 64],
                stage: "rendering-equation".into(),
                options: format!("--density {setting} --depth 16"),
                samples,
                seed,
            },
            setting: setting.into(),
            rays: 123_456,
            seconds: [0.001, 0.002, 0.5 * f64::from(samples)],
            cpu: None,
            mean: 0.125,
            errors: [0, 1, 2, 3, 4, 5, 6, 7, 8]
                .map(|i| (i < 7).then_some(f64::from(1 + i) / f64::from(samples))),
            non_finite: 0,
            picture: 0x0123_4567_89ab_cdef,
        }
    }

    #[test]
    fn a_row_survives_the_file() {
        let row = example("cosine", 4, 7);
        assert_eq!(Row::parse(&row.line()).as_ref(), Some(&row), "{}", row.line());
        let unknown = Row { cpu: None, errors: [None; 9], ..row };
        assert_eq!(Row::parse(&unknown.line()).as_ref(), Some(&unknown), "{}", unknown.line());
        assert_eq!(header().split(',').count(), COLUMNS.len(), "{}", header());
    }

    #[test]
    fn a_long_render_is_timed_by_the_processor_and_a_short_one_by_the_clock() {
        let parts = [0.5, 1.0, 2.5];
        assert_eq!(spent(parts, Some(1.0)), [0.125, 0.25, 0.625], "a quarter of the clock's time");
        assert_eq!(spent(parts, Some(4.1)), parts, "never more than the clock says");
        assert_eq!(spent(parts, Some(0.09)), parts, "too short to be known");
        assert_eq!(spent(parts, None), parts, "unknown");
    }

    /// However a line is cut off, it is not taken for another row.
    #[test]
    fn a_line_that_was_cut_off_is_no_row() {
        let line = example("cosine", 4, 7).line();
        for end in 0..line.len() {
            assert_eq!(Row::parse(&line[..end]), None, "`{}`", &line[..end]);
        }
    }
}
