//! What this stage is called, and what it adds to the command line.

use clap::Args;
use ray_casting::{Intersect, Scene};
use workbench::{Error, Film, Probe, Run, Stage};

use crate::directions::Density;
use crate::radiance::{Branching, DistributedTracer, simplifications};
use crate::search::{Job, Renderer};
use crate::survey::{Code, Has};

/// The name of this stage, and what it does when the command line says nothing.
pub const STAGE: Stage = Stage {
    name: "rendering-equation",
    about: "Follows N random directions from every hit",
    scene: "cornell-box",
    samples: 16,
    depth: Some(4),
    estimates: true,
};

/// The options of this chapter.
#[derive(Args, Clone, Copy, Debug)]
pub struct Extra {
    /// Directions that are followed from a matte surface
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..))]
    pub branching: u32,
    /// How they are chosen
    #[arg(long, value_enum, default_value_t)]
    pub density: Density,
    /// Which code runs
    #[command(flatten)]
    pub code: Code,
}

/// The deepest recursion; its frames fit on the stack of any thread.
const DEEPEST: u32 = 500;

impl Renderer for Extra {
    fn code(&self) -> Code {
        self.code
    }

    fn remarks(run: &Run<Self>, scene: &Scene) -> Result<Vec<String>, Error> {
        let mut sentences = simplifications(scene);
        if run.depth().is_none_or(|depth| depth > DEEPEST) {
            sentences.push(format!("the recursion ends at depth {DEEPEST}"));
        }
        Ok(sentences)
    }

    fn render<G: Intersect, P: Probe, H: Has>(
        job: &Job<'_, Self, P>,
        geometry: &G,
    ) -> Result<Film, Error> {
        let Job { run, scene, pictures, probe } = *job;
        let Self { branching: directions, density, .. } = run.options.stage;
        let depth = run.depth().map_or(DEEPEST, |depth| depth.min(DEEPEST));
        let branching = Branching { directions, depth, density };
        let tracer: DistributedTracer<'_, G, P, H> =
            DistributedTracer::new(scene, pictures, geometry, probe, branching);
        run.render(scene.exposure, probe, |film_point, sampler| {
            tracer.incident_radiance(scene.camera.ray(film_point), sampler)
        })
    }
}
