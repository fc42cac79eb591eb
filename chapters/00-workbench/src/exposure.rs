//! How often and how large: the exposure of a film, with or without a command line.

use std::collections::TryReserveError;

use rayon::ThreadPoolBuilder;

use crate::goal::Goal;
use crate::{Error, Estimate, Film, FilmPoint, Image, Sampler};

/// The most pixels of a picture: with 64 bytes a pixel for film, picture and file, 4 GiB.
pub(crate) const LARGEST_PICTURE: u64 = 1 << 26;

/// The most pixels of a picture that estimates its error, which takes 96 bytes a pixel more, and under
/// `--error` 128 more than that: 9 GiB.
pub(crate) const LARGEST_ESTIMATE: u64 = 1 << 25;

/// The longest side of a picture in pixels: f32 film coordinates still tell 256 points of a pixel
/// apart.
pub(crate) const LONGEST_SIDE: u32 = 1 << 16;

/// What a scene wishes for; the command line may say otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exposure {
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// Samples a pixel, if the scene has a wish.
    pub samples: Option<u32>,
}

/// Settings of a render without a command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilmSettings {
    /// Width and height in pixels, both at least 1.
    pub size: [u32; 2],
    /// Samples a pixel, at least 1.
    pub samples: u32,
    /// Another seed, another picture.
    pub seed: u64,
    /// How many threads; all cores when `None`. Never changes the picture.
    pub threads: Option<usize>,
}

/// Renders a picture in memory, for tests and figures: pixel for pixel that of
/// [`Run::render`](crate::Run::render).
///
/// A pixel that meets a sample that is not finite is NaN as a whole, so that no test passes over
/// it.
///
/// Panics when the size is beyond the limits, or when the threads cannot be started.
pub fn expose<R: Into<[f32; 3]>>(
    settings: &FilmSettings,
    radiance: impl Fn(FilmPoint, &mut Sampler) -> R + Sync,
) -> Image {
    let goal = Goal { samples: settings.samples, error: None };
    exposed(settings, goal, Film::new, radiance).strict_image()
}

/// The same picture as from [`expose`], with the variance of every pixel and the estimated error.
///
/// Panics like [`expose`].
pub fn expose_estimate<R: Into<[f32; 3]>>(
    settings: &FilmSettings,
    radiance: impl Fn(FilmPoint, &mut Sampler) -> R + Sync,
) -> Estimate {
    let goal = Goal { samples: settings.samples, error: None };
    exposed(settings, goal, Film::estimating, radiance).strict_estimate()
}

/// The picture that `--error` renders: samples are added, more of them where they are needed more,
/// until the estimated relative error is at most `error`, a fraction of 1, or until there are
/// `settings.samples` a pixel.
///
/// Panics like [`expose`].
pub fn expose_until<R: Into<[f32; 3]>>(
    settings: &FilmSettings,
    error: f64,
    radiance: impl Fn(FilmPoint, &mut Sampler) -> R + Sync,
) -> Estimate {
    let goal = Goal { samples: settings.samples, error: Some(error) };
    let film = |size| Film::estimating(size)?.sharing();
    exposed(settings, goal, film, radiance).strict_estimate()
}

/// A film of that kind, exposed until the goal is reached.
fn exposed<R: Into<[f32; 3]>>(
    settings: &FilmSettings,
    goal: Goal,
    film: impl FnOnce([u32; 2]) -> Result<Film, TryReserveError>,
    radiance: impl Fn(FilmPoint, &mut Sampler) -> R + Sync,
) -> Film {
    if let Err(reason) = check_size(settings.size, LARGEST_PICTURE) {
        panic!("{reason}");
    }
    let mut film = film(settings.size).unwrap_or_else(|error| panic!("the film: {error}"));
    let mut expose_all = || {
        goal.pursue(&mut film, |film, portion| {
            film.expose(settings.seed, portion, &radiance, &|| false, &|_| ());
            true
        });
    };
    match settings.threads {
        None => expose_all(),
        Some(threads) => {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build();
            pool.unwrap_or_else(|error| panic!("{threads} threads: {error}")).install(expose_all);
        }
    }
    film
}

/// Why a picture of this size cannot be rendered, if at most `largest` pixels are possible.
pub(crate) fn check_size(size: [u32; 2], largest: u64) -> Result<(), String> {
    let [width, height] = size;
    if width == 0 || height == 0 {
        return Err(format!(
            "a picture of {width}×{height} has no pixels; both must be at least 1"
        ));
    }
    if width.max(height) > LONGEST_SIDE || u64::from(width) * u64::from(height) > largest {
        return Err(format!(
            "a picture of {width}×{height} pixels would not fit in memory; at most {largest} \
             pixels (for example 8192×{}), and {LONGEST_SIDE} on a side",
            largest / 8192
        ));
    }
    Ok(())
}

/// The film that was asked for, or why there is none: of one pixel or all, one that estimates its
/// error or not, one that shares its samples out or not.
pub(crate) fn film(
    size: [u32; 2],
    pixel: Option<[u32; 2]>,
    estimates: bool,
    shares: bool,
) -> Result<Film, Error> {
    let film = match (pixel, estimates) {
        (None, false) => Film::new(size),
        (None, true) => Film::estimating(size),
        (Some(pixel), false) => Film::single_pixel(size, pixel),
        (Some(pixel), true) => Film::estimating_pixel(size, pixel),
    };
    let film = film.and_then(|film| if shares { film.sharing() } else { Ok(film) });
    film.map_err(|_| {
        let [width, height] = size;
        Error::Memory(format!("a picture of {width}×{height} pixels does not fit in memory"))
    })
}
