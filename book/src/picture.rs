//! Pictures: 8-bit pixels, as a browser shows them.

use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageReader};

use crate::Result;

/// A picture of sRGB bytes with opacity, ready to be written as PNG.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// Red, green, blue, opacity of each pixel, row 0 on top.
    pub rgba: Vec<u8>,
}

impl From<&workbench::Image> for Picture {
    /// What the stages would write to a PNG file: clamped and sRGB-encoded.
    fn from(image: &workbench::Image) -> Self {
        let opaque = |rgb: &[u8]| [rgb[0], rgb[1], rgb[2], 255];
        let rgba = image.to_srgb8().chunks_exact(3).flat_map(opaque).collect();
        Self::new(image.width, image.height, rgba)
    }
}

impl Picture {
    /// # Panics
    ///
    /// If `rgba` does not hold four bytes for each pixel.
    #[must_use]
    pub fn new(width: u32, height: u32, rgba: Vec<u8>) -> Self {
        let pixels = width as usize * height as usize;
        assert_eq!(rgba.len(), 4 * pixels, "{} bytes for {width}×{height}", rgba.len());
        Self { width, height, rgba }
    }

    /// Pictures next to each other, tops aligned, with `gap` transparent pixels between them.
    ///
    /// What each of them shows is said in the caption, from left to right.
    #[must_use]
    pub fn side_by_side(pictures: &[Self], gap: u32) -> Self {
        let gaps = gap * (pictures.len().max(1) as u32 - 1);
        let width = pictures.iter().map(|p| p.width).sum::<u32>() + gaps;
        let height = pictures.iter().map(|p| p.height).max().unwrap_or(0);
        let mut strip = Self::transparent(width, height);
        let mut x = 0;
        for picture in pictures {
            strip.paste(picture, x, 0);
            x += picture.width + gap;
        }
        strip
    }

    /// Pictures below each other, left edges aligned, with `gap` transparent pixels between them.
    #[must_use]
    pub fn stacked(pictures: &[Self], gap: u32) -> Self {
        let gaps = gap * (pictures.len().max(1) as u32 - 1);
        let width = pictures.iter().map(|p| p.width).max().unwrap_or(0);
        let height = pictures.iter().map(|p| p.height).sum::<u32>() + gaps;
        let mut pile = Self::transparent(width, height);
        let mut y = 0;
        for picture in pictures {
            pile.paste(picture, 0, y);
            y += picture.height + gap;
        }
        pile
    }

