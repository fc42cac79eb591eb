//! A part of the film.

use std::collections::TryReserveError;

use crate::need::Need;
use crate::pixel_sum::PixelSum;
use crate::portion::Portion;
use crate::spread::Spread;

/// A rectangle of pixels that one thread works on at a time.
#[derive(Clone, Debug)]
pub(crate) struct Tile {
    /// Its upper left pixel.
    origin: [u32; 2],
    /// In pixels; the last tile of a row may be narrow.
    width: u32,
    /// What they have collected, row by row.
    pub(crate) pixels: Vec<PixelSum>,
    /// One for each pixel if the film estimates its error, else none.
    pub(crate) spreads: Vec<Spread>,
    /// One for each pixel if the film shares its samples out, else none.
    pub(crate) needs: Vec<Need>,
}

impl Tile {
    /// The side of a tile in pixels: small enough to keep all cores busy to the end, large enough that
    /// handing tiles out costs nothing.
    pub(crate) const SIDE: u32 = 16;

    /// A tile without samples, at most [`Tile::SIDE`] wide and high.
    ///
    /// Fails when the memory cannot be had.
    pub(crate) fn new(
        origin: [u32; 2],
        [width, height]: [u32; 2],
    ) -> Result<Self, TryReserveError> {
        let count = (width * height) as usize;
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(count)?;
        pixels.resize(count, PixelSum::default());
        Ok(Self { origin, width, pixels, spreads: Vec::new(), needs: Vec::new() })
    }

    /// The coordinates of the tile's pixels, row by row.
    pub(crate) fn coordinates(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let ([x, y], width) = (self.origin, self.width);
        (0..).map(move |i| [x + i % width, y + i / width])
    }

    /// The pixels of the tile with their coordinates, row by row.
    pub(crate) fn pixels(&self) -> impl Iterator<Item = ([u32; 2], &PixelSum)> {
        self.coordinates().zip(&self.pixels)
    }

    /// Adds samples to pixel number `i` of the tile; `is_even` if all pixels get as many.
    ///
    /// Whether spreads are wanted is asked here, once for a batch of samples.
    pub(crate) fn add(&mut self, i: usize, batch: &[[f32; 3]], is_even: bool) {
        let sum = &mut self.pixels[i];
        let Some(spread) = self.spreads.get_mut(i) else {
            for &radiance in batch {
                sum.add(radiance);
            }
            return;
        };
        let mut need = self.needs.get_mut(i).filter(|_| is_even);
        for &radiance in batch {
            if sum.add(radiance) {
                spread.add(sum.finite - 1, radiance);
                if let Some(need) = &mut need {
                    need.add(radiance);
                }
            }
        }
    }

    /// How many samples pixel number `i` gets of a portion.
    pub(crate) fn due(&self, i: usize, portion: Portion) -> u32 {
        match portion {
            Portion::Even(samples) => samples,
            Portion::Wanted(most) => {
                let wanted = self.needs.get(i).map_or(0, |need| need.wanted);
                wanted.saturating_sub(self.pixels[i].taken).min(most)
            }
        }
    }
}
