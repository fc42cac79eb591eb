//! The figures of chapter 0.

use workbench::{FilmSettings, Sampler, expose, srgb};

use super::{Drawing, Figure};
use crate::axis::Axis;
use crate::picture::Picture;
use crate::plot::{Plot, Series, Style};
use crate::table::Table;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "00-workbench/film.png", draw: film },
    Figure { file: "00-workbench/pixel-means.png", draw: pixel_means },
    Figure { file: "00-workbench/keys.png", draw: keys },
    Figure { file: "00-workbench/threads.md", draw: threads },
    Figure { file: "00-workbench/srgb-curve.svg", draw: srgb_curve },
    Figure { file: "00-workbench/stripes.png", draw: stripes },
];

/// The size of the teapot scene, which stage 0 takes its film from.
const STAGE: FilmSettings = FilmSettings { size: [360, 240], samples: 1, seed: 0, threads: None };

/// What stage 0 paints: column, row, chance.
fn paint(point: workbench::FilmPoint, sampler: &mut Sampler) -> [f32; 3] {
    [point.x / point.size[0] as f32, point.y / point.size[1] as f32, sampler.next_1d()]
}

/// The picture of the stage, as its command without options makes it.
fn film() -> Drawing {
    Picture::from(&expose(&STAGE, paint)).into()
}

/// A white disk on a coarse film, with 1, 4 and 64 samples a pixel.
fn pixel_means() -> Drawing {
    let panels = [1, 4, 64].map(|samples| {
        let settings = FilmSettings { size: [24, 16], samples, seed: 0, threads: None };
        let disk = |point: workbench::FilmPoint, _: &mut Sampler| {
            let (x, y) = (point.x - 12.0, point.y - 8.0);
            [if x * x + y * y < 36.0 { 1.0 } else { 0.0 }; 3]
        };
        Picture::from(&expose(&settings, disk)).enlarged(8)
    });
    Picture::side_by_side(&panels, 16).into()
}

/// The first random number of each pixel: from a generator seeded with the pixel's number, and
/// from the workbench's sampler, which hashes its key.
fn keys() -> Drawing {
    let settings = FilmSettings { size: [100, 66], samples: 1, seed: 0, threads: None };
    let naive = expose(&settings, |point, _| {
        let pixel = point.y as u32 * point.size[0] + point.x as u32;
        let first = pixel.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        [(first >> 8) as f32 / 16_777_216.0; 3]
    });
    let hashed = expose(&settings, |_, sampler| [sampler.next_1d(); 3]);
    Picture::side_by_side(&[&naive, &hashed].map(|image| Picture::from(image).enlarged(3)), 16)
        .into()
}

/// The fingerprint of the stage's picture with different numbers of threads, and with another seed.
fn threads() -> Drawing {
    let mut table = Table::new(&["threads", "seed", "fingerprint of the floats"]);
    for (threads, seed) in [(1, 0), (2, 0), (5, 0), (2, 1)] {
        let settings = FilmSettings { threads: Some(threads), seed, ..STAGE };
        let hash = expose(&settings, paint).hash();
        table.row([threads.to_string(), seed.to_string(), format!("`{hash:016x}`")]);
    }
    table.into()
}

/// What a byte of a PNG file stands for: the sRGB curve, with the straight line beside it.
fn srgb_curve() -> Drawing {
    let linear = |byte: u8| [f64::from(byte), f64::from(srgb::decode(byte))];
    let curve = (0..=255).step_by(3).map(linear).collect();
    let line = vec![[0.0, 0.0], [255.0, 1.0]];
    let series = |name: &str, points| Series { name: name.to_owned(), points, style: Style::Line };
    Plot {
        description: "Linear light as a function of the byte: the sRGB curve lies below the \
                      straight line everywhere between black and white."
            .to_owned(),
        x: Axis::linear("byte in the PNG file").within(0.0, 255.0),
        y: Axis::linear("linear light").within(0.0, 1.0),
        series: vec![series("sRGB", curve), series("no curve", line)],
    }
    .into()
}

/// Black and white lines; their mean with the sRGB curve; their mean without it.
fn stripes() -> Drawing {
    let settings = FilmSettings { size: [200, 120], samples: 1, seed: 0, threads: None };
    let lines = expose(&settings, |point, _| [(point.y as u32 % 2) as f32; 3]);
    let mean = lines.mean()[0] as f32;
    let grey = |byte: u8| Picture::new(200, 120, [byte, byte, byte, 255].repeat(200 * 120));
    let uncurved = (255.0 * mean + 0.5) as u8;
    let panels = [Picture::from(&lines), grey(srgb::encode(mean)), grey(uncurved)];
    Picture::side_by_side(&panels, 0).into()
}
