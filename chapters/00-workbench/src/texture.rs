//! Textures: pictures that surfaces wear.

use std::path::Path;

use crate::{Counter, Error, Probe, TextureRecord, picture_file, srgb};

/// The most texels of a texture: 192 MiB at three bytes each.
pub(crate) const LARGEST_TEXTURE: u64 = 1 << 26;

/// A decoded texture, three bytes a texel; the default has none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Texture {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// sRGB, row by row from the top.
    texels: Vec<[u8; 3]>,
}

impl Texture {
    /// Decodes the picture of a record. Alpha is ignored, 16 bits are made 8.
    pub fn load(record: &TextureRecord) -> Result<Self, Error> {
        let ([width, height], bytes) = picture_file::load_png_bytes(&record.path)?;
        Ok(Self { width, height, texels: bytes.as_chunks::<3>().0.to_vec() })
    }

    /// Likewise, if the picture is needed; else a texture without texels, and `probe` counts it.
    pub fn load_if<P: Probe>(
        is_needed: bool,
        record: &TextureRecord,
        probe: &P,
    ) -> Result<Self, Error> {
        if is_needed || !probe.skips(Counter::TexturesNotLoaded) {
            return Self::load(record);
        }
        probe.count(Counter::TexturesNotLoaded, 1);
        Ok(Self::default())
    }

    /// Linear RGB of the texel in column `x` and row `y`, counted from the top left corner.
    ///
    /// Panics when the texture has no such texel.
    #[inline]
    #[must_use]
    pub fn texel(&self, x: u32, y: u32) -> [f32; 3] {
        debug_assert!(x < self.width, "column {x} of a texture {} texels wide", self.width);
        self.texels[y as usize * self.width as usize + x as usize].map(srgb::decode)
    }
}

/// The textures of a scene, each once.
#[derive(Debug, Default)]
pub(crate) struct Textures {
    pub(crate) records: Vec<TextureRecord>,
}

impl Textures {
    /// The index of the texture in the file `path`, whose header is read and checked; else why it
    /// cannot be used, as the end of a sentence about the key that names it.
    pub(crate) fn index_of(&mut self, path: &Path) -> Result<u32, String> {
        if let Some(index) = self.records.iter().position(|record| record.path == path) {
            return Ok(index as u32);
        }
        let size = picture_file::png_size(path).map_err(|error| format!("names {error}"))?;
        let texels = u64::from(size[0]) * u64::from(size[1]);
        if texels == 0 || texels > LARGEST_TEXTURE {
            let [width, height] = size;
            return Err(format!(
                "names `{}`, a picture of {width}×{height} pixels; a texture must have at least \
                 one and at most {LARGEST_TEXTURE}, for example 8192×8192",
                path.display()
            ));
        }
        self.records.push(TextureRecord { path: path.to_owned(), size });
        Ok(self.records.len() as u32 - 1)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{Texture, Textures};
    use crate::Image;

    #[test]
    fn a_texture_is_recorded_once_and_decoded_to_linear_light() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("a.png");
        let picture = Image::from_srgb8(2, 1, &[0, 10, 118, 188, 255, 7]);
        picture.save(&path).expect("the texture is written");

        let mut textures = Textures::default();
        let indices = [(); 2].map(|()| textures.index_of(&path));
        assert_eq!(indices, [Ok(0), Ok(0)], "the same file twice");
        let texture = Texture::load(&textures.records[0]).expect("the texture is read");
        assert_eq!([texture.width, texture.height], [2, 1], "the size");
        assert_eq!(texture.texel(1, 0), picture.pixel(1, 0), "the second texel");
    }

    /// The header of a PNG file that claims 10⁶ × 10⁶ pixels, and nothing behind it.
    #[test]
    fn a_huge_texture_is_refused_by_its_header() {
        let side = 1_000_000_u32.to_be_bytes();
        let mut chunk = b"IHDR".to_vec();
        chunk.extend(side.iter().chain(&side).chain(&[8, 2, 0, 0, 0]));
        let mut file = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
        file.extend(&chunk);
        file.extend(crc32(&chunk).to_be_bytes());
        file.extend(b"\0\0\0\0IDAT\x35\xaf\x06\x1e");
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("huge.png");
        fs::write(&path, file).expect("the file is written");
        let reason = Textures::default().index_of(&path).expect_err("it is too large");
        assert!(reason.contains("1000000×1000000") && reason.contains("at most"), "{reason}");
    }

    /// The checksum of PNG chunks, bit by bit.
    fn crc32(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(!0, |crc, &byte| {
            (0..8).fold(crc ^ u32::from(byte), |crc, _| {
                if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 }
            })
        })
    }
}
