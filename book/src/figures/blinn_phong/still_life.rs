//! Small scenes that no file describes, and shading that is not the stage's.

use blinn_phong::{Material, Picture as Texture, Shader, Terms};
use bv_tree::{Aabb, Builder, BvTree};
use glam::{Vec3, vec3};
use ray_casting::{Attributes, Camera, Geometry, Intersect, PointLight, Rgb, Scene, SurfacePoint};
use workbench::{CameraRecord, Exposure, FilmSettings, Image, MaterialRecord, Unwatched, expose};

use crate::figures::scene_file;

/// What nothing is in front of.
pub(super) const DUSK: Rgb = Rgb::new(0.05, 0.06, 0.08);

/// One of several pictures in a row.
pub(super) const PANEL: FilmSettings =
    FilmSettings { size: [240, 160], samples: 16, seed: 0, threads: None };

/// One of the course's scenes.
pub(super) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The scene's textures, decoded.
pub(super) fn textures(scene: &Scene) -> Vec<Texture> {
    Texture::load_all(scene).unwrap_or_else(|error| panic!("{error}"))
}

/// A scene of one's own, before the dusk, seen from `eye`; all primitives of the first material.
pub(super) fn still_life(eye: Vec3, target: Vec3, fov: f32, geometry: Geometry) -> Scene {
    let record = CameraRecord {
        eye: eye.to_array(),
        target: target.to_array(),
        up: [0.0, 1.0, 0.0],
        fov,
        size: PANEL.size,
    };
    let materials = vec![0; geometry.primitives() as usize];
    Scene {
        camera: Camera::from(&record),
        focus: eye.distance(target),
        exposure: Exposure { size: PANEL.size, samples: None },
        geometry,
        attributes: Attributes { materials, ..Attributes::default() },
        materials: vec![clay()],
        textures: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::splat(0.02),
        background: DUSK,
        notices: Vec::new(),
    }
}

/// A surface with a diffuse and a specular part.
pub(super) fn clay() -> MaterialRecord {
    MaterialRecord { kd: [0.5, 0.3, 0.2], ks: [0.5; 3], ns: 64.0, ..MaterialRecord::new("clay") }
}

/// A light that a white surface which faces it from `position`, seen at the origin, turns to
/// radiance `at_origin`.
pub(super) fn light(position: Vec3, at_origin: f32) -> PointLight {
    PointLight::new(position, Rgb::splat(at_origin * position.length_squared()))
}

/// The corners of a floor at height 0 and its two triangles.
pub(super) fn floor(size: f32) -> Geometry {
    let corner = |x: f32, z: f32| vec3(x * size, 0.0, z * size);
    Geometry {
        vertices: vec![corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        spheres: Vec::new(),
    }
}

/// The tree of chapter 4: it finds the hits that linear search finds, sooner.
pub(super) fn tree(scene: &Scene) -> BvTree<'static, Aabb, Unwatched> {
    BvTree::build(&scene.geometry, Builder::default(), &Unwatched)
}

/// What the stage draws.
pub(super) fn draw(scene: &Scene, settings: &FilmSettings) -> Image {
    draw_terms(scene, &tree(scene), Terms::All, settings)
}

/// What the stage draws with `--terms`.
pub(super) fn draw_terms(
    scene: &Scene,
    geometry: &impl Intersect,
    terms: Terms,
    settings: &FilmSettings,
) -> Image {
    let textures = textures(scene);
    let shader = Shader::new(scene, &textures, geometry, &Unwatched, terms);
    expose(settings, |point, _| shader.incident_radiance(scene.camera.ray(point)))
}

/// Equation 3 with another idea of what one light contributes: `reflected` is given the surface,
/// its material and the light, and has to see to visibility itself.
pub(super) fn draw_otherwise(
    scene: &Scene,
    geometry: &impl Intersect,
    settings: &FilmSettings,
    reflected: impl Fn(&SurfacePoint, &Material, &PointLight) -> Rgb + Sync,
) -> Image {
    let materials: Vec<_> = scene.materials.iter().map(Material::from).collect();
    expose(settings, |point, _| {
        let ray = scene.camera.ray(point);
        let Some(hit) = geometry.intersect(&ray) else { return scene.background };
        let surface = scene.surface(&ray, &hit);
        let material = &materials[surface.material as usize];
        let lights = scene.lights.iter().map(|light| reflected(&surface, material, light));
        scene.ambient + lights.sum::<Rgb>()
    })
}
