//! The film: what the samples of each pixel add up to.

use std::collections::TryReserveError;

use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

use crate::{Image, Sampler};

/// The side of a tile in pixels: small enough to keep all cores busy to the end, large enough that
/// handing tiles out costs nothing.
const TILE: u32 = 16;

/// A point of the film, in pixels: x to the right, y downwards, the centre of the first pixel at
/// (0.5, 0.5).
///
/// The point of a sample always lies in the pixel it is drawn for, also after rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmPoint {
    /// From the left edge, in [0, width).
    pub x: f32,
    /// From the upper edge, in [0, height).
    pub y: f32,
    /// Width and height of the whole film in pixels.
    pub size: [u32; 2],
}

impl FilmPoint {
    /// The point of pixel (x, y) that `u` ∈ [0, 1)² picks.
    #[inline]
    #[must_use]
    pub fn in_pixel(pixel: [u32; 2], u: [f32; 2], size: [u32; 2]) -> Self {
        Self { x: within(pixel[0], u[0]), y: within(pixel[1], u[1]), size }
    }
}

/// `pixel` + `u`, kept below `pixel` + 1, to which the sum may round.
#[inline]
fn within(pixel: u32, u: f32) -> f32 {
    (pixel as f32 + u).min(((pixel + 1) as f32).next_down())
}

/// What one pixel has collected.
#[derive(Clone, Copy, Debug, Default)]
struct PixelSum {
    /// The sum of the finite samples, in the order of their numbers.
    sum: [f64; 3],
    /// How many samples are in the sum.
    finite: u32,
    /// How many were taken.
    taken: u32,
}

impl PixelSum {
    // ANCHOR: add
    #[inline]
    fn add(&mut self, radiance: [f32; 3]) {
        let radiance = radiance.map(f64::from);
        self.taken += 1;
        // In f64, finite f32s cannot add up to infinity.
        if (radiance[0] + radiance[1] + radiance[2]).is_finite() {
            self.finite += 1;
            for (sum, value) in self.sum.iter_mut().zip(radiance) {
                *sum += value;
            }
        }
    }
    // ANCHOR_END: add

    /// The mean of the finite samples: black before the first sample, NaN when none was finite.
    fn mean(&self) -> [f32; 3] {
        if self.taken == 0 {
            return [0.0; 3];
        }
        self.sum.map(|sum| (sum / f64::from(self.finite)) as f32)
    }
}

/// A rectangle of pixels that one thread works on at a time.
#[derive(Clone, Debug)]
struct Tile {
    origin: [u32; 2],
    width: u32,
    pixels: Vec<PixelSum>,
}

impl Tile {
    /// The pixels of the tile with their coordinates, row by row.
    fn pixels(&self) -> impl Iterator<Item = ([u32; 2], &PixelSum)> {
        let ([x, y], width) = (self.origin, self.width);
        (0..).zip(&self.pixels).map(move |(i, sum)| ([x + i % width, y + i / width], sum))
    }

    /// The same, to be added to.
    fn pixels_mut(&mut self) -> impl Iterator<Item = ([u32; 2], &mut PixelSum)> {
        let ([x, y], width) = (self.origin, self.width);
        (0..).zip(&mut self.pixels).map(move |(i, sum)| ([x + i % width, y + i / width], sum))
    }
}

/// The film: sums and counts of the samples of every pixel.
///
/// Sums are f64 and each pixel's samples are added in the order of their numbers, so the picture
/// does not depend on threads, tiles or passes. A sample that is not finite is counted and left
/// out of the sum: one bad sample in a thousand must not cost the pixel, and must not go unnoticed.
#[derive(Clone, Debug)]
pub struct Film {
    /// Width and height of the whole picture.
    size: [u32; 2],
    /// The part of it that is here: its upper left corner,
    origin: [u32; 2],
    /// and its width and height.
    extent: [u32; 2],
    tiles: Vec<Tile>,
}

impl Film {
    /// A film without samples.
    ///
    /// Fails when the memory cannot be had.
    pub(crate) fn new(size: [u32; 2]) -> Result<Self, TryReserveError> {
        Self::part(size, [0, 0], size)
    }

    /// A film that holds a single pixel of a larger picture.
    pub(crate) fn single_pixel(size: [u32; 2], pixel: [u32; 2]) -> Result<Self, TryReserveError> {
        Self::part(size, pixel, [1, 1])
    }

    fn part(size: [u32; 2], origin: [u32; 2], extent: [u32; 2]) -> Result<Self, TryReserveError> {
        let mut tiles = Vec::new();
        for y in (0..extent[1]).step_by(TILE as usize) {
            for x in (0..extent[0]).step_by(TILE as usize) {
                let (width, height) = (TILE.min(extent[0] - x), TILE.min(extent[1] - y));
                let count = (width * height) as usize;
                let mut pixels = Vec::new();
                pixels.try_reserve_exact(count)?;
                pixels.resize(count, PixelSum::default());
                tiles.try_reserve(1)?;
                tiles.push(Tile { origin: [origin[0] + x, origin[1] + y], width, pixels });
            }
        }
        Ok(Self { size, origin, extent, tiles })
    }

