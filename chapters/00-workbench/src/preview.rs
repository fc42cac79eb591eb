//! The picture in the terminal: two pixels a character, one above the other.

use std::fmt::Write;

use crate::{Image, srgb};

/// The picture as lines of half blocks in 24-bit colour, at most `columns` wide.
///
/// A larger picture is scaled down by averaging linear light; a smaller one stays as it is.
pub(crate) fn half_blocks(image: &Image, columns: u32) -> String {
    let width = image.width.min(columns.max(1));
    let scale = f64::from(image.width) / f64::from(width);
    let height = ((f64::from(image.height) / scale).round() as u32).max(1);
    let color = |x, y| srgb::encode_pixel(average(image, [x, y], [width, height]));
    let mut text = String::new();
    for y in (0..height).step_by(2) {
        for x in 0..width {
            let [r, g, b] = color(x, y);
            // Writing to a string cannot fail.
            let _ = write!(text, "\x1b[38;2;{r};{g};{b}m");
            if y + 1 < height {
                let [r, g, b] = color(x, y + 1);
                let _ = write!(text, "\x1b[48;2;{r};{g};{b}m");
            }
            text.push('▀');
        }
        text.push_str("\x1b[0m\n");
    }
    text
}

/// The mean of the pixels of `image` that lie under one pixel of a picture of size `small`.
fn average(image: &Image, pixel: [u32; 2], small: [u32; 2]) -> [f32; 3] {
    let range = |i: u32, small: u32, large: u32| {
        let edge = |i: u32| (u64::from(i) * u64::from(large) / u64::from(small)) as u32;
        edge(i)..edge(i + 1).max(edge(i) + 1)
    };
    let mut sum = [0.0_f32; 3];
    let mut count = 0.0;
    for y in range(pixel[1], small[1], image.height) {
        for x in range(pixel[0], small[0], image.width) {
            let value = image.pixel(x, y);
            for channel in 0..3 {
                sum[channel] += value[channel];
            }
            count += 1.0;
        }
    }
    sum.map(|sum| sum / count)
}

#[cfg(test)]
mod tests {
    use super::half_blocks;
    use crate::Image;

    #[test]
    fn a_small_picture_has_a_character_for_two_pixels() {
        let mut image = Image::new(1, 2);
        image.pixels[0] = [1.0; 3];
        let expected = "\x1b[38;2;255;255;255m\x1b[48;2;0;0;0m▀\x1b[0m\n";
        assert_eq!(half_blocks(&image, 80), expected, "white above black");
    }

    #[test]
    fn a_large_picture_is_scaled_to_the_columns_and_keeps_its_shape() {
        let text = half_blocks(&Image::new(300, 151), 30);
        assert_eq!(text.lines().count(), 8, "15 rows of pixels, two a line");
        for line in text.lines() {
            assert_eq!(line.matches('▀').count(), 30, "characters of a line");
        }
    }

    #[test]
    fn any_size_fits() {
        for [width, height] in [[1, 1], [1, 500], [500, 1], [81, 3]] {
            let text = half_blocks(&Image::new(width, height), 80);
            assert!(text.contains('▀'), "{width}×{height} shows nothing");
        }
    }
}
