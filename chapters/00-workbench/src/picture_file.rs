//! Picture files: PNG and EXR, written and read.

use std::error::Error as _;
use std::ffi::OsStr;
use std::io;
use std::path::Path;

use image::codecs::openexr::OpenExrEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageFormat, ImageReader, Limits};

use crate::{Error, Image, atomic_file};

/// The most memory that decoding a picture may take, in bytes.
const DECODER_MEMORY: u64 = 2 << 30;

/// The two kinds of file a picture can be written to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureFormat {
    /// 8-bit sRGB.
    Png,
    /// Linear 32-bit floats.
    Exr,
}

impl PictureFormat {
    /// The format that the extension of `path` names, or what to do if it names none.
    pub(crate) fn of(path: &Path) -> Result<Self, String> {
        let extension = path.extension().and_then(OsStr::to_str).unwrap_or_default();
        match extension.to_ascii_lowercase().as_str() {
            "png" => Ok(Self::Png),
            "exr" => Ok(Self::Exr),
            _ => Err("a picture's name must end with `.png` (8-bit sRGB) or `.exr` (32-bit float)"
                .to_owned()),
        }
    }
}

/// Writes `image` in the format that the extension names, completely or not at all.
pub(crate) fn save(image: &Image, path: &Path) -> Result<(), Error> {
    let format = PictureFormat::of(path)
        .map_err(|reason| Error::Picture { path: path.to_owned(), reason })?;
    atomic_file::write_file(path, |writer| {
        let Image { width, height, .. } = *image;
        let written = match format {
            // Fast compression takes a fifth of the time of the default one.
            PictureFormat::Png => {
                PngEncoder::new_with_quality(writer, CompressionType::Fast, FilterType::Adaptive)
                    .write_image(&image.to_srgb8(), width, height, ExtendedColorType::Rgb8)
            }
            PictureFormat::Exr => OpenExrEncoder::new(writer).write_image(
                &float_bytes(image),
                width,
                height,
                ExtendedColorType::Rgb32F,
            ),
        };
        written.map_err(into_io)
    })
}

/// The floats of the picture as the encoder wants them: their bytes in the machine's order.
fn float_bytes(image: &Image) -> Vec<u8> {
    image.pixels.as_flattened().iter().flat_map(|value| value.to_ne_bytes()).collect()
}

/// What went wrong. The EXR encoder calls a full disk an error of decoding; its cause is what
/// helps.
fn into_io(error: ImageError) -> io::Error {
    match error {
        ImageError::IoError(error) => error,
        other => io::Error::other(other.source().map_or(other.to_string(), ToString::to_string)),
    }
}

/// Reads the floats of an EXR file.
pub(crate) fn load_exr(path: &Path) -> Result<Image, Error> {
    let image = decode(path, ImageFormat::OpenExr)?.into_rgb32f();
    let (width, height) = image.dimensions();
    let pixels = image.into_raw().as_chunks::<3>().0.to_vec();
    Ok(Image { width, height, pixels })
}

/// Reads the size and the sRGB bytes of a PNG file, three a pixel.
pub(crate) fn load_png_bytes(path: &Path) -> Result<([u32; 2], Vec<u8>), Error> {
    let image = decode(path, ImageFormat::Png)?.into_rgb8();
    let (width, height) = image.dimensions();
    Ok(([width, height], image.into_raw()))
}

/// Reads width and height from the header of a PNG file, and nothing else.
pub(crate) fn png_size(path: &Path) -> Result<[u32; 2], Error> {
    let (width, height) = reader(path, ImageFormat::Png)?
        .into_dimensions()
        .map_err(|error| unreadable(path, ImageFormat::Png, &error))?;
    Ok([width, height])
}

fn decode(path: &Path, format: ImageFormat) -> Result<image::DynamicImage, Error> {
    let mut reader = reader(path, format)?;
    let mut limits = Limits::default();
    limits.max_alloc = Some(DECODER_MEMORY);
    reader.limits(limits);
    reader.decode().map_err(|error| unreadable(path, format, &error))
}

