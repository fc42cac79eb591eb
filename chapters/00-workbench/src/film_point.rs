//! A point of the film.

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

#[cfg(test)]
mod tests {
    use super::FilmPoint;

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
}
