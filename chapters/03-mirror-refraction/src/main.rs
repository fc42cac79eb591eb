//! Chapter 3: follow light into mirrors and through glass.
//!
//! `cargo run --release -p mirror-refraction -- whitted --depth 3`

use std::process::ExitCode;

use blinn_phong::Picture;
use mirror_refraction::{Cutoff, Limits, RayTracer, STAGE, simplifications};
use ray_casting::{LinearSearch, Scene};
use workbench::{Error, Finished, Probe, Run, Unwatched};

fn main() -> ExitCode {
    workbench::main(&STAGE, |run: &Run<Cutoff>| match run.recorder() {
        Some(recorder) => render(run, recorder),
        None => render(run, &Unwatched),
    })
}

fn render<P: Probe>(run: &Run<Cutoff>, probe: &P) -> Result<Finished, Error> {
    let scene = run.load(Scene::load)?;
    simplifications(&scene).into_iter().for_each(|sentence| run.note(sentence));
    let pictures = run.load(|_| Picture::load_worn(&scene, probe))?;
    let geometry = run.build(|| LinearSearch::new(&scene.geometry, probe));
    let limits = Limits::new(run.depth(), run.options.stage.cutoff);
    let tracer = run.build(|| RayTracer::new(&scene, &pictures, &geometry, probe, limits));
    let film = run.render(scene.exposure, probe, |film_point, _| {
        tracer.incident_radiance(scene.camera.ray(film_point))
    })?;
    run.save(&film)
}
