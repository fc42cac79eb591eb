//! The right picture, and how well it is known.

use std::fs;
use std::path::{Path, PathBuf};

use statistics::Moments;
use workbench::Image;

use crate::error::{Error, Result};
use crate::furnace;
use crate::scene::{Answer, Scene, assets};
use crate::stages::Stages;

/// A picture that others are held against.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The picture.
    pub image: Image,
    /// The square of the standard error of each pixel and channel; 0 if it is exact.
    pub variance: Vec<[f32; 3]>,
}

/// Pictures with seeds of their own, from whose spread the error of their mean is estimated.
const BATCHES: u32 = 8;
/// Where their seeds begin: far from those of any measured picture.
const FIRST_SEED: u32 = 1_000_000;

impl Truth {
    /// What a scene really looks like; `None` if nobody asks.
    ///
    /// # Errors
    /// If a file cannot be read or written, or a stage fails.
    pub fn of(scene: &Scene, stages: &Stages) -> Result<Option<Self>> {
        match scene.answer {
            Answer::None => Ok(None),
            Answer::Furnace => Ok(Some(Self::exact(furnace::picture(scene.size)))),
            Answer::Reference(name) => Self::reference(name, scene.size).map(Some),
            Answer::Own { depth, samples } => {
                let options = format!("--depth {depth}");
                Self::converged(scene, stages, "light-sampling", &options, samples).map(Some)
            }
        }
    }

    /// A picture that is known exactly.
    #[must_use]
    pub fn exact(image: Image) -> Self {
        let variance = vec![[0.0; 3]; image.pixels.len()];
        Self { image, variance }
    }

    /// A picture of `assets/reference`, at a size that divides its own.
    ///
    /// # Errors
    /// If a file cannot be read, or the size does not divide that of the picture.
    pub fn reference(name: &str, size: [u32; 2]) -> Result<Self> {
        let load = |name: String| Image::load_exr(&assets().join("reference").join(name));
        let picture = load(format!("{name}.exr"))?;
        let error = load(format!("{name}.stderr.exr"))?;
        Self::noisy(picture, &error).shrunk(size)
    }

    /// What a stage's own picture of a scene converges to.
    ///
    /// The mean of some pictures of `samples` paths a pixel all together. It is kept beside the
    /// binaries, under a name that holds the binary's hash: another program makes it anew.
    ///
    /// # Errors
    /// If the stage fails, or a file cannot be read or written.
    pub fn converged(
        scene: &Scene,
        stages: &Stages,
        stage: &str,
        options: &str,
        samples: u32,
    ) -> Result<Self> {
        let file = |ending: &str| -> Result<PathBuf> {
            let [width, height] = scene.size;
            let words = options.replace("--", "").replace(' ', "-");
            let program = hash_of_file(stages.binary(stage))?;
            let name = format!("{}-{stage}-{words}-{width}x{height}-{samples}", scene.name);
            Ok(stages.folder.join(format!("{name}-{program:016x}.{ending}")))
        };
        let (picture, error) = (file("exr")?, file("stderr.exr")?);
        if !picture.is_file() || !error.is_file() {
            let truth = Self::of_batches(&batches(scene, stages, stage, options, samples)?);
            truth.standard_errors().save(&error)?;
            truth.image.save(&picture)?;
        }
        Ok(Self::noisy(Image::load_exr(&picture)?, &Image::load_exr(&error)?))
    }

    fn noisy(image: Image, error: &Image) -> Self {
        let variance = error.pixels.iter().map(|pixel| pixel.map(|e| e * e)).collect();
        Self { image, variance }
    }

    /// The mean of pictures, and the variance of that mean.
    fn of_batches(pictures: &[Image]) -> Self {
        let mut image = pictures[0].clone();
        let mut variance = vec![[0.0; 3]; image.pixels.len()];
        let pixels = image.pixels.iter_mut().zip(&mut variance).enumerate();
        for (i, (pixel, variance)) in pixels {
            let channels = [0, 1, 2].map(|c| -> Moments {
                pictures.iter().map(|picture| f64::from(picture.pixels[i][c])).collect()
            });
            *pixel = channels.each_ref().map(|moments| moments.mean() as f32);
            *variance = channels.each_ref().map(|moments| moments.variance_of_mean() as f32);
        }
        Self { image, variance }
    }

    fn standard_errors(&self) -> Image {
        let pixels = self.variance.iter().map(|pixel| pixel.map(f32::sqrt)).collect();
        Image { pixels, ..self.image }
    }

