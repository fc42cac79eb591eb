//! The checkered floor.

/// A checkerboard of `tiles` × `tiles` red and yellow squares, as sRGB bytes.
///
/// The picture has `size` × `size` pixels, row 0 on top, three bytes a pixel; the top left tile is
/// red. Every tile is several pixels wide, so that a texture filter blurs its edges only.
///
/// # Panics
/// If the tiles are not a whole number of pixels wide.
#[must_use]
pub fn checker(tiles: u32, size: u32) -> image::RgbImage {
    assert!(
        tiles > 0 && size > 0 && size.is_multiple_of(tiles),
        "{size} pixels are no whole multiple of {tiles} tiles"
    );
    const RED: image::Rgb<u8> = image::Rgb([214, 52, 38]);
    const YELLOW: image::Rgb<u8> = image::Rgb([252, 222, 72]);
    let tile = size / tiles;
    image::RgbImage::from_fn(size, size, |x, y| {
        if (x / tile + y / tile).is_multiple_of(2) { RED } else { YELLOW }
    })
}
