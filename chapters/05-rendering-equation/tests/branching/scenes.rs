//! Small scenes, and what branching paths find in them.

use std::fs;
use std::path::Path;

use blinn_phong::Picture;
use glam::Vec3;
use ray_casting::{Hit, Intersect, LinearSearch, Ray, Rgb, Scene};
use rendering_equation::directions::uniform_sphere;
use rendering_equation::{Anything, Branching, Density, DistributedTracer};
use statistics::{Moments, seed};
use workbench::{Sampler, Unwatched};

/// A scene of the workspace.
pub(crate) fn asset(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// A scene with these records, in a sky of this radiance; the eye is at `eye` and looks along −z.
pub(crate) fn scene(eye: [f32; 3], sky: f32, records: &str) -> Scene {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    let target = [eye[0], eye[1], eye[2] - 1.0];
    let text = format!(
        "background = [{sky}, {sky}, {sky}]\n\
         [camera]\neye = {eye:?}\ntarget = {target:?}\nfov = 40\nsize = [8, 8]\n{records}"
    );
    fs::write(&path, text).expect("the scene is written");
    Scene::load(&path).unwrap_or_else(|error| panic!("{error}, for:\n{records}"))
}

/// A material that reflects `kd` and shines with `ke`.
pub(crate) fn matte(name: &str, kd: f32, ke: f32) -> String {
    format!("[materials.{name}]\nkd = [{kd}, {kd}, {kd}]\nke = [{ke}, {ke}, {ke}]\n")
}

/// Clear glass.
pub(crate) fn glass(name: &str, ni: f32) -> String {
    format!("[materials.{name}]\nsurface = 'glass'\nni = {ni:?}\n")
}

pub(crate) fn sphere(center: [f32; 3], radius: f32, material: &str) -> String {
    format!("[[sphere]]\ncenter = {center:?}\nradius = {radius:?}\nmaterial = '{material}'\n")
}

pub(crate) fn quad(vertices: [[f32; 3]; 4], material: &str) -> String {
    format!("[[quad]]\nvertices = {vertices:?}\nmaterial = '{material}'\n")
}

/// A block from −`half` to `half`, moved by `center`. Its fronts look inwards; `outwards` turns them
/// round.
pub(crate) fn block(center: [f32; 3], half: [f32; 3], outwards: bool, material: &str) -> String {
    let corner = |i: usize| {
        [0, 1, 2]
            .map(|axis| center[axis] + if i >> axis & 1 == 0 { -half[axis] } else { half[axis] })
    };
    let inwards =
        [[0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5]];
    let turned = |mut face: [usize; 4]| {
        if outwards {
            face.reverse();
        }
        face.map(corner)
    };
    inwards.into_iter().map(|face| quad(turned(face), material)).collect()
}

pub(crate) const fn branching(directions: u32, depth: u32, density: Density) -> Branching {
    Branching { directions, depth, density }
}

/// From a point in any direction.
pub(crate) fn anywhere(from: Vec3, sampler: &mut Sampler) -> Ray {
    Ray::new(from, uniform_sphere(sampler.next_2d()))
}

/// Calls `look` with a function that estimates what arrives against a ray.
pub(crate) fn with_tracer<T>(
    scene: &Scene,
    branching: Branching,
    look: impl FnOnce(&dyn Fn(Ray, &mut Sampler) -> Rgb) -> T,
) -> T {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    with_tracer_over(scene, &geometry, branching, look)
}

/// The same over any search.
pub(crate) fn with_tracer_over<G: Intersect, T>(
    scene: &Scene,
    geometry: &G,
    branching: Branching,
    look: impl FnOnce(&dyn Fn(Ray, &mut Sampler) -> Rgb) -> T,
) -> T {
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let tracer: DistributedTracer<'_, _, _, Anything> =
        DistributedTracer::new(scene, &pictures, geometry, &Unwatched, branching);
    look(&|ray, sampler| {
        let radiance = tracer.incident_radiance(ray, sampler);
        assert!(radiance.min_element() >= 0.0, "a path found {radiance}: accuracy.md E13");
        radiance
    })
}

/// What `samples` estimates find, in the red channel.
pub(crate) fn found(
    scene: &Scene,
    branching: Branching,
    samples: u64,
    ray: impl Fn(&mut Sampler) -> Ray,
) -> Moments {
    with_tracer(scene, branching, |radiance| {
        gather(samples, |sampler| radiance(ray(sampler), sampler))
    })
}

/// Mean and variance of the red channel of `samples` estimates.
pub(crate) fn gather(samples: u64, mut estimate: impl FnMut(&mut Sampler) -> Rgb) -> Moments {
    (0..samples).map(|i| f64::from(estimate(&mut Sampler::new(seed(5), 30, i)).x)).collect()
}

/// That a mean is right, and that a relative bias as large as `visible` would have been seen.
#[track_caller]
pub(crate) fn assert_sees(visible: f64, name: &str, samples: &Moments, expected: f64) {
    let bias = statistics::assert_mean(name, samples, expected);
    assert!(bias <= visible, "{name}: only a bias of {bias} would be seen");
}

/// A search in which the unit sphere around the origin has a hole: the cap above z = `height`.
pub(crate) struct Pierced<'a, G> {
    pub(crate) whole: &'a G,
    pub(crate) height: f32,
}

impl<G: Intersect> Intersect for Pierced<'_, G> {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.whole.intersect(ray).filter(|hit| ray.at(hit.t).z <= self.height)
    }
}
