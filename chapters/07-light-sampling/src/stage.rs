//! What this stage is called, and what it adds to the command line.

use clap::Args;
use path_tracing::Ends;
use ray_casting::{Intersect, Scene};
use rendering_equation::{Code, Has, Job, Renderer, remarks, simplifications};
use workbench::{Error, Film, Probe, Run, Stage};

use crate::choice::Choice;
use crate::flat_lamp::Measure;
use crate::heuristic::{Estimator, Heuristic};
use crate::radiance::{LightTracer, Settings};

/// The name of this stage, and what it does when the command line says nothing.
pub const STAGE: Stage = Stage {
    name: "light-sampling",
    about: "Follows random paths and samples the lights at every hit",
    scene: "cornell-box",
    samples: 64,
    depth: None,
    estimates: true,
};

/// The options of this chapter.
#[derive(Args, Clone, Copy, Debug)]
pub struct Extra {
    /// How lamps are found
    #[arg(long, value_enum, default_value_t)]
    pub estimator: Estimator,
    /// How the two ways to find a lamp are weighed
    #[arg(long, value_enum, default_value_t)]
    pub heuristic: Heuristic,
    /// What the choice of a light is in proportion to
    #[arg(long, value_enum, default_value_t)]
    pub choice: Choice,
    /// In which measure flat lamps are sampled uniformly
    #[arg(long, value_enum, default_value_t)]
    pub measure: Measure,
    /// How paths end
    #[command(flatten)]
    pub ends: Ends,
    /// Which code runs
    #[command(flatten)]
    pub code: Code,
}

impl Renderer for Extra {
    fn code(&self) -> Code {
        self.code
    }

    fn remarks(run: &Run<Self>, scene: &Scene) -> Result<Vec<String>, Error> {
        run.options.stage.ends.ending(run.depth())?;
        // Only who waits to meet the lamps does not find the point lights.
        Ok(match run.options.stage.estimator {
            Estimator::Scatter => simplifications(scene),
            Estimator::Light | Estimator::Mis => remarks(scene),
        })
    }

    fn render<G: Intersect, P: Probe, H: Has>(
        job: &Job<'_, Self, P>,
        geometry: &G,
    ) -> Result<Film, Error> {
        let Job { run, scene, pictures, probe } = *job;
        let Self { estimator, heuristic, choice, measure, ends, .. } = run.options.stage;
        let ending = ends.ending(run.depth())?;
        let settings = Settings { estimator, heuristic, choice, measure, ending };
        let tracer: LightTracer<'_, G, P, H> =
            LightTracer::new(scene, pictures, geometry, probe, settings);
        run.render(scene.exposure, probe, |film_point, sampler| {
            tracer.incident_radiance(scene.camera.ray(film_point), sampler)
        })
    }
}
