//! The course in one picture: the same scene by every stage, with the same time for each.
//!
//! Made by hand (`cargo run --release -p book -- course`), on an idle machine, and committed: how
//! many samples a stage reaches depends on the clock, so no check compares the result.

use std::path::Path;
use std::time::{Duration, Instant};

use blinn_phong::{Shader, Terms};
use bv_tree::{Aabb, Builder, BvTree};
use light_sampling::{Estimator, LightTracer};
use mirror_refraction::{Limits, RayTracer};
use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::{LinearSearch, RayCaster, Rgb, Scene, Show};
use rendering_equation::{Branching, Density, DistributedTracer, Opaque};
use workbench::{FilmPoint, FilmSettings, Image, Sampler, Unwatched, expose};

use crate::figures::{self, light_sampling::stage::settings};
use crate::picture::Picture;
use crate::table::Table;
use crate::{Error, Result, folder, measurements};

/// Width and height of each panel.
const SIZE: [u32; 2] = [128, 128];

/// What each stage has, on one thread.
const TIME: Duration = Duration::from_secs(2);

/// Renders all panels and writes `course.png` and `course.md` beside the book's measurements.
///
/// # Errors
///
/// The builder was compiled without optimisation, or a file cannot be written.
pub fn make(root: &Path) -> Result<()> {
    if cfg!(debug_assertions) {
        return Err(Error::msg("show what users run: cargo run --release -p book -- course"));
    }
    let scene = &Scene::load(&figures::scene_file("cornell-box"))?;
    let linear = &LinearSearch::new(&scene.geometry, &Unwatched);
    let tree = &BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let caster = RayCaster::new(scene, linear, &Unwatched, Show::Facing);
    let shader = Shader::new(scene, &[], linear, &Unwatched, Terms::All);
    let branching = Branching { directions: 2, depth: 4, density: Density::Cosine };
    let distributed: DistributedTracer<'_, _, _, Opaque> =
        DistributedTracer::new(scene, &[], tree, &Unwatched, branching);
    let ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };
    let paths: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(scene, &[], tree, &Unwatched, Density::Cosine, ending);
    let lights: LightTracer<'_, _, _, Opaque> =
        LightTracer::new(scene, &[], tree, &Unwatched, settings(Estimator::Mis));

    let limits = Limits::new(Some(8), Limits::CUTOFF);
    let recursive = RayTracer::new(scene, &[], linear, &Unwatched, limits);
    let searching = RayTracer::new(scene, &[], tree, &Unwatched, limits);

    let ray = |point: FilmPoint| scene.camera.ray(point);
    let mut panels = [
        Panel::new("1 ray casting", |p, _| caster.incident_radiance(ray(p))),
        Panel::new("2 Blinn-Phong", |p, _| shader.incident_radiance(ray(p))),
        Panel::new("3 recursion", |p, _| recursive.incident_radiance(ray(p))),
        Panel::new("4 the same over a tree", |p, _| searching.incident_radiance(ray(p))),
        Panel::new("5 distributed", |p, s| distributed.incident_radiance(ray(p), s)),
        Panel::new("6 path tracing", |p, s| paths.incident_radiance(ray(p), s)),
        Panel::new("7 light sampling", |p, s| lights.incident_radiance(ray(p), s)),
    ];
    // In turn, so that what slows the machine down for a while slows all of them.
    while panels.iter().any(|panel| panel.spent < TIME) {
        panels.iter_mut().filter(|panel| panel.spent < TIME).for_each(Panel::pass);
    }

    let mut table = Table::new(&["stage", "samples a pixel"]);
    for panel in &panels {
        table.row([panel.name.to_owned(), panel.passes.to_string()]);
    }
    let pictures = panels.map(Panel::picture);
    let (first, second) = pictures.split_at(4);
    let rows = [first, second].map(|row| Picture::side_by_side(row, 8));
    let root = root.join(measurements::FOLDER);
    folder::write(&root.join("course.png"), Picture::stacked(&rows, 8).png()?)?;
    folder::write(&root.join("course.md"), table.markdown())
}

/// What a stage knows of a point of the film.
type Radiance<'a> = dyn Fn(FilmPoint, &mut Sampler) -> Rgb + Sync + 'a;

/// A stage at work: as many passes of one sample a pixel as fit into the time.
struct Panel<'a> {
    name: &'static str,
    radiance: Box<Radiance<'a>>,
    sum: Image,
    passes: u32,
    spent: Duration,
}

impl<'a> Panel<'a> {
    fn new(
        name: &'static str,
        radiance: impl Fn(FilmPoint, &mut Sampler) -> Rgb + Sync + 'a,
    ) -> Self {
        let sum = Image::new(SIZE[0], SIZE[1]);
        Self { name, radiance: Box::new(radiance), sum, passes: 0, spent: Duration::ZERO }
    }

    fn pass(&mut self) {
        let start = Instant::now();
        let seed = u64::from(self.passes);
        let film = FilmSettings { size: SIZE, samples: 1, seed, threads: Some(1) };
        let pass = expose(&film, &self.radiance);
        let values = pass.pixels.iter().flatten();
        for (sum, value) in self.sum.pixels.iter_mut().flatten().zip(values) {
            *sum += value;
        }
        self.passes += 1;
        self.spent += start.elapsed();
    }

    fn picture(mut self) -> Picture {
        let n = self.passes as f32;
        self.sum.pixels.iter_mut().flatten().for_each(|sum| *sum /= n);
        Picture::from(&self.sum)
    }
}