    /// The part of the picture that starts at (`x`, `y`).
    ///
    /// # Panics
    ///
    /// If the part does not lie inside the picture.
    #[must_use]
    pub fn crop(&self, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> Self {
        assert!(
            x + width <= self.width && y + height <= self.height,
            "{width}×{height} at ({x}, {y}) of {}×{}",
            self.width,
            self.height
        );
        let pixels = (y..y + height).flat_map(|y| (x..x + width).map(move |x| (x, y)));
        Self::new(width, height, pixels.flat_map(|(x, y)| self.pixel(x, y)).collect())
    }

    /// Each pixel as a square of `factor` × `factor`, so that a reader can count them.
    #[must_use]
    pub fn enlarged(&self, factor: u32) -> Self {
        let [width, height] = [self.width * factor, self.height * factor];
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x / factor, y / factor)));
        Self::new(width, height, pixels.flat_map(|(x, y)| self.pixel(x, y)).collect())
    }

    /// Red, green, blue and opacity of a pixel; (0, 0) is on the top left.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        let i = self.index(x, y);
        [self.rgba[i], self.rgba[i + 1], self.rgba[i + 2], self.rgba[i + 3]]
    }

    /// Reads a PNG file.
    ///
    /// # Errors
    ///
    /// The file is not there, or not a PNG.
    pub fn load(file: &Path) -> Result<Self> {
        let image = ImageReader::open(file)?.decode()?.into_rgba8();
        Ok(Self::new(image.width(), image.height(), image.into_raw()))
    }

    /// The picture as a PNG file, without the opacity if the whole picture is opaque.
    ///
    /// # Errors
    ///
    /// The encoder refuses, for example a picture without pixels.
    pub fn png(&self) -> Result<Vec<u8>> {
        let is_opaque = self.rgba.chunks_exact(4).all(|pixel| pixel[3] == 255);
        let (bytes, kind) = if is_opaque {
            let rgb = self.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]);
            (rgb.collect(), ExtendedColorType::Rgb8)
        } else {
            (self.rgba.clone(), ExtendedColorType::Rgba8)
        };
        let mut file = Vec::new();
        PngEncoder::new_with_quality(&mut file, CompressionType::Best, FilterType::Adaptive)
            .write_image(&bytes, self.width, self.height, kind)?;
        Ok(file)
    }

    /// How `new` differs from this picture, in words; `None` if every pixel is the same.
    #[must_use]
    pub fn difference(&self, new: &Self) -> Option<String> {
        if [self.width, self.height] != [new.width, new.height] {
            let [w, h] = [self.width, self.height];
            return Some(format!("{w}×{h} pixels are now {}×{}", new.width, new.height));
        }
        let pairs = self.rgba.chunks_exact(4).zip(new.rgba.chunks_exact(4));
        let differing: Vec<_> = pairs.enumerate().filter(|(_, (a, b))| a != b).collect();
        let (first, _) = differing.first()?;
        let step = |(_, (a, b)): &(usize, (&[u8], &[u8]))| {
            a.iter().zip(*b).map(|(a, b)| a.abs_diff(*b)).max()
        };
        let largest = differing.iter().filter_map(step).max().unwrap_or(0);
        let [x, y] = [first % self.width as usize, first / self.width as usize];
        let count = differing.len();
        Some(format!("{count} pixels differ, by up to {largest} of 255, the first at ({x}, {y})"))
    }

    fn transparent(width: u32, height: u32) -> Self {
        Self::new(width, height, vec![0; 4 * width as usize * height as usize])
    }

    fn paste(&mut self, picture: &Self, x: u32, y: u32) {
        let row = 4 * picture.width as usize;
        for j in 0..picture.height {
            let to = self.index(x, y + j);
            let from = picture.index(0, j);
            self.rgba[to..to + row].copy_from_slice(&picture.rgba[from..from + row]);
        }
    }

    fn index(&self, x: u32, y: u32) -> usize {
        4 * (y as usize * self.width as usize + x as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::Picture;

    /// A picture whose red counts the pixels.
    fn counted(width: u32, height: u32) -> Picture {
        let pixel = |i: u32| [i as u8, 0, 0, 255];
        Picture::new(width, height, (0..width * height).flat_map(pixel).collect())
    }

    #[test]
    fn a_render_looks_as_its_png_file_would() {
        let pixels = vec![[0.0, 0.5, 2.0], [-1.0, 1.0, 0.18]];
        let image = workbench::Image { width: 2, height: 1, pixels };
        let picture = Picture::from(&image);
        assert_eq!(picture.rgba, [0, 188, 255, 255, 0, 255, 118, 255], "clamped sRGB, opaque");
    }

    #[test]
    fn strips_and_piles_keep_every_pixel() {
        let strip = Picture::side_by_side(&[counted(2, 1), counted(1, 2)], 3);
        assert_eq!([strip.width, strip.height], [6, 2], "size of the strip");
        assert_eq!(strip.pixel(1, 0), [1, 0, 0, 255], "first picture");
        assert_eq!(strip.pixel(2, 0), [0; 4], "the gap is transparent");
        assert_eq!(strip.pixel(5, 1), [1, 0, 0, 255], "second picture");

        let pile = Picture::stacked(&[counted(2, 1), counted(1, 2)], 3);
        assert_eq!([pile.width, pile.height], [2, 6], "size of the pile");
        assert_eq!(pile.pixel(0, 5), [1, 0, 0, 255], "second picture");
    }

    #[test]
    fn parts_and_enlargements_show_the_same_pixels() {
        let picture = counted(4, 3);
        assert_eq!(picture.crop([1, 1], [2, 2]).pixel(1, 1), picture.pixel(2, 2), "a part");
        assert_eq!(picture.enlarged(3).pixel(11, 8), picture.pixel(3, 2), "an enlargement");
    }

    #[test]
    fn a_single_byte_is_a_difference() {
        let old = counted(4, 3);
        let mut new = old.clone();
        new.rgba[4 * 6] += 2;
        assert_eq!(old.difference(&old), None, "the same picture");
        let difference = old.difference(&new).expect("one byte differs");
        assert_eq!(difference, "1 pixels differ, by up to 2 of 255, the first at (2, 1)");
        assert!(old.difference(&counted(3, 4)).is_some(), "another size");
    }
}
