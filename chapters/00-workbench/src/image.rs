//! A finished picture.

use std::path::Path;

use crate::spread::FLOOR;
use crate::{Error, picture_file, srgb};

/// A finished picture in linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Linear RGB with Rec. 709 primaries, row by row from the top: `width` · `height` of them.
    pub pixels: Vec<[f32; 3]>,
}

impl Image {
    /// A black picture.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![[0.0; 3]; width as usize * height as usize] }
    }

    /// The pixel in column `x` and row `y`, counted from the top left corner.
    ///
    /// Panics when the picture has no such pixel.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> [f32; 3] {
        assert!(x < self.width, "column {x} of a picture {} pixels wide", self.width);
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// Writes the picture: 8-bit sRGB, clamped, to a `.png`, and the very floats to an `.exr`.
    ///
    /// The file appears when it is complete; on an error there is none, or the old one.
    pub fn save(&self, path: &Path) -> Result<(), Error> {
        picture_file::save(self, path)
    }

    /// Reads an EXR file with at least the channels R, G and B; the floats are taken as they are.
    pub fn load_exr(path: &Path) -> Result<Self, Error> {
        picture_file::load_exr(path)
    }

    /// Reads a PNG file and decodes it to linear light. Alpha is ignored, 16 bits are made 8.
    ///
    /// [`Image::to_srgb8`] gives back the file's bytes.
    pub fn load_png(path: &Path) -> Result<Self, Error> {
        let (size, bytes) = picture_file::load_png_bytes(path)?;
        Ok(Self::from_srgb8(size[0], size[1], &bytes))
    }

    /// The picture that these sRGB bytes show, three a pixel, row by row from the top.
    ///
    /// Panics when there are not 3 · `width` · `height` of them.
    #[must_use]
    pub fn from_srgb8(width: u32, height: u32, bytes: &[u8]) -> Self {
        let (triples, rest) = bytes.as_chunks::<3>();
        let expected = width as usize * height as usize;
        assert!(
            triples.len() == expected && rest.is_empty(),
            "{} bytes for {width} × {height} pixels",
            bytes.len()
        );
        let pixels = triples.iter().map(|bytes| bytes.map(srgb::decode)).collect();
        Self { width, height, pixels }
    }

    /// The bytes of the PNG file: three a pixel, row by row from the top; magenta where a value is
    /// NaN.
    #[must_use]
    pub fn to_srgb8(&self) -> Vec<u8> {
        self.pixels.iter().flat_map(|&pixel| srgb::encode_pixel(pixel)).collect()
    }

    /// A fingerprint of the size and of every bit of every float: FNV-1a, 64 bits.
    ///
    /// All NaNs count as the same one, because their bits differ between machines.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let floats = self.pixels.as_flattened().iter().map(|value| {
            if value.is_nan() { f32::NAN.to_bits() & 0x7fff_ffff } else { value.to_bits() }
        });
        [self.width, self.height]
            .into_iter()
            .chain(floats)
            .flat_map(u32::to_le_bytes)
            .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
            })
    }

    /// The mean of each channel, summed in f64 from the first pixel to the last.
    #[must_use]
    pub fn mean(&self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for pixel in &self.pixels {
            for channel in 0..3 {
                sum[channel] += f64::from(pixel[channel]);
            }
        }
        sum.map(|sum| sum / self.pixels.len() as f64)
    }

    /// The relative mean squared error of this picture against `reference`.
    ///
    /// ```text
    /// relMSE = mean over pixels and channels of (x − r)² / (r² + 0.01)
    /// ```
    ///
    /// Summed in f64; NaN if a value of either is NaN. Of a picture of independent random samples
    /// it falls as 1/n. If the reference has noise of its own, its relMSE is part of the result.
    ///
    /// Panics when the sizes differ.
    #[must_use]
    pub fn rel_mse(&self, reference: &Self) -> f64 {
        let sizes = [[self.width, self.height], [reference.width, reference.height]];
        assert!(sizes[0] == sizes[1], "a picture of {:?} against one of {:?}", sizes[0], sizes[1]);
        let (values, references) = (self.pixels.as_flattened(), reference.pixels.as_flattened());
        let terms = values.iter().zip(references).map(|(&x, &r)| {
            let (x, r) = (f64::from(x), f64::from(r));
            (x - r) * (x - r) / (r * r + FLOOR)
        });
        terms.sum::<f64>() / values.len() as f64
    }

    /// The smallest value of each channel; NaN if one of them is NaN.
    #[must_use]
    pub fn min(&self) -> [f32; 3] {
        self.extreme(|value, extreme| value < extreme)
    }

    /// The largest value of each channel; NaN if one of them is NaN.
    #[must_use]
    pub fn max(&self) -> [f32; 3] {
        self.extreme(|value, extreme| value > extreme)
    }

    /// The value of each channel that is more extreme than the others. Unlike `f32::min`, this
    /// does not pass over NaN.
    fn extreme(&self, more_extreme: impl Fn(f32, f32) -> bool) -> [f32; 3] {
        let mut extreme = self.pixels.first().copied().unwrap_or([f32::NAN; 3]);
        for pixel in &self.pixels {
            for channel in 0..3 {
                let value = pixel[channel];
                if value.is_nan() || more_extreme(value, extreme[channel]) {
                    extreme[channel] = value;
                }
            }
        }
        extreme
    }
}

