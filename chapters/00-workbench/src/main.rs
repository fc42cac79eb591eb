//! Stage 0: a picture before the first ray. Red is the column, green the row, blue is chance.
//!
//! `cargo run --release -p workbench -- --preview`

use std::process::ExitCode;

use workbench::{Exposure, NoExtra, Run, SceneFile, Stage};

const STAGE: Stage = Stage {
    name: "workbench",
    about: "Stage 0: shows the film itself, before the first ray",
    scene: "teapot",
    samples: 1,
    depth: None,
    estimates: false,
};

fn main() -> ExitCode {
    workbench::main(&STAGE, |run: &Run<NoExtra>| {
        let scene = run.load(SceneFile::load)?;
        let exposure = Exposure {
            size: scene.camera.size,
            samples: scene.samples,
        };
        scene.notices.iter().for_each(|notice| run.note(notice));
        let film = run.render(exposure, &workbench::Unwatched, |point, sampler| {
            let [width, height] = point.size.map(|side| side as f32);
            [point.x / width, point.y / height, sampler.next_1d()]
        })?;
        run.save(&film)
    })
}
