//! What this stage is called, and what it adds to the command line.

use clap::Args;
use ray_casting::{Intersect, Scene};
use rendering_equation::{Code, Density, Has, Job, Renderer, simplifications};
use workbench::{Error, Film, Probe, Run, Stage};

use crate::radiance::PathTracer;
use crate::roulette::{Ending, Roulette};

/// The name of this stage, and what it does when the command line says nothing.
pub const STAGE: Stage = Stage {
    name: "path-tracing",
    about: "Follows one random path per sample",
    scene: "cornell-box",
    samples: 64,
    depth: None,
    estimates: true,
};

/// The options of this chapter.
#[derive(Args, Clone, Copy, Debug)]
pub struct Extra {
    /// How directions at a matte surface are chosen
    #[arg(long, value_enum, default_value_t)]
    pub density: Density,
    /// How paths end
    #[command(flatten)]
    pub ends: Ends,
    /// Which code runs
    #[command(flatten)]
    pub code: Code,
}

/// How paths end, as far as the command line says.
#[derive(Args, Clone, Copy, Debug)]
pub struct Ends {
    /// What ends paths before --depth does: `throughput`, `off`, or a constant probability to go on
    #[arg(long, value_name = "Q", default_value = "throughput")]
    pub roulette: Roulette,
}

impl Ends {
    /// The ending that the command line asks for.
    ///
    /// # Errors
    /// When nothing would end a path.
    pub fn ending(self, depth: Option<u32>) -> Result<Ending, Error> {
        let endless = matches!(self.roulette, Roulette::Off | Roulette::Constant(1.0));
        match depth {
            None if endless => Err(Error::CommandLine(
                "without roulette nothing ends a path: give `--depth D`, too".to_owned(),
            )),
            _ => Ok(Ending { depth: depth.unwrap_or(u32::MAX), roulette: self.roulette }),
        }
    }
}

impl Renderer for Extra {
    fn code(&self) -> Code {
        self.code
    }

    fn remarks(run: &Run<Self>, scene: &Scene) -> Result<Vec<String>, Error> {
        run.options.stage.ends.ending(run.depth())?;
        Ok(simplifications(scene))
    }

    fn render<G: Intersect, P: Probe, H: Has>(
        job: &Job<'_, Self, P>,
        geometry: &G,
    ) -> Result<Film, Error> {
        let Job { run, scene, pictures, probe } = *job;
        let Self { density, ends, .. } = run.options.stage;
        let ending = ends.ending(run.depth())?;
        let tracer: PathTracer<'_, G, P, H> =
            PathTracer::new(scene, pictures, geometry, probe, density, ending);
        run.render(scene.exposure, probe, |film_point, sampler| {
            tracer.incident_radiance(scene.camera.ray(film_point), sampler)
        })
    }
}