    /// Adds `samples` samples to every pixel, on the current pool of threads.
    ///
    /// `stop` is asked before each tile; the tiles that follow stay as they are. `done` hears of
    /// the samples of each tile.
    pub(crate) fn expose<R: Into<[f32; 3]>>(
        &mut self,
        seed: u64,
        samples: u32,
        radiance: &(impl Fn(FilmPoint, &mut Sampler) -> R + Sync),
        stop: &(impl Fn() -> bool + Sync),
        done: &(impl Fn(u64) + Sync),
    ) {
        let size = self.size;
        self.tiles.par_iter_mut().for_each(|tile| {
            if stop() {
                return;
            }
            for (pixel, sum) in tile.pixels_mut() {
                let index = u64::from(pixel[1]) * u64::from(size[0]) + u64::from(pixel[0]);
                for _ in 0..samples {
                    let mut sampler = Sampler::new(seed, index, u64::from(sum.taken));
                    let point = FilmPoint::in_pixel(pixel, sampler.next_2d(), size);
                    sum.add(radiance(point, &mut sampler).into());
                }
            }
            done(tile.pixels.len() as u64 * u64::from(samples));
        });
    }

    /// Width and height of the whole picture in pixels.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The picture so far: in each pixel the mean of its finite samples.
    ///
    /// A pixel without samples is black; one without a finite sample is NaN, which a PNG file
    /// shows as magenta. Of a film that holds a single pixel, the picture is that pixel.
    #[must_use]
    pub fn image(&self) -> Image {
        self.image_of(PixelSum::mean)
    }

    /// The same, but NaN in every pixel that met a sample that is not finite: for tests, which
    /// must not pass over one.
    pub(crate) fn strict_image(&self) -> Image {
        let strict = |sum: &PixelSum| {
            if sum.finite == sum.taken { sum.mean() } else { [f32::NAN; 3] }
        };
        self.image_of(strict)
    }

    fn image_of(&self, value: impl Fn(&PixelSum) -> [f32; 3]) -> Image {
        let mut image = Image::new(self.extent[0], self.extent[1]);
        for (pixel, sum) in self.pixels() {
            let (x, y) = (pixel[0] - self.origin[0], pixel[1] - self.origin[1]);
            image.pixels[y as usize * self.extent[0] as usize + x as usize] = value(sum);
        }
        image
    }

    /// The fewest and the most samples that a pixel holds.
    #[must_use]
    pub fn samples(&self) -> [u32; 2] {
        let taken = || self.pixels().map(|(_, sum)| sum.taken);
        [taken().min().unwrap_or(0), taken().max().unwrap_or(0)]
    }

    /// All samples of all pixels.
    #[must_use]
    pub fn total_samples(&self) -> u64 {
        self.pixels().map(|(_, sum)| u64::from(sum.taken)).sum()
    }

    /// How many samples were not finite, and are left out of the picture.
    #[must_use]
    pub fn non_finite_samples(&self) -> u64 {
        self.pixels().map(|(_, sum)| u64::from(sum.taken - sum.finite)).sum()
    }

    /// A pixel that met a sample that is not finite, the uppermost, then leftmost.
    #[must_use]
    pub fn first_non_finite_pixel(&self) -> Option<[u32; 2]> {
        let guilty = self.pixels().filter(|(_, sum)| sum.finite < sum.taken);
        guilty.map(|(pixel, _)| pixel).min_by_key(|&[x, y]| (y, x))
    }

    /// How many tiles there are.
    pub(crate) fn tile_count(&self) -> u64 {
        self.tiles.len() as u64
    }

    fn pixels(&self) -> impl Iterator<Item = ([u32; 2], &PixelSum)> {
        self.tiles.iter().flat_map(Tile::pixels)
    }
}

#[cfg(test)]
mod tests {
    use super::{Film, FilmPoint};
    use crate::exposure::in_passes;
    use crate::{FilmSettings, Image, Sampler, expose};

    const SETTINGS: FilmSettings =
        FilmSettings { size: [37, 21], samples: 5, seed: 1, threads: Some(1) };

    /// A picture that shows every bit of what the closure is given.
    fn noise(point: FilmPoint, sampler: &mut Sampler) -> [f32; 3] {
        [point.x * 1e-3, point.y, sampler.next_1d()]
    }

    /// accuracy.md C5.
    #[test]
    fn a_point_stays_in_its_pixel() {
        let largest = 1.0_f32.next_down();
        for pixel in [0, 1, 2, 3, 1000, 65_535] {
            for u in [0.0, 2.0_f32.powi(-24), 0.5, largest] {
                let point = FilmPoint::in_pixel([pixel; 2], [u; 2], [65_536; 2]);
                let edges = pixel as f32..(pixel + 1) as f32;
                assert!(edges.contains(&point.x), "{} for pixel {pixel}, u = {u}", point.x);
                assert!(edges.contains(&point.y), "{} for pixel {pixel}, u = {u}", point.y);
            }
        }
    }

