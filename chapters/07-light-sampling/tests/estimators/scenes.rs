//! Small scenes, put together without a file, and what arrives along a ray.

use std::path::Path;

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use glam::{DVec3, Vec3};
use light_sampling::{Estimator, LightTracer, Settings};
use path_tracing::{Ending, Roulette};
use ray_casting::{
    Attributes, Camera, Geometry, LinearSearch, PointLight, Ray, Rgb, Scene, Sphere,
};
use rendering_equation::{Anything, Has};
use statistics::{Moments, seed};
use workbench::{
    CameraRecord, Estimate, Exposure, FilmSettings, MaterialRecord, Probe, Sampler, SurfaceKind,
    Unwatched, expose_estimate,
};

/// All ways to find lamps.
pub(crate) const ESTIMATORS: [Estimator; 3] =
    [Estimator::Scatter, Estimator::Light, Estimator::Mis];

/// Paths that only roulette ends.
pub(crate) fn endless(estimator: Estimator) -> Settings {
    let ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };
    Settings { estimator, ..Settings::new(ending) }
}

/// Paths of at most `depth` scattering events, all of which are followed.
pub(crate) fn limited(estimator: Estimator, depth: u32) -> Settings {
    let ending = Ending { depth, roulette: Roulette::Off };
    Settings { ending, ..endless(estimator) }
}

/// A scene of the workspace.
pub(crate) fn asset(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// An empty scene without any light; the eye is at (0, 0, 5) and looks along −z.
pub(crate) fn dark(materials: impl IntoIterator<Item = MaterialRecord>) -> Scene {
    let camera = CameraRecord {
        eye: [0.0, 0.0, 5.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov: 40.0,
        size: [16, 16],
    };
    Scene {
        camera: Camera::from(&camera),
        focus: 5.0,
        exposure: Exposure { size: camera.size, samples: None },
        geometry: Geometry::default(),
        attributes: Attributes::default(),
        materials: materials.into_iter().collect(),
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::ZERO,
        background: Rgb::ZERO,
        notices: Vec::new(),
    }
}

pub(crate) fn matte(kd: f32) -> MaterialRecord {
    MaterialRecord { kd: [kd; 3], ..MaterialRecord::new("matte") }
}

/// Shines with radiance `ke` and reflects the share `kd`.
pub(crate) fn lamp(ke: f32, kd: f32) -> MaterialRecord {
    MaterialRecord { ke: [ke; 3], kd: [kd; 3], ..MaterialRecord::new("lamp") }
}

pub(crate) fn glass(ni: f32) -> MaterialRecord {
    MaterialRecord { surface: SurfaceKind::Glass, ni, ..MaterialRecord::new("glass") }
}

pub(crate) fn mirror(kr: f32) -> MaterialRecord {
    MaterialRecord { surface: SurfaceKind::Mirror, kr: [kr; 3], ..MaterialRecord::new("mirror") }
}

/// Call before any sphere: triangles are numbered first.
pub(crate) fn add_triangle(scene: &mut Scene, vertices: [Vec3; 3], material: u32) {
    let first = scene.geometry.vertices.len() as u32;
    scene.geometry.vertices.extend(vertices);
    scene.geometry.triangles.push([first, first + 1, first + 2]);
    scene.attributes.materials.push(material);
}

/// Two triangles; call before any sphere.
pub(crate) fn add_quad(scene: &mut Scene, [a, b, c, d]: [Vec3; 4], material: u32) {
    add_triangle(scene, [a, b, c], material);
    add_triangle(scene, [a, c, d], material);
}

pub(crate) fn add_sphere(scene: &mut Scene, center: Vec3, radius: f32, material: u32) {
    scene.geometry.spheres.push(Sphere { center, radius });
    scene.attributes.materials.push(material);
}

/// A block from corner `a` to corner `b`, normals outwards.
pub(crate) fn add_block(scene: &mut Scene, a: Vec3, b: Vec3, material: u32) {
    for face in block_faces(a, b) {
        add_quad(scene, face, material);
    }
}

fn block_faces(a: Vec3, b: Vec3) -> [[Vec3; 4]; 6] {
    let corner = |i: usize| {
        let pick = |axis: usize| if i >> axis & 1 == 0 { a[axis] } else { b[axis] };
        Vec3::new(pick(0), pick(1), pick(2))
    };
    let faces =
        [[4, 5, 7, 6], [1, 0, 2, 3], [0, 4, 6, 2], [5, 1, 3, 7], [6, 7, 3, 2], [0, 1, 5, 4]];
    faces.map(|face| face.map(corner))
}

/// A cube from −1 to 1, normals inwards.
pub(crate) fn add_room(scene: &mut Scene, material: u32) {
    for [a, b, c, d] in block_faces(Vec3::NEG_ONE, Vec3::ONE) {
        add_quad(scene, [a, d, c, b], material);
    }
}

/// The unit sphere, seen from inside, as 8 · 4^`level` triangles that face inwards. `material` says
/// what each of the octants is made of, in the order of the signs of (x, y, z) as a binary number.
pub(crate) fn add_hollow_ball(scene: &mut Scene, level: u32, material: impl Fn(usize) -> u32) {
    for octant in 0..8 {
        let sign = |axis: usize| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 };
        let [sx, sy, sz] = [0, 1, 2].map(sign);
        let mut corners = [DVec3::X * sx, DVec3::Y * sy, DVec3::Z * sz];
        if sx * sy * sz > 0.0 {
            corners.swap(1, 2);
        }
        divide(corners, level, &mut |corners| {
            add_triangle(scene, corners.map(|v| v.as_vec3()), material(octant));
        });
    }
}

fn divide(corners: [DVec3; 3], level: u32, add: &mut impl FnMut([DVec3; 3])) {
    if level == 0 {
        return add(corners);
    }
    let [a, b, c] = corners;
    let [ab, bc, ca] = [a + b, b + c, c + a].map(DVec3::normalize);
    for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
        divide(part, level - 1, add);
    }
}

