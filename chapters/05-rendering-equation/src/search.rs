//! What the physical stages do alike before the first ray: load, build, and choose by type.

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree, TINY};
use clap::Args;
use ray_casting::{Intersect, LinearSearch, Scene};
use workbench::{Counter, Error, Film, Finished, Probe, Run, Unwatched};

use crate::survey::{Anything, Code, Has, MatteOnly, Opaque, Survey};

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
/// `H` says what scenes the code is for. It and the kind of search are decided once a render, by
/// type: what the scene does not need is not in the code that runs. [`Code`] switches that off.
pub trait Renderer: Args + Sized {
    /// Which code the command line asks for.
    fn code(&self) -> Code;

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
    fn render<G: Intersect, P: Probe, H: Has>(
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
    let pictures = &run.load(|_| Picture::load_worn(scene, probe))?;
    let job = Job { run, scene, pictures, probe };
    let geometry = &scene.geometry;
    let film = if geometry.primitives() < TINY && probe.skips(Counter::TreesNotBuilt) {
        probe.count(Counter::TreesNotBuilt, 1);
        run.note(format!("no tree for {} primitives", geometry.primitives()));
        searched(&job, &LinearSearch::new(geometry, probe))?
    } else {
        searched(&job, &run.build(|| BvTree::<Aabb, P>::build(geometry, Builder::Sah, probe)))?
    };
    run.save(&film)
}

/// Chooses the code with the least in it that can draw the scene.
fn searched<E: Renderer, P: Probe, G: Intersect>(
    job: &Job<'_, E, P>,
    geometry: &G,
) -> Result<Film, Error> {
    let survey = Survey::of(job.scene);
    if job.run.options.stage.code().for_any_scene {
        render::<E, P, G, Anything>(job, geometry)
    } else if survey.is_within::<MatteOnly>() {
        render::<E, P, G, MatteOnly>(job, geometry)
    } else if survey.is_within::<Opaque>() {
        render::<E, P, G, Opaque>(job, geometry)
    } else {
        render::<E, P, G, Anything>(job, geometry)
    }
}

fn render<E: Renderer, P: Probe, G: Intersect, H: Has>(
    job: &Job<'_, E, P>,
    geometry: &G,
) -> Result<Film, Error> {
    if let Some(sentence) = H::LEFT_OUT {
        job.run.note(sentence.to_owned());
    }
    E::render::<G, P, H>(job, geometry)
}