#[cfg(test)]
mod tests {
    use super::Image;

    fn two_pixels(first: [f32; 3], second: [f32; 3]) -> Image {
        Image { width: 2, height: 1, pixels: vec![first, second] }
    }

    #[test]
    fn mean_minimum_and_maximum_are_per_channel() {
        let image = two_pixels([1.0, 5.0, -1.0], [3.0, 1.0, 1.0]);
        assert_eq!(image.mean(), [2.0, 3.0, 0.0], "the mean");
        assert_eq!(image.min(), [1.0, 1.0, -1.0], "the minimum");
        assert_eq!(image.max(), [3.0, 5.0, 1.0], "the maximum");
    }

    #[test]
    fn nan_is_never_hidden() {
        for image in [two_pixels([f32::NAN; 3], [1.0; 3]), two_pixels([1.0; 3], [f32::NAN; 3])] {
            assert!(image.min()[0].is_nan(), "the minimum is {:?}", image.min());
            assert!(image.max()[0].is_nan(), "the maximum is {:?}", image.max());
            assert!(image.mean()[0].is_nan(), "the mean is {:?}", image.mean());
        }
    }

    /// Pinned, because snapshots store it.
    #[test]
    fn the_hash_is_the_published_one() {
        let empty = Image { width: 0, height: 0, pixels: Vec::new() };
        // FNV-1a of eight zero bytes: the offset basis times the prime to the eighth power.
        let expected = (0..8)
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, _| hash.wrapping_mul(0x0000_0100_0000_01b3));
        assert_eq!(empty.hash(), expected, "the hash of nothing");
        assert_ne!(Image::new(1, 2).hash(), Image::new(2, 1).hash(), "the size counts");
        let zeros = (two_pixels([0.0; 3], [0.0; 3]), two_pixels([0.0; 3], [0.0, 0.0, -0.0]));
        assert_ne!(zeros.0.hash(), zeros.1.hash(), "every bit counts");
        let nans = (two_pixels([f32::NAN; 3], [0.0; 3]), two_pixels([-f32::NAN; 3], [0.0; 3]));
        assert_eq!(nans.0.hash(), nans.1.hash(), "the sign of NaN does not count");
    }

    #[test]
    fn the_relative_error_is_the_one_defined() {
        let reference = two_pixels([0.0, 0.3, 1.0], [2.0, 0.0, 0.0]);
        let image = two_pixels([0.1, 0.3, 0.5], [2.0, 0.0, -0.2]);
        let expected = (0.01 / 0.01 + 0.25 / 1.01 + 0.04 / 0.01) / 6.0;
        let found = image.rel_mse(&reference);
        assert!((found - expected).abs() < 1e-6, "{found}, by hand {expected}");
        assert_eq!(reference.rel_mse(&reference), 0.0, "against itself");
        let nan = two_pixels([0.0; 3], [f32::NAN, 0.0, 0.0]);
        assert!(nan.rel_mse(&reference).is_nan() && reference.rel_mse(&nan).is_nan(), "NaN");
    }

    #[test]
    fn bytes_survive_the_way_through_linear_light() {
        let bytes: Vec<u8> = (0..=254).collect();
        assert_eq!(Image::from_srgb8(17, 5, &bytes).to_srgb8(), bytes, "the bytes");
    }
}
