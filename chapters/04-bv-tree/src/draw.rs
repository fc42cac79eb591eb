//! One search for the whole render, chosen by type: no ray asks which it is.

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree, KDop, Obb, TINY};
use clap::ValueEnum;
use mirror_refraction::{Cutoff, Limits, RayTracer, simplifications};
use ray_casting::{Intersect, LinearSearch, Scene};
use workbench::{Counter, Error, Finished, Probe, Run};

/// What this stage adds to the command line.
#[derive(clap::Args)]
pub(crate) struct Extra {
    /// What encloses the nodes of the tree
    #[arg(long, value_enum, default_value_t)]
    volume: Volume,
    /// Where the tree's builder divides
    #[arg(long, value_enum, default_value_t)]
    builder: Builder,
    #[command(flatten)]
    cutoff: Cutoff,
}

/// The kinds of volumes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Volume {
    /// No tree: every ray is tested against every primitive.
    None,
    #[default]
    Aabb,
    Obb,
    Kdop6,
    Kdop14,
    Kdop18,
    Kdop26,
}

/// Renders with the search that the options ask for; a tiny scene is searched faster without a
/// tree.
pub(crate) fn draw<P: Probe>(run: &Run<Extra>, probe: &P) -> Result<Finished, Error> {
    let scene = run.load(Scene::load)?;
    let (geometry, builder) = (&scene.geometry, run.options.stage.builder);
    let mut volume = run.options.stage.volume;
    let is_tiny = geometry.primitives() < TINY && volume != Volume::None;
    if is_tiny && probe.skips(Counter::TreesNotBuilt) {
        probe.count(Counter::TreesNotBuilt, 1);
        run.note(format!("no tree for {} primitives", geometry.primitives()));
        volume = Volume::None;
    }
    match volume {
        Volume::None => trace(run, &scene, probe, || LinearSearch::new(geometry, probe)),
        Volume::Aabb => {
            trace(run, &scene, probe, || BvTree::<Aabb, P>::build(geometry, builder, probe))
        }
        Volume::Obb => {
            trace(run, &scene, probe, || BvTree::<Obb, P>::build(geometry, builder, probe))
        }
        Volume::Kdop6 => {
            trace(run, &scene, probe, || BvTree::<KDop<3>, P>::build(geometry, builder, probe))
        }
        Volume::Kdop14 => {
            trace(run, &scene, probe, || BvTree::<KDop<7>, P>::build(geometry, builder, probe))
        }
        Volume::Kdop18 => {
            trace(run, &scene, probe, || BvTree::<KDop<9>, P>::build(geometry, builder, probe))
        }
        Volume::Kdop26 => {
            trace(run, &scene, probe, || BvTree::<KDop<13>, P>::build(geometry, builder, probe))
        }
    }
}

/// Chapter 3's recursion, unchanged, over whatever search `build` makes.
fn trace<P: Probe, G: Intersect>(
    run: &Run<Extra>,
    scene: &Scene,
    probe: &P,
    build: impl FnOnce() -> G,
) -> Result<Finished, Error> {
    simplifications(scene).into_iter().for_each(|sentence| run.note(sentence));
    let pictures = run.load(|_| Picture::load_worn(scene, probe))?;
    let geometry = run.build(build);
    let limits = Limits::new(run.depth(), run.options.stage.cutoff.cutoff);
    let tracer = RayTracer::new(scene, &pictures, &geometry, probe, limits);
    let film = run.render(scene.exposure, probe, |film_point, _| {
        tracer.incident_radiance(scene.camera.ray(film_point))
    })?;
    run.save(&film)
}
