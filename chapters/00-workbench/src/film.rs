//! The film: what the samples of each pixel add up to.

use std::collections::TryReserveError;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};

use crate::estimate::LikelyError;
use crate::need::{self, Need};
use crate::pixel_sum::PixelSum;
use crate::portion::Portion;
use crate::spread::{self, Spread};
use crate::tile::Tile;
use crate::{Estimate, FilmPoint, Image, Sampler};

/// How many samples of a pixel are taken before they are added to it: few enough to stay close to
/// the processor.
const BATCH: u32 = 16;

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
        for y in (0..extent[1]).step_by(Tile::SIDE as usize) {
            for x in (0..extent[0]).step_by(Tile::SIDE as usize) {
                let size = [extent[0] - x, extent[1] - y].map(|rest| rest.min(Tile::SIDE));
                tiles.try_reserve(1)?;
                tiles.push(Tile::new([origin[0] + x, origin[1] + y], size)?);
            }
        }
        Ok(Self { size, origin, extent, tiles })
    }

    /// The same, but the film also collects what it needs to estimate its error.
    pub(crate) fn estimating(size: [u32; 2]) -> Result<Self, TryReserveError> {
        Self::new(size)?.with_spreads()
    }

    /// A film that holds a single pixel of a larger picture, and estimates its error.
    pub(crate) fn estimating_pixel(
        size: [u32; 2],
        pixel: [u32; 2],
    ) -> Result<Self, TryReserveError> {
        Self::single_pixel(size, pixel)?.with_spreads()
    }

    fn with_spreads(mut self) -> Result<Self, TryReserveError> {
        for tile in &mut self.tiles {
            tile.spreads.try_reserve_exact(tile.pixels.len())?;
            tile.spreads.resize(tile.pixels.len(), Spread::default());
        }
        Ok(self)
    }

    /// The same film, which in addition finds out where samples are needed most.
    pub(crate) fn sharing(mut self) -> Result<Self, TryReserveError> {
        for tile in &mut self.tiles {
            tile.needs.try_reserve_exact(tile.pixels.len())?;
            tile.needs.resize(tile.pixels.len(), Need::default());
        }
        Ok(self)
    }

    /// Adds samples to the pixels, on the current pool of threads.
    ///
    /// `stop` is asked before each tile; the tiles that follow stay as they are. `done` hears of
    /// the samples of each tile.
    ///
    /// Tiles are handed out one at a time. Left to itself, rayon deals them in packs, four or so a
    /// thread, and a pack that was begun is not divided again: at the end, one thread would work
    /// through what is left of its pack while the others wait.
    pub(crate) fn expose<R: Into<[f32; 3]>>(
        &mut self,
        seed: u64,
        portion: Portion,
        radiance: &(impl Fn(FilmPoint, &mut Sampler) -> R + Sync),
        stop: &(impl Fn() -> bool + Sync),
        done: &(impl Fn(u64) + Sync),
    ) {
        let size = self.size;
        self.tiles.par_iter_mut().with_max_len(1).for_each(|tile| {
            if stop() {
                return;
            }
            let is_even = matches!(portion, Portion::Even(_));
            let mut batch = [[0.0; 3]; BATCH as usize];
            let mut starts = [const { None }; BATCH as usize];
            let mut added = 0;
            for (i, pixel) in (0..tile.pixels.len()).zip(tile.coordinates()) {
                let index = u64::from(pixel[1]) * u64::from(size[0]) + u64::from(pixel[0]);
                let mut sample = tile.pixels[i].taken;
                let due = tile.due(i, portion);
                let end = sample + due;
                added += u64::from(due);
                while sample < end {
                    let batch = &mut batch[..BATCH.min(end - sample) as usize];
                    // Where paths start does not depend on other paths: together these are computed
                    // side by side, each by itself it would have to wait for the end of the last one.
                    for start in &mut starts[..batch.len()] {
                        let mut sampler = Sampler::new(seed, index, u64::from(sample));
                        let point = FilmPoint::in_pixel(pixel, sampler.next_2d(), size);
                        *start = Some((point, sampler));
                        sample += 1;
                    }
                    for (slot, start) in batch.iter_mut().zip(&mut starts) {
                        let Some((point, sampler)) = start else { continue };
                        *slot = radiance(*point, sampler).into();
                    }
                    tile.add(i, batch, is_even);
                }
            }
            done(added);
        });
    }

    /// Decides how many samples each pixel should hold, `average` on average and at most `most`: those
    /// in noisy surroundings more than others. Returns the most that one of them lacks.
    pub(crate) fn share_out(&mut self, average: u32, most: u32) -> u32 {
        let width = self.extent[0] as usize;
        let pixels = self.pixel_count() as usize;
        let (mut variances, mut held) = (vec![f64::NAN; pixels], vec![0; pixels]);
        let place = self.place();
        for tile in &self.tiles {
            for ((pixel, sum), need) in tile.pixels().zip(&tile.needs) {
                variances[place(pixel)] = need.relative_variance().unwrap_or(f64::NAN);
                held[place(pixel)] = sum.taken;
            }
        }
        let total = u64::from(average) * pixels as u64;
        let wanted = need::shares(&need::needs(&variances, width), &held, total, most);
        for tile in &mut self.tiles {
            for (pixel, need) in tile.coordinates().zip(&mut tile.needs) {
                need.wanted = wanted[place(pixel)];
            }
        }
        wanted.iter().zip(&held).map(|(wanted, held)| wanted - held).max().unwrap_or(0)
    }

    /// Whether the film finds out where samples are needed most.
    pub(crate) fn shares(&self) -> bool {
        self.tiles.iter().any(|tile| !tile.needs.is_empty())
    }

    /// Which place a pixel has among those of the film, row by row.
    fn place(&self) -> impl Fn([u32; 2]) -> usize + use<> {
        let ([left, top], width) = (self.origin, self.extent[0] as usize);
        move |[x, y]| (y - top) as usize * width + (x - left) as usize
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
        self.image_of(|sum| sum.strict(sum.mean()))
    }

    fn image_of(&self, value: impl Fn(&PixelSum) -> [f32; 3]) -> Image {
        self.arranged(self.pixels().map(|(pixel, sum)| (pixel, value(sum))))
    }

    /// The picture with these values of its pixels.
    fn arranged(&self, values: impl Iterator<Item = ([u32; 2], [f32; 3])>) -> Image {
        let mut image = Image::new(self.extent[0], self.extent[1]);
        let place = self.place();
        for (pixel, value) in values {
            image.pixels[place(pixel)] = value;
        }
        image
    }

    /// The strict picture with its variance and its error.
    pub(crate) fn strict_estimate(&self) -> Estimate {
        let variance = |(pixel, sum, spread): ([u32; 2], &PixelSum, &Spread)| {
            let variance = spread.variance_of_mean(sum.finite);
            (pixel, sum.strict(variance.map(|variance| variance as f32)))
        };
        Estimate {
            image: self.strict_image(),
            variance_of_mean: self.arranged(self.spreads().map(variance)),
            samples: self.samples()[0],
            counts: self.counts(),
            likely_error: self.likely_error().filter(|_| self.non_finite_samples() == 0),
        }
    }

    /// The relative error ε that the picture states of itself, as a fraction of 1.
    ///
    /// ```text
    /// ε² = expected relMSE + margin,   relMSE = mean of (m − μ)² / (μ² + 0.01)
    /// ```
    ///
    /// over all pixels and channels, where m is what a pixel holds and μ what it would hold after
    /// infinitely many samples. The true √relMSE lies below ε in at least 95 % of all seeds, unless
    /// most of the error is that of one or two pixels whose light is so rare that they have not
    /// found it. Pixels that have taken samples, but hardly a finite one, are left out like those
    /// samples.
    ///
    /// `None` if the stage does not estimate, below four samples a pixel, and when no pixel has
    /// four finite samples.
    #[must_use]
    pub fn estimated_error(&self) -> Option<f64> {
        self.likely_error().map(LikelyError::bound)
    }

    fn likely_error(&self) -> Option<LikelyError> {
        if self.samples()[0] < spread::FEWEST {
            return None;
        }
        LikelyError::of(self.spreads().filter_map(|(_, sum, s)| s.relative_variances(sum.finite)))
    }

    /// Whether no sample has brought any light.
    pub(crate) fn is_black(&self) -> bool {
        self.pixels().all(|(_, sum)| sum.sum == [0.0; 3])
    }

    /// The fewest and the most samples that a pixel holds.
    #[must_use]
    pub fn samples(&self) -> [u32; 2] {
        let taken = || self.pixels().map(|(_, sum)| sum.taken);
        [taken().min().unwrap_or(0), taken().max().unwrap_or(0)]
    }

    /// The samples of each pixel, row by row.
    fn counts(&self) -> Vec<u32> {
        let mut counts = vec![0; self.pixel_count() as usize];
        let place = self.place();
        for (pixel, sum) in self.pixels() {
            counts[place(pixel)] = sum.taken;
        }
        counts
    }

    /// All samples of all pixels.
    #[must_use]
    pub fn total_samples(&self) -> u64 {
        self.pixels().map(|(_, sum)| u64::from(sum.taken)).sum()
    }

    /// Samples a pixel, rounded down where pixels differ.
    pub(crate) fn average_samples(&self) -> u32 {
        (self.total_samples() / self.pixel_count().max(1)) as u32
    }

    /// By how many samples pixels hold fewer than the average, added up.
    pub(crate) fn samples_below_average(&self) -> u64 {
        let average = self.average_samples();
        self.pixels().map(|(_, sum)| u64::from(average.saturating_sub(sum.taken))).sum()
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

    /// How many pixels there are.
    pub(crate) fn pixel_count(&self) -> u64 {
        u64::from(self.extent[0]) * u64::from(self.extent[1])
    }

    fn pixels(&self) -> impl Iterator<Item = ([u32; 2], &PixelSum)> {
        self.tiles.iter().flat_map(Tile::pixels)
    }

    /// The pixels with their spreads; none if the film does not estimate its error.
    fn spreads(&self) -> impl Iterator<Item = ([u32; 2], &PixelSum, &Spread)> {
        let tiles = self.tiles.iter();
        let pixels = tiles.flat_map(|tile| tile.pixels().zip(&tile.spreads));
        pixels.map(|((pixel, sum), spread)| (pixel, sum, spread))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::thread;
    use std::time::{Duration, Instant};

    use super::Film;
    use crate::goal::Goal;
    use crate::portion::Portion;
    use crate::tile::Tile;
    use crate::{FilmPoint, FilmSettings, Image, Sampler, expose};

    const SETTINGS: FilmSettings =
        FilmSettings { size: [37, 21], samples: 5, seed: 1, threads: Some(1) };

    /// A picture that shows every bit of what the closure is given.
    fn noise(point: FilmPoint, sampler: &mut Sampler) -> [f32; 3] {
        [point.x * 1e-3, point.y, sampler.next_1d()]
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
        film.expose(SETTINGS.seed, Portion::Even(SETTINGS.samples), &noise, &|| false, &|_| ());
        assert_eq!(film.image().hash(), expose(&SETTINGS, noise).hash(), "one pass and many");
    }

    /// A thread that is busy with one tile keeps none of the others to itself: the rest of the
    /// picture is finished meanwhile.
    #[test]
    fn a_slow_tile_holds_up_no_other() {
        let tiles = 8 * 8;
        let mut film = Film::new([8 * Tile::SIDE, 8 * Tile::SIDE]).expect("a small film");
        let done = AtomicU64::new(0);
        let others = || done.load(Ordering::SeqCst) / u64::from(Tile::SIDE * Tile::SIDE);
        let slow = |point: FilmPoint, _: &mut Sampler| {
            let deadline = Instant::now() + Duration::from_secs(10);
            // The first pixel of the first tile: it waits until all other tiles are done.
            while point.x < 1.0 && point.y < 1.0 && others() < tiles - 1 {
                assert!(Instant::now() < deadline, "{} of {tiles} tiles were done", others());
                thread::yield_now();
            }
            [0.0; 3]
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("two threads");
        pool.install(|| {
            let add = |samples| {
                done.fetch_add(samples, Ordering::SeqCst);
            };
            film.expose(0, Portion::Even(1), &slow, &|| false, &add);
        });
        assert_eq!(others(), tiles, "tiles");
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
        film.expose(SETTINGS.seed, Portion::Even(SETTINGS.samples), &noise, &|| false, &|_| ());
        assert_eq!(film.image().pixel(0, 0), whole.pixel(30, 20), "pixel (30, 20)");
        assert_eq!(film.total_samples(), 5, "samples");
    }

    #[test]
    fn a_pixel_is_the_mean_of_its_samples() {
        // 2²⁴ + 1 is no f32: the sum of these would be wrong without f64.
        let large = 16_777_216.0;
        let settings = FilmSettings { size: [1, 1], samples: 4, seed: 0, threads: Some(1) };
        let calls = AtomicU64::new(0);
        let image = expose(&settings, |_, _| {
            let first = calls.fetch_add(1, Ordering::Relaxed) == 0;
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
        Goal { samples: 64, error: None }.pursue(&mut film, |film, portion| {
            film.expose(0, portion, &radiance, &|| false, &|_| ());
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
        film.expose(0, Portion::Even(3), &|_, _: &mut Sampler| [f32::NAN; 3], &|| false, &|_| ());
        assert_eq!(film.image().to_srgb8(), [255, 0, 255], "the bytes");
    }

    #[test]
    fn a_film_without_samples_is_black_and_a_stopped_one_keeps_what_it_has() {
        let mut film = Film::new([40, 40]).expect("a small film");
        assert_eq!(film.image(), Image::new(40, 40), "before the first sample");
        film.expose(0, Portion::Even(2), &|_, _: &mut Sampler| [1.0; 3], &|| false, &|_| ());
        film.expose(0, Portion::Even(2), &|_, _: &mut Sampler| [9.0; 3], &|| true, &|_| ());
        assert_eq!(film.samples(), [2, 2], "samples after a stop");
        assert_eq!(film.image().max(), [1.0; 3], "the picture after a stop");
    }
}
