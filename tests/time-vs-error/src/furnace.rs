//! The picture of the scene `furnace` in closed form.
//!
//! A sphere of radius 1 and albedo ½, four away from the eye, in light of radiance 1 from all
//! sides: the sphere is ½ and the rest is 1. In a pixel on the outline, what counts is how much of it the
//! sphere covers.

use workbench::Image;

/// Half the vertical angle of the camera: the scene's `fov` is 40°.
const HALF_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// From the eye to the centre, in radii.
const DISTANCE: f64 = 4.0;
/// Points along the edge of a pixel on the outline.
const GRID: u32 = 256;

/// What every stage from 05 on converges to.
#[must_use]
pub(crate) fn picture(size: [u32; 2]) -> Image {
    let [width, height] = size;
    let pixels = (0..width * height).map(|i| {
        let covered = coverage([i % width, i / width], size);
        [(1.0 - 0.5 * covered) as f32; 3]
    });
    Image { width, height, pixels: pixels.collect() }
}

/// The share of a pixel that the sphere covers.
///
/// The rays that touch the sphere form a cone of the half angle asin(1/4) around the axis: the
/// outline is a circle of radius tan(asin(1/4)) in the plane at distance 1.
fn coverage([x, y]: [u32; 2], [width, height]: [u32; 2]) -> f64 {
    let radius = 1.0 / (DISTANCE * DISTANCE - 1.0).sqrt();
    let edge = 2.0 * libm::tan(HALF_ANGLE) / f64::from(height);
    let inside = |u: f64, v: f64| {
        let across = (f64::from(x) + u - 0.5 * f64::from(width)) * edge;
        let down = (f64::from(y) + v - 0.5 * f64::from(height)) * edge;
        across * across + down * down < radius * radius
    };
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[u, v]| inside(u, v));
    // The circle is many pixels wide: one whose corners agree is not cut.
    if corners.iter().all(|&corner| corner == corners[0]) {
        return if corners[0] { 1.0 } else { 0.0 };
    }
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(GRID);
    let points = (0..GRID * GRID).filter(|i| inside(at(i % GRID), at(i / GRID)));
    points.count() as f64 / f64::from(GRID * GRID)
}

#[cfg(test)]
mod tests {
    use super::picture;

    /// All together the sphere covers π r² / (2 tan 20°)² of a square picture.
    #[test]
    fn the_sphere_covers_the_area_of_its_outline() {
        let image = picture([64, 64]);
        let covered = 2.0 * (1.0 - image.mean()[0]);
        let side = 2.0 * (20.0_f64.to_radians()).tan();
        let expected = std::f64::consts::PI / 15.0 / (side * side);
        // A pixel whose edge, not corner, is cut by a hair counts as whole.
        assert!((covered - expected).abs() < 1e-4, "{covered}, by the formula {expected}");
        assert_eq!([image.pixel(32, 32), image.pixel(0, 0)], [[0.5; 3], [1.0; 3]], "in and out");
    }
}
