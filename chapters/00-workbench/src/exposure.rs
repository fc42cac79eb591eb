//! How often and how large: the exposure of a film, with or without a command line.

use rayon::ThreadPoolBuilder;

use crate::{Error, Film, FilmPoint, Image, Sampler};

/// The most pixels of a picture: with 64 bytes a pixel for film, picture and file, 4 GiB.
pub(crate) const LARGEST_PICTURE: u64 = 1 << 26;

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
    if let Err(reason) = check_size(settings.size) {
        panic!("{reason}");
    }
    let mut film = Film::new(settings.size).unwrap_or_else(|error| panic!("the film: {error}"));
    let mut expose_all = || {
        in_passes(settings.samples, |samples| {
            film.expose(settings.seed, samples, &radiance, &|| false, &|_| ());
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
    film.strict_image()
}

/// Calls `pass` with 1, 1, 2, 4, 8 … samples until they add up to `samples` or it returns false.
///
/// After each pass the film holds a whole picture, with twice the samples of the one before.
pub(crate) fn in_passes(samples: u32, mut pass: impl FnMut(u32) -> bool) {
    let mut taken = 0;
    while taken < samples {
        let next = taken.max(1).min(samples - taken);
        if !pass(next) {
            return;
        }
        taken += next;
    }
}

/// Why a picture of this size cannot be rendered.
pub(crate) fn check_size(size: [u32; 2]) -> Result<(), String> {
    let [width, height] = size;
    if width == 0 || height == 0 {
        return Err(format!(
            "a picture of {width}×{height} has no pixels; both must be at least 1"
        ));
    }
    if width.max(height) > LONGEST_SIDE || u64::from(width) * u64::from(height) > LARGEST_PICTURE {
        return Err(format!(
            "a picture of {width}×{height} pixels would not fit in memory; at most {LARGEST_PICTURE} \
             pixels (for example 8192×8192), and {LONGEST_SIDE} on a side"
        ));
    }
    Ok(())
}

/// The film that was asked for, or why there is none.
pub(crate) fn film(size: [u32; 2], pixel: Option<[u32; 2]>) -> Result<Film, Error> {
    let film = match pixel {
        None => Film::new(size),
        Some(pixel) => Film::single_pixel(size, pixel),
    };
    film.map_err(|_| {
        let [width, height] = size;
        Error::Memory(format!("a picture of {width}×{height} pixels does not fit in memory"))
    })
}