fn reader(
    path: &Path,
    format: ImageFormat,
) -> Result<ImageReader<impl io::BufRead + io::Seek>, Error> {
    let failed = |error: io::Error| Error::Picture {
        path: path.to_owned(),
        reason: format!("could not be read: {error}"),
    };
    if format == ImageFormat::Png && !has_whole_palette(path).unwrap_or(true) {
        let reason = "could not be read as a PNG picture: its palette ends within a colour";
        return Err(Error::Picture { path: path.to_owned(), reason: reason.to_owned() });
    }
    let mut reader = ImageReader::open(path).map_err(failed)?;
    reader.set_format(format);
    Ok(reader)
}

/// Whether the palettes of a PNG file are made of whole colours, of which the decoder is so sure that
/// it panics. What ends too early or is no PNG file is left to the decoder.
fn has_whole_palette(path: &Path) -> io::Result<bool> {
    let mut file = io::BufReader::new(std::fs::File::open(path)?);
    io::Seek::seek_relative(&mut file, 8)?;
    loop {
        let mut head = [0; 8];
        io::Read::read_exact(&mut file, &mut head)?;
        let [a, b, c, d, name @ ..] = head;
        let length = u32::from_be_bytes([a, b, c, d]);
        match &name {
            b"PLTE" if length % 3 != 0 => return Ok(false),
            b"IDAT" => return Ok(true),
            _ => io::Seek::seek_relative(&mut file, i64::from(length) + 4)?,
        }
    }
}

fn unreadable(path: &Path, format: ImageFormat, error: &ImageError) -> Error {
    let name = if format == ImageFormat::Png { "PNG" } else { "EXR" };
    let reason = format!("could not be read as a {name} picture: {error}");
    Error::Picture { path: path.to_owned(), reason }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::PictureFormat;
    use crate::Image;

    fn gradient() -> Image {
        let mut image = Image::new(33, 7);
        for (i, pixel) in image.pixels.iter_mut().enumerate() {
            *pixel = [i as f32 / 231.0, 1e-30 * i as f32, -1e30 * i as f32];
        }
        image
    }

    #[test]
    fn the_extension_names_the_format() {
        assert_eq!(PictureFormat::of(Path::new("a.PNG")), Ok(PictureFormat::Png), "a.PNG");
        assert_eq!(PictureFormat::of(Path::new("b.c.exr")), Ok(PictureFormat::Exr), "b.c.exr");
        for name in ["a.jpg", "png", ".png", "a.png.", ""] {
            assert!(PictureFormat::of(Path::new(name)).is_err(), "`{name}` was accepted");
        }
    }

    /// accuracy.md G5, for the format that we write.
    #[test]
    fn an_exr_file_gives_back_every_bit() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("gradient.exr");
        gradient().save(&path).expect("the picture is written");
        let loaded = Image::load_exr(&path).expect("the picture is read");
        assert_eq!(loaded.hash(), gradient().hash(), "the hash after a round trip");
    }

    #[test]
    fn a_png_file_gives_back_every_byte() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("gradient.png");
        gradient().save(&path).expect("the picture is written");
        let loaded = Image::load_png(&path).expect("the picture is read");
        assert_eq!(loaded.to_srgb8(), gradient().to_srgb8(), "the bytes after a round trip");
    }

    #[test]
    fn pictures_of_one_row_or_column_are_written_and_read() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for [width, height] in [[1, 1], [1, 9], [9, 1]] {
            let path = folder.path().join("line.exr");
            Image::new(width, height).save(&path).expect("the picture is written");
            let loaded = Image::load_exr(&path).expect("the picture is read");
            assert_eq!([loaded.width, loaded.height], [width, height], "the size");
        }
    }

    #[test]
    fn a_file_that_is_no_picture_is_an_error_that_names_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("text.png");
        fs::write(&path, "this is no picture").expect("the file is written");
        let message = Image::load_png(&path).expect_err("text was read as a picture").to_string();
        assert!(message.contains("text.png") && message.contains("PNG"), "{message}");
    }
}
