//! Chapter 1: draw the nearest surface along each ray.
//!
//! `cargo run --release -p ray-casting -- teapot --show normal`

use std::process::ExitCode;

use ray_casting::{Extra, LinearSearch, RayCaster, STAGE, Scene, simplifications};
use workbench::{Error, Finished, Probe, Run, Unwatched};

fn main() -> ExitCode {
    workbench::main(&STAGE, |run: &Run<Extra>| match run.recorder() {
        Some(recorder) => render(run, recorder),
        None => render(run, &Unwatched),
    })
}

// ANCHOR: render
fn render<P: Probe>(run: &Run<Extra>, probe: &P) -> Result<Finished, Error> {
    let scene = run.load(Scene::load)?;
    simplifications(&scene).into_iter().for_each(|sentence| run.note(sentence));
    run.load(|_| scene.pass_over_textures(probe))?;
    let geometry = run.build(|| LinearSearch::new(&scene.geometry, probe));
    let caster = RayCaster::new(&scene, &geometry, probe, run.options.stage.show);
    let film = run.render(scene.exposure, probe, |film_point, _| {
        caster.incident_radiance(scene.camera.ray(film_point))
    })?;
    run.save(&film)
}
// ANCHOR_END: render
