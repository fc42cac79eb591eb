//! Small scenes, and what paths find in them.

use std::fs;
use std::path::Path;

use blinn_phong::Picture;
use glam::Vec3;
use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::{LinearSearch, Ray, Rgb, Scene};
use rendering_equation::directions::uniform_sphere;
use rendering_equation::{Anything, Density};
use statistics::{Moments, seed};
use workbench::{Sampler, Unwatched};

/// Paths that only chance ends, as the stage follows them by default.
pub(crate) const ROULETTE: Ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };

/// The same for loops with a mistake that may make throughput: what lies beyond, at an albedo of
/// 0.8, is a ten-thousandth.
pub(crate) const BOUNDED: Ending = Ending { depth: 40, roulette: Roulette::Throughput };

/// Paths that only the depth ends.
pub(crate) const fn depth(depth: u32) -> Ending {
    Ending { depth, roulette: Roulette::Off }
}

/// Paths that a constant probability ends.
pub(crate) const fn constant(q: f32) -> Ending {
    Ending { depth: u32::MAX, roulette: Roulette::Constant(q) }
}

/// A scene of the workspace.
pub(crate) fn asset(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// A scene with these records, in a sky of this radiance; the eye is at the origin.
pub(crate) fn scene(sky: f32, records: &str) -> Scene {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    let text = format!(
        "background = [{sky}, {sky}, {sky}]\n\
         [camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\nfov = 40\nsize = [8, 8]\n{records}"
    );
    fs::write(&path, text).expect("the scene is written");
    Scene::load(&path).unwrap_or_else(|error| panic!("{error}, for:\n{records}"))
}

/// A material that reflects `kd` and shines with `ke`.
pub(crate) fn matte(name: &str, kd: f32, ke: f32) -> String {
    format!("[materials.{name}]\nkd = [{kd}, {kd}, {kd}]\nke = [{ke}, {ke}, {ke}]\n")
}

/// A material of a kind that has one more key, a number or a colour.
pub(crate) fn special(name: &str, surface: &str, key: &str, value: &str) -> String {
    format!("[materials.{name}]\nsurface = '{surface}'\n{key} = {value}\n")
}

pub(crate) fn sphere(center: [f32; 3], radius: f32, material: &str) -> String {
    format!("[[sphere]]\ncenter = {center:?}\nradius = {radius:?}\nmaterial = '{material}'\n")
}

pub(crate) fn quad(vertices: [[f32; 3]; 4], material: &str) -> String {
    format!("[[quad]]\nvertices = {vertices:?}\nmaterial = '{material}'\n")
}

/// The faces of a block from −`half` to `half`, moved by `center`: −x, x, −y, y, −z, z.
/// Their fronts look inwards; `outwards` turns them round.
pub(crate) fn block(center: [f32; 3], half: [f32; 3], outwards: bool, faces: [&str; 6]) -> String {
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
    inwards.into_iter().zip(faces).map(|(face, material)| quad(turned(face), material)).collect()
}

/// Two wide plates of one material that face each other: as good as a closed room, and of only four
/// triangles. At an event a path gets as far as their edge with a probability of 10⁻⁸.
pub(crate) fn plates(material: &str) -> String {
    let plate = |z: f32| {
        let (x, y) = (1.0e4, -1.0e4 * z);
        quad([[-x, -y, z], [x, -y, z], [x, y, z], [-x, y, z]], material)
    };
    plate(1.0) + &plate(-1.0)
}

/// A closed room of one material.
pub(crate) fn room(material: &str) -> String {
    block([0.0; 3], [1.0; 3], false, [material; 6])
}

/// From the origin in any direction.
pub(crate) fn anywhere(sampler: &mut Sampler) -> Ray {
    Ray::new(Vec3::ZERO, uniform_sphere(sampler.next_2d()))
}

/// From the origin straight down.
pub(crate) fn across(_: &mut Sampler) -> Ray {
    Ray::new(Vec3::ZERO, Vec3::NEG_Z)
}

/// Calls `look` with a function that follows one path.
pub(crate) fn with_paths<T>(
    scene: &Scene,
    ending: Ending,
    density: Density,
    look: impl FnOnce(&dyn Fn(Ray, &mut Sampler) -> Rgb) -> T,
) -> T {
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(scene, &pictures, &geometry, &Unwatched, density, ending);
    look(&|ray, sampler| tracer.incident_radiance(ray, sampler))
}

/// What `samples` paths find, in the red channel.
pub(crate) fn found(
    scene: &Scene,
    ending: Ending,
    density: Density,
    samples: u64,
    ray: impl Fn(&mut Sampler) -> Ray,
) -> Moments {
    with_paths(scene, ending, density, |follow| {
        gather(samples, |sampler| {
            let radiance = follow(ray(sampler), sampler);
            assert!(radiance.min_element() >= 0.0, "a path found {radiance}: accuracy.md E13");
            radiance
        })
    })
}

/// Mean and variance of the red channel of `samples` estimates.
pub(crate) fn gather(samples: u64, estimate: impl FnMut(&mut Sampler) -> Rgb) -> Moments {
    values(samples, estimate).collect()
}

/// The red channel of `samples` estimates.
pub(crate) fn values(
    samples: u64,
    mut estimate: impl FnMut(&mut Sampler) -> Rgb,
) -> impl Iterator<Item = f64> {
    (0..samples).map(move |i| f64::from(estimate(&mut Sampler::new(seed(6), 0, i)).x))
}

/// That a mean is right, and that a relative bias as large as `visible` would have been seen.
#[track_caller]
pub(crate) fn assert_sees(visible: f64, name: &str, samples: &Moments, expected: f64) {
    let bias = statistics::assert_mean(name, samples, expected);
    assert!(bias <= visible, "{name}: only a bias of {bias} would be seen");
}