    #[test]
    fn the_picture_does_not_depend_on_threads() {
        let hashes = [Some(1), Some(2), Some(5), None]
            .map(|threads| expose(&FilmSettings { threads, ..SETTINGS }, noise).hash());
        assert_eq!(hashes, [hashes[0]; 4], "1, 2, 5 and all threads");
    }

    #[test]
    fn the_picture_does_not_depend_on_passes() {
        let mut film = Film::new(SETTINGS.size).expect("a small film");
        film.expose(SETTINGS.seed, SETTINGS.samples, &noise, &|| false, &|_| ());
        assert_eq!(film.image().hash(), expose(&SETTINGS, noise).hash(), "one pass and many");
    }

    #[test]
    fn the_seed_changes_the_picture() {
        let other = expose(&FilmSettings { seed: 2, ..SETTINGS }, noise);
        assert_ne!(other.hash(), expose(&SETTINGS, noise).hash(), "the hash of seeds 1 and 2");
    }

    #[test]
    fn a_single_pixel_is_that_of_the_whole_picture() {
        let whole = expose(&SETTINGS, noise);
        let mut film = Film::single_pixel(SETTINGS.size, [30, 20]).expect("a small film");
        film.expose(SETTINGS.seed, SETTINGS.samples, &noise, &|| false, &|_| ());
        assert_eq!(film.image().pixel(0, 0), whole.pixel(30, 20), "pixel (30, 20)");
        assert_eq!(film.total_samples(), 5, "samples");
    }

    #[test]
    fn a_pixel_is_the_mean_of_its_samples() {
        // 2²⁴ + 1 is no f32: the sum of these would be wrong without f64.
        let large = 16_777_216.0;
        let settings = FilmSettings { size: [1, 1], samples: 4, seed: 0, threads: Some(1) };
        let calls = std::sync::atomic::AtomicU32::new(0);
        let image = expose(&settings, |_, _| {
            let first = calls.fetch_add(1, std::sync::atomic::Ordering::Relaxed) == 0;
            [if first { large } else { 4.0 / 3.0 }; 3]
        });
        assert_eq!(image.pixel(0, 0)[0], 4_194_305.0, "the mean");
    }

    /// accuracy.md C8.
    #[test]
    fn narrow_pictures_have_all_their_pixels() {
        for size in [[1, 1], [1, 40], [40, 1], [16, 16], [17, 33]] {
            let settings = FilmSettings { size, ..SETTINGS };
            let image = expose(&settings, |point, _| [point.x.floor(), point.y.floor(), 1.0]);
            for y in 0..size[1] {
                for x in 0..size[0] {
                    let expected = [x as f32, y as f32, 1.0];
                    assert_eq!(image.pixel(x, y), expected, "pixel ({x}, {y}) of {size:?}");
                }
            }
        }
    }

    /// accuracy.md G3.
    #[test]
    fn samples_that_are_not_finite_are_counted_and_left_out() {
        let mut film = Film::new([3, 1]).expect("a small film");
        let radiance = |point: FilmPoint, sampler: &mut Sampler| match point.x {
            x if x < 1.0 => [1.0; 3],
            x if x < 2.0 => [f32::MAX; 3],
            _ if sampler.next_1d() < 0.5 => [0.0, f32::NEG_INFINITY, f32::INFINITY],
            _ => [2.0; 3],
        };
        in_passes(64, |samples| {
            film.expose(0, samples, &radiance, &|| false, &|_| ());
            true
        });
        let expected = [[1.0; 3], [f32::MAX; 3], [2.0; 3]];
        assert_eq!(film.image().pixels, expected, "the means of the finite samples");
        let count = film.non_finite_samples();
        assert!((10..54).contains(&count), "{count} of 64 samples were not finite");
        assert_eq!(film.first_non_finite_pixel(), Some([2, 0]), "the pixel");
        let strict = film.strict_image();
        assert!(strict.pixel(2, 0)[0].is_nan(), "a test sees {:?}", strict.pixel(2, 0));
    }

    #[test]
    fn a_pixel_without_a_finite_sample_is_magenta() {
        let mut film = Film::new([1, 1]).expect("a small film");
        film.expose(0, 3, &|_, _: &mut Sampler| [f32::NAN; 3], &|| false, &|_| ());
        assert_eq!(film.image().to_srgb8(), [255, 0, 255], "the bytes");
    }

    #[test]
    fn a_film_without_samples_is_black_and_a_stopped_one_keeps_what_it_has() {
        let mut film = Film::new([40, 40]).expect("a small film");
        assert_eq!(film.image(), Image::new(40, 40), "before the first sample");
        film.expose(0, 2, &|_, _: &mut Sampler| [1.0; 3], &|| false, &|_| ());
        film.expose(0, 2, &|_, _: &mut Sampler| [9.0; 3], &|| true, &|_| ());
        assert_eq!(film.samples(), [2, 2], "samples after a stop");
        assert_eq!(film.image().max(), [1.0; 3], "the picture after a stop");
    }
}
