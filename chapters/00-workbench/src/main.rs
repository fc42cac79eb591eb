//! Stage 0: a picture before the first ray. Red is the column, green the row, blue is chance.
//!
//! `cargo run --release -p workbench -- --preview`
use workbench::{Error, Finished, NoExtra, Probe, Run, SceneFile, Stage, Unwatched};

const STAGE: Stage = Stage {
    name: "workbench",
    about: "Stage 0: shows the film itself, before the first ray",
    scene: "teapot",
    samples: 1,
    depth: None,
    estimates: false,
};

fn main() -> std::process::ExitCode {
    workbench::main(&STAGE, |run| match run.recorder() {
        Some(recorder) => paint(run, recorder),
        None => paint(run, &Unwatched),
    })
}

// ANCHOR: paint
fn paint<P: Probe>(run: &Run<NoExtra>, probe: &P) -> Result<Finished, Error> {
    let scene = run.load(SceneFile::load)?;
    let film = run.render(scene.exposure(), probe, |point, sampler| {
        probe.tell(|| format!("film point ({}, {})", point.x, point.y));
        [point.x / point.size[0] as f32, point.y / point.size[1] as f32, sampler.next_1d()]
    })?;
    run.save(&film)
}
// ANCHOR_END: paint
