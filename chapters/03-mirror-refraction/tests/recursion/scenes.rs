//! Small scenes, put together without a file.

use std::path::Path;

use glam::Vec3;
use mirror_refraction::{Limits, RayTracer};
use ray_casting::{Attributes, Camera, Geometry, LinearSearch, Ray, Rgb, Scene, Sphere};
use workbench::{
    CameraRecord, Exposure, FilmSettings, Image, MaterialRecord, SurfaceKind, Unwatched, expose,
};

/// A scene of the workspace.
pub(crate) fn asset(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// An empty scene with a white background; the eye is at (0, 0, 5) and looks along −z.
pub(crate) fn white(materials: impl IntoIterator<Item = MaterialRecord>) -> Scene {
    let camera = CameraRecord {
        eye: [0.0, 0.0, 5.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov: 40.0,
        size: [48, 36],
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
        background: Rgb::ONE,
        notices: Vec::new(),
    }
}

pub(crate) fn glass(ni: f32) -> MaterialRecord {
    MaterialRecord { surface: SurfaceKind::Glass, ni, ..MaterialRecord::new("glass") }
}

pub(crate) fn mirror(kr: f32) -> MaterialRecord {
    MaterialRecord { surface: SurfaceKind::Mirror, kr: [kr; 3], ..MaterialRecord::new("mirror") }
}

/// Neither light nor ambient: as dark as can be.
pub(crate) fn black() -> MaterialRecord {
    MaterialRecord::new("black")
}

/// Call before any sphere: triangles are numbered first.
pub(crate) fn add_quad(scene: &mut Scene, vertices: [Vec3; 4], material: u32) {
    let first = scene.geometry.vertices.len() as u32;
    scene.geometry.vertices.extend(vertices);
    scene.geometry.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| first + i)));
    scene.attributes.materials.extend([material; 2]);
}

pub(crate) fn add_sphere(scene: &mut Scene, center: Vec3, radius: f32, material: u32) {
    scene.geometry.spheres.push(Sphere { center, radius });
    scene.attributes.materials.push(material);
}

/// A block from corner `a` to corner `b`, moved by `place`, all normals outwards.
pub(crate) fn add_block(
    scene: &mut Scene,
    a: Vec3,
    b: Vec3,
    material: u32,
    place: impl Fn(Vec3) -> Vec3,
) {
    let corner = |i: usize| {
        let pick = |axis: usize| if i >> axis & 1 == 0 { a[axis] } else { b[axis] };
        place(Vec3::new(pick(0), pick(1), pick(2)))
    };
    let faces =
        [[4, 5, 7, 6], [1, 0, 2, 3], [0, 4, 6, 2], [5, 1, 3, 7], [6, 7, 3, 2], [0, 1, 5, 4]];
    for face in faces {
        add_quad(scene, face.map(corner), material);
    }
}

/// What arrives against one ray.
pub(crate) fn radiance(scene: &Scene, ray: Ray, limits: Limits) -> Rgb {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    RayTracer::new(scene, &[], &geometry, &Unwatched, limits).incident_radiance(ray)
}

/// The picture of a scene, with 4 samples a pixel.
pub(crate) fn picture(scene: &Scene, size: [u32; 2], limits: Limits) -> Image {
    let pictures = blinn_phong::Picture::load_all(scene).unwrap_or_else(|e| panic!("{e}"));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let tracer = RayTracer::new(scene, &pictures, &geometry, &Unwatched, limits);
    let settings = FilmSettings { size, samples: 4, seed: 0, threads: None };
    expose(&settings, |point, _| tracer.incident_radiance(scene.camera.ray(point)))
}

/// The largest difference of two pictures, and how many pixels differ by more than `tolerance`.
pub(crate) fn difference(a: &Image, b: &Image, tolerance: f32) -> (f32, usize) {
    let worst =
        |(a, b): (&[f32; 3], &[f32; 3])| (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f32::max);
    let all = a.pixels.iter().zip(&b.pixels).map(worst);
    (all.clone().fold(0.0, f32::max), all.filter(|&d| d > tolerance).count())
}
