//! What the physical stages do alike before the first ray: load, build, and choose by type.

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree, TINY};
use clap::Args;
use ray_casting::{Intersect, LinearSearch, Scene};
use workbench::{Error, Film, Finished, Probe, Run, SurfaceKind, Unwatched};

/// A scene that is ready to be rendered.
pub struct Job<'a, E: Args, P> {
    /// The command line.
    pub run: &'a Run<E>,
    /// The scene that it names,
    pub scene: &'a Scene,
    /// with its textures.
    pub pictures: &'a [Picture],
    /// Watches the render.
    pub probe: &'a P,
}

/// A stage's options, which know how to render with them.
///
/// `GLASS` says whether the scene has any. It and the kind of search are decided once a render, by
/// type: what the scene does not need is not in the code that runs. With glass compiled in, a run on
/// `cornell-box` executes 4.4 % more instructions in this chapter, 2.7 % in chapter 6 and 1.9 % in
/// chapter 7. (Give the scene a material of glass that nothing is made of, and compare the two under
/// `valgrind --tool=callgrind`: 32 × 32 pixels, 32 samples, one thread.)
///
/// Textures and the sky are no types, because there is nothing to gain. Where there is no texture,
/// one comparison a hit remains, by the same measure at most 0.9 % (found by taking it out); of a
/// black sky, a product for each ray that leaves the scene, at most 0.1 %.
pub trait Renderer: Args + Sized {
    /// What the stage wants said about the scene in the summary, one sentence each; or why it cannot
    /// render it.
    ///
    /// # Errors
    /// When options contradict each other.
    fn remarks(run: &Run<Self>, scene: &Scene) -> Result<Vec<String>, Error>;

    /// Renders with this search.
    ///
    /// # Errors
    /// When there is no memory for the picture.
    fn render<G: Intersect, P: Probe, const GLASS: bool>(
        job: &Job<'_, Self, P>,
        geometry: &G,
    ) -> Result<Film, Error>;
}

/// One run of a physical stage.
///
/// # Errors
/// Whatever is wrong with the scene, the options, or the place for the picture.
pub fn draw<E: Renderer>(run: &Run<E>) -> Result<Finished, Error> {
    match run.recorder() {
        Some(recorder) => watched(run, recorder),
        None => watched(run, &Unwatched),
    }
}

fn watched<E: Renderer, P: Probe>(run: &Run<E>, probe: &P) -> Result<Finished, Error> {
    let scene = &run.load(Scene::load)?;
    E::remarks(run, scene)?.into_iter().for_each(|sentence| run.note(sentence));
    let pictures = &Picture::load_all(scene)?;
    let job = Job { run, scene, pictures, probe };
    let geometry = &scene.geometry;
    let film = if geometry.primitives() < TINY {
        run.note(format!("no tree for {} primitives", geometry.primitives()));
        searched(&job, &LinearSearch::new(geometry, probe))?
    } else {
        searched(&job, &run.build(|| BvTree::<Aabb, P>::build(geometry, Builder::Sah, probe)))?
    };
    run.save(&film)
}

fn searched<E: Renderer, P: Probe, G: Intersect>(
    job: &Job<'_, E, P>,
    geometry: &G,
) -> Result<Film, Error> {
    if job.scene.materials.iter().any(|material| material.surface == SurfaceKind::Glass) {
        E::render::<G, P, true>(job, geometry)
    } else {
        E::render::<G, P, false>(job, geometry)
    }
}
