//! The explosion of rays, counted: accuracy.md E15.

use crate::scenes::{block, branching, gather, matte, scene, sphere, with_tracer};
use glam::Vec3;
use ray_casting::{LinearSearch, Ray, Scene};
use rendering_equation::{Anything, Density, DistributedTracer, Opaque};
use statistics::assert_same_mean;
use workbench::{Counter, Probe, Recorder, Sampler};

/// A closed room whose walls reflect and shine unevenly.
fn room() -> Scene {
    let materials = matte("wall", 0.7, 1.0) + &matte("lamp", 0.3, 5.0);
    let records = materials
        + &block([0.0; 3], [1.0; 3], false, "wall")
        + &sphere([0.3, 0.5, -0.4], 0.45, "lamp");
    scene([0.0; 3], 0.0, &records)
}

fn ray() -> Ray {
    Ray::new(Vec3::ZERO, Vec3::new(0.2, -0.3, 1.0).normalize())
}

/// 1 + N + N² + … + N^D: the rays of one camera ray, itself included.
fn nodes(n: u64, depth: u32) -> u64 {
    (0..=depth).map(|level| n.pow(level)).sum()
}

/// No ray of a closed room ends early: a cosine direction is never below the surface.
#[test]
fn the_rays_of_a_closed_room_are_a_geometric_sum() {
    let scene = room();
    for (n, depth) in [(4, 5), (1, 5), (2, 8), (8, 3), (3, 0)] {
        let recorder = Recorder::new();
        let geometry = LinearSearch::new(&scene.geometry, &recorder);
        let tracer: DistributedTracer<'_, _, _, Opaque> = DistributedTracer::new(
            &scene,
            &[],
            &geometry,
            &recorder,
            branching(n, depth, Density::Cosine),
        );
        tracer.incident_radiance(ray(), &mut Sampler::new(0, 0, 0));
        let rays = 1 + recorder.get(Counter::ScatterRays);
        assert_eq!(rays, nodes(n.into(), depth), "N = {n}, D = {depth}");
        let leaves = recorder.get(Counter::PathsEndedByDepth);
        assert_eq!(leaves, u64::from(n).pow(depth), "leaves for N = {n}, D = {depth}");
    }
    assert_eq!(nodes(4, 5), 1365, "the number of the table");
}

/// The mean does not depend on N, only the price of it does.
#[test]
fn more_directions_do_not_change_the_mean() {
    let scene = room();
    for (density, limit) in [(Density::Cosine, 0.03), (Density::Uniform, 0.08)] {
        let estimates = |n, samples| {
            with_tracer(&scene, branching(n, 5, density), |radiance| {
                gather(samples, |sampler| radiance(ray(), sampler))
            })
        };
        let (one, four) = (estimates(1, 40_000), estimates(4, 600));
        let visible = assert_same_mean(&format!("{density:?}"), &one, &four);
        assert!(visible <= limit, "{density:?}: a difference of {visible} would be seen");
        let two = estimates(2, 8_000);
        let visible = assert_same_mean(&format!("{density:?}"), &one, &two);
        assert!(visible <= limit, "{density:?}: a difference of {visible} would be seen");
        // A hit costs the same ray whatever N is: the variance of one estimate falls slower than
        // its number of rays grows.
        let (less, more) = (one.variance() / four.variance(), nodes(4, 5) / nodes(1, 5));
        assert!(less < more as f64, "{density:?}: variance / {less}, rays · {more}");
    }
}

/// A probe that is not told anything is not asked to count either.
#[test]
fn watching_changes_no_bit() {
    let scene = room();
    let recorder = Recorder::new();
    let settings = branching(3, 3, Density::Uniform);
    let plain =
        with_tracer(&scene, settings, |radiance| radiance(ray(), &mut Sampler::new(0, 0, 0)));
    let geometry = LinearSearch::new(&scene.geometry, &recorder);
    let tracer: DistributedTracer<'_, _, _, Anything> =
        DistributedTracer::new(&scene, &[], &geometry, &recorder, settings);
    let watched = tracer.incident_radiance(ray(), &mut Sampler::new(0, 0, 0));
    assert_eq!(plain, watched, "with and without a recorder");
    assert!(Recorder::ACTIVE && recorder.get(Counter::ScatterRays) > 0, "the recorder slept");
}
