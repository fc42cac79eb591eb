//! What two pictures have not in common, in numbers and as a picture.

use std::fmt;
use workbench::Image;

/// How much two pictures differ as 8-bit sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Difference {
    /// They are not of the same size: width and height of the first and of the second.
    Size([u32; 2], [u32; 2]),
    /// They show something else.
    Pixels {
        /// Pixels that are not the same in all channels.
        count: usize,
        /// All pixels.
        of: usize,
        /// The largest difference of a channel, 1 to 255.
        worst: u8,
        /// Column and row of the first pixel with that difference.
        at: [usize; 2],
    },
}

impl Difference {
    /// `None` for two pictures that look the same.
    pub(crate) fn between(expected: &Image, got: &Image) -> Option<Self> {
        let size = |image: &Image| [image.width, image.height];
        if size(expected) != size(got) {
            return Some(Self::Size(size(expected), size(got)));
        }
        let (a, b) = (expected.to_srgb8(), got.to_srgb8());
        let (mut count, mut worst, mut at) = (0, 0, 0);
        let pixels = a.as_chunks::<3>().0.iter().zip(b.as_chunks::<3>().0);
        for (i, (a, b)) in pixels.enumerate().filter(|(_, (a, b))| a != b) {
            count += 1;
            let largest = (0..3).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap_or(0);
            if largest > worst {
                (worst, at) = (largest, i);
            }
        }
        let width = got.width as usize;
        let at = [at % width.max(1), at / width.max(1)];
        (count > 0).then_some(Self::Pixels { count, of: got.pixels.len(), worst, at })
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size(expected, got) => write!(
                f,
                "{} x {} pixels were expected, {} x {} were got",
                expected[0], expected[1], got[0], got[1]
            ),
            Self::Pixels { count, of, worst, at: [x, y] } => {
                write!(f, "{count} of {of} pixels differ, by up to {worst} of 255 at ({x}, {y})")
            }
        }
    }
}

/// Expected, got and difference in one picture, from left to right.
///
/// The third part is black where the two agree; the smallest difference is plainly visible, and
/// larger ones are brighter. Where only one of the pictures has a pixel, it is compared with black.
pub(crate) fn side_by_side(expected: &Image, got: &Image) -> Image {
    let (a, b) = (expected.to_srgb8(), got.to_srgb8());
    let (width, height) = (expected.width.max(got.width), expected.height.max(got.height));
    let mut bytes = Vec::with_capacity(9 * width as usize * height as usize);
    for y in 0..height {
        let row = |image: &Image, bytes: &[u8]| -> Vec<[u8; 3]> {
            (0..width).map(|x| byte_pixel(image, bytes, x, y)).collect()
        };
        let (a, b) = (row(expected, &a), row(got, &b));
        let differences = a.iter().zip(&b).map(|(a, b)| {
            [0, 1, 2].map(|channel| match a[channel].abs_diff(b[channel]) {
                0 => 0,
                difference => difference.saturating_mul(4).saturating_add(60),
            })
        });
        bytes.extend(a.iter().chain(&b).copied().chain(differences).flatten());
    }
    Image::from_srgb8(3 * width, height, &bytes)
}

/// The pixel of a picture given as bytes; black outside it.
fn byte_pixel(image: &Image, bytes: &[u8], x: u32, y: u32) -> [u8; 3] {
    if x >= image.width || y >= image.height {
        return [0; 3];
    }
    bytes.as_chunks::<3>().0[y as usize * image.width as usize + x as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(width: u32, height: u32) -> Image {
        let bytes = vec![100; 3 * (width * height) as usize];
        Image::from_srgb8(width, height, &bytes)
    }

    #[test]
    fn equal_pictures_have_no_difference() {
        assert_eq!(Difference::between(&grey(4, 3), &grey(4, 3)), None, "grey and grey");
    }

    #[test]
    fn a_difference_below_one_level_of_255_is_none() {
        let mut nearly = grey(4, 3);
        nearly.pixels[5][1] *= 1.0 + 1e-6;
        assert_eq!(Difference::between(&grey(4, 3), &nearly), None, "one part in a million");
    }

    #[test]
    fn one_level_in_one_channel_is_counted_and_placed() {
        let mut bytes = grey(4, 3).to_srgb8();
        bytes[3 * 6 + 2] += 1;
        let changed = Image::from_srgb8(4, 3, &bytes);
        let expected = Difference::Pixels { count: 1, of: 12, worst: 1, at: [2, 1] };
        assert_eq!(Difference::between(&grey(4, 3), &changed), Some(expected), "blue at (2, 1)");
    }

    #[test]
    fn another_size_is_a_difference() {
        let expected = Difference::Size([4, 3], [3, 4]);
        assert_eq!(Difference::between(&grey(4, 3), &grey(3, 4)), Some(expected), "4×3 and 3×4");
    }

    #[test]
    fn the_picture_of_a_difference_is_black_but_for_what_differs() {
        let mut bytes = grey(4, 3).to_srgb8();
        bytes[3 * 6 + 2] += 1;
        let shown = side_by_side(&grey(4, 3), &Image::from_srgb8(4, 3, &bytes));
        assert_eq!([shown.width, shown.height], [12, 3], "three pictures wide");
        let pixels = shown.to_srgb8();
        let lit: Vec<usize> =
            (0..36).filter(|i| i % 12 >= 8 && pixels[3 * i..3 * i + 3] != [0; 3]).collect();
        assert_eq!(lit, [12 + 8 + 2], "lit pixels of the third part");
        assert_eq!(pixels[3 * 22 + 2], 64, "one level is shown as 64");
    }

    #[test]
    fn pictures_of_different_size_can_be_put_side_by_side() {
        let shown = side_by_side(&grey(4, 3), &grey(2, 5));
        assert_eq!([shown.width, shown.height], [12, 5], "the larger of both, three times");
    }
}
