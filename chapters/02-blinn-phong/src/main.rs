//! Chapter 2: light the visible surface.
//!
//! `cargo run --release -p blinn-phong -- teapot --terms specular`

use std::process::ExitCode;

use blinn_phong::{Extra, Picture, STAGE, Shader};
use ray_casting::{LinearSearch, Scene, simplifications};
use workbench::{Error, Finished, Probe, Run, Unwatched};

fn main() -> ExitCode {
    workbench::main(&STAGE, |run: &Run<Extra>| match run.recorder() {
        Some(recorder) => render(run, recorder),
        None => render(run, &Unwatched),
    })
}

fn render<P: Probe>(run: &Run<Extra>, probe: &P) -> Result<Finished, Error> {
    let scene = run.load(Scene::load)?;
    simplifications(&scene).into_iter().for_each(|sentence| run.note(sentence));
    let pictures = run.load(|_| Picture::load_worn(&scene, probe))?;
    let geometry = run.build(|| LinearSearch::new(&scene.geometry, probe));
    let shader = Shader::new(&scene, &pictures, &geometry, probe, run.options.stage.terms);
    let film = run.render(scene.exposure, probe, |film_point, _| {
        shader.incident_radiance(scene.camera.ray(film_point))
    })?;
    run.save(&film)
}