    /// The same picture with fewer pixels. A pixel is the mean over its square, so a larger pixel
    /// is the mean of those that fill it, and its variance is theirs divided by their number.
    fn shrunk(&self, [width, height]: [u32; 2]) -> Result<Self> {
        let Image { width: from_width, height: from_height, .. } = self.image;
        let factor = from_width / width.max(1);
        if factor == 0 || [width * factor, height * factor] != [from_width, from_height] {
            let sizes = format!("{from_width}×{from_height} to {width}×{height}");
            return Err(Error::new(format!("a reference cannot be shrunk from {sizes}")));
        }
        let count = (factor * factor) as f32;
        let shrink = |pixels: &[[f32; 3]]| {
            let mut sums = vec![[0.0_f32; 3]; (width * height) as usize];
            for (i, pixel) in pixels.iter().enumerate() {
                let (x, y) = (i as u32 % from_width, i as u32 / from_width);
                let sum = &mut sums[(y / factor * width + x / factor) as usize];
                *sum = std::array::from_fn(|c| sum[c] + pixel[c] / count);
            }
            sums
        };
        let variance = shrink(&self.variance).iter().map(|v| v.map(|v| v / count)).collect();
        Ok(Self { image: Image { width, height, pixels: shrink(&self.image.pixels) }, variance })
    }

    /// The expected relMSE of a perfect picture, which is taken off a measured one.
    #[must_use]
    pub fn own_rel_mse(&self) -> f64 {
        let pairs = self.image.pixels.iter().flatten().zip(self.variance.iter().flatten());
        let terms = pairs.map(|(&mean, &v)| f64::from(v) / (f64::from(mean).powi(2) + 0.01));
        terms.sum::<f64>() / (3 * self.variance.len()) as f64
    }

    /// The standard error of the mean over pixels and channels, relative to that mean.
    ///
    /// Pixels share no samples; the channels of a pixel do, and count as if they erred together.
    #[must_use]
    pub fn mean_error(&self) -> f64 {
        let deviation = |pixel: &[f32; 3]| pixel.iter().map(|&v| f64::from(v).sqrt()).sum::<f64>();
        let variance: f64 = self.variance.iter().map(|pixel| deviation(pixel).powi(2)).sum();
        let sum: f64 = self.image.pixels.iter().flatten().map(|&x| f64::from(x)).sum();
        variance.sqrt() / sum
    }
}

fn batches(
    scene: &Scene,
    stages: &Stages,
    stage: &str,
    options: &str,
    samples: u32,
) -> Result<Vec<Image>> {
    let file = scene.file(&stages.folder)?;
    let [width, height] = scene.size;
    let samples = samples.div_ceil(BATCHES);
    (0..BATCHES)
        .map(|batch| {
            let seed = FIRST_SEED + batch;
            let arguments =
                format!("{options} --size {width}x{height} --samples {samples} --seed {seed}");
            Ok(stages.render(stage, &file, &arguments)?.image)
        })
        .collect()
}

/// FNV-1a, 64 bits.
fn hash_of_file(path: &Path) -> Result<u64> {
    let bytes = fs::read(path).map_err(|error| Error::file(path, error))?;
    Ok(bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash: u64, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    }))
}

#[cfg(test)]
mod tests {
    use super::Truth;
    use workbench::Image;

    fn image(width: u32, height: u32, values: &[f32]) -> Image {
        Image { width, height, pixels: values.iter().map(|&v| [v; 3]).collect() }
    }

    #[test]
    fn a_large_pixel_is_the_mean_of_small_ones() {
        let picture = image(4, 2, &[1.0, 3.0, 0.0, 0.0, 5.0, 7.0, 8.0, 0.0]);
        let error = image(4, 2, &[2.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0]);
        let small = Truth::noisy(picture, &error).shrunk([2, 1]).expect("2 divides 4");
        assert_eq!(small.image.pixels, [[4.0; 3], [2.0; 3]], "the means");
        assert_eq!(small.variance, [[0.25; 3], [0.25; 3]], "4/16 and 4/16");
        assert!(small.shrunk([3, 1]).is_err(), "3 does not divide 2");
    }

    #[test]
    fn the_spread_of_batches_is_the_error_of_their_mean() {
        let truth = Truth::of_batches(&[1.0, 2.0, 3.0].map(|v| image(1, 1, &[v])));
        assert_eq!(truth.image.pixels, [[2.0; 3]], "the mean");
        // Variance 1, divided by 3.
        assert!((truth.variance[0][0] - 1.0 / 3.0).abs() < 1e-7, "{:?}", truth.variance);
        let own = truth.own_rel_mse();
        assert!((own - 1.0 / 3.0 / 4.01).abs() < 1e-7, "relMSE {own}");
        let error = truth.mean_error();
        assert!((error - (1.0_f64 / 3.0).sqrt() / 2.0).abs() < 1e-7, "of the mean {error}");
    }

    #[test]
    fn the_references_are_as_noisy_as_their_readme_says() {
        for (name, own) in [("cornell", 2.4e-5), ("many-lights", 5.3e-4)] {
            let truth = Truth::reference(name, [128, 128]).expect("it is in the workspace");
            let found = truth.own_rel_mse();
            assert!((found / own - 1.0).abs() < 0.1, "{name}: {found}, the README says {own}");
            let half = Truth::reference(name, [64, 64]).expect("64 divides 128");
            assert!(half.own_rel_mse() < 0.5 * found, "{name}: {} at 64×64", half.own_rel_mse());
        }
    }
}