/// A small white square in the plane y = 0, seen from above at the origin.
pub(crate) fn receiver(materials: impl IntoIterator<Item = MaterialRecord>) -> Scene {
    let mut scene = dark([matte(1.0)].into_iter().chain(materials));
    let corners = [(-0.01, 0.01), (0.01, 0.01), (0.01, -0.01), (-0.01, -0.01)];
    add_quad(&mut scene, corners.map(|(x, z)| Vec3::new(x, 0.0, z)), 0);
    scene
}

/// A ray that meets the [`receiver`] near its middle, off the diagonal, from a side on which no
/// lamp stands in its way.
pub(crate) fn at_receiver() -> Ray {
    let origin = Vec3::new(-0.02, 0.005, 0.001);
    Ray::new(origin, (RECEIVING - origin).normalize())
}

/// Where [`at_receiver`] meets the receiver.
pub(crate) const RECEIVING: Vec3 = Vec3::new(0.0, 0.0, 1e-6);

/// `n` samples of what arrives against `ray`, the mean of the channels.
pub(crate) fn radiance(scene: &Scene, settings: Settings, ray: Ray, n: u32) -> Moments {
    // One stream: the samples of a test are independent, those of two estimators may be the same.
    let mut sampler = Sampler::new(seed(0x07), 0, 0);
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: LightTracer<'_, _, _, Anything> =
        LightTracer::new(scene, &[], &geometry, &Unwatched, settings);
    (0..n)
        .map(|_| {
            let radiance = tracer.incident_radiance(ray, &mut sampler);
            f64::from(radiance.element_sum()) / 3.0
        })
        .collect()
}

/// `n` samples along one ray, watched.
pub(crate) fn watched<P: Probe>(scene: &Scene, settings: Settings, ray: Ray, n: u32, probe: &P) {
    let mut sampler = Sampler::new(seed(0x07), 0, 0);
    let geometry = LinearSearch::new(&scene.geometry, probe);
    let tracer: LightTracer<'_, _, _, Anything> =
        LightTracer::new(scene, &[], &geometry, probe, settings);
    for _ in 0..n {
        let _ = tracer.incident_radiance(ray, &mut sampler);
    }
}

/// The picture of a scene with its noise.
pub(crate) fn picture<H: Has>(scene: &Scene, settings: Settings, film: &FilmSettings) -> Estimate {
    let pictures = Picture::load_all(scene).unwrap_or_else(|e| panic!("{e}"));
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: LightTracer<'_, _, _, H> =
        LightTracer::new(scene, &pictures, &geometry, &Unwatched, settings);
    expose_estimate(film, |point, sampler| {
        tracer.incident_radiance(scene.camera.ray(point), sampler)
    })
}

/// A point light with the I of a scene file.
pub(crate) fn point_light(position: Vec3, intensity: Rgb) -> PointLight {
    PointLight::new(position, intensity)
}
