//! Shadow rays that start by a constant, and by an error bound.

use glam::{Vec3, vec3};
use ray_casting::{
    Attributes, Camera, Geometry, Intersect, LinearSearch, Ray, Rgb, Scene, Sphere, SurfacePoint,
    surface_point,
};
use workbench::{FilmSettings, Unwatched, expose};

use super::stage::scene;
use crate::figures::Drawing;
use crate::picture::Picture;

/// The sizes at which the same scene is drawn.
const SCALES: [f32; 3] = [4e-4, 1.0, 1e5];

/// The constant that ray tracers have used for decades.
const EPSILON: f32 = 1e-3;

const PANEL: FilmSettings = FilmSettings { size: [240, 160], samples: 16, seed: 0, threads: None };

/// A ball on a floor, `scale` times as large as at 1.
fn ball_on_floor(scale: f32) -> Scene {
    let corner = |x: f32, z: f32| scale * vec3(x, 0.0, z);
    let camera = Camera {
        eye: scale * vec3(0.0, 2.0, 6.0),
        forward: vec3(0.0, -0.28, -0.96),
        right: Vec3::X,
        up: vec3(0.0, 0.96, -0.28),
        half_height: 0.35,
    };
    Scene {
        camera,
        geometry: Geometry {
            vertices: vec![
                corner(-9.0, 5.0),
                corner(9.0, 5.0),
                corner(9.0, -13.0),
                corner(-9.0, -13.0),
            ],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            spheres: vec![Sphere { center: scale * vec3(0.3, 1.0, 0.1), radius: scale }],
        },
        attributes: Attributes { materials: vec![0; 3], ..Attributes::default() },
        ..scene("furnace")
    }
}

/// Draws the scene at each scale, with shadow rays made by `shadow_ray`.
fn at_all_scales(shadow_ray: fn(&SurfacePoint, Vec3) -> Ray) -> Drawing {
    let panels = SCALES.map(|scale| {
        let scene = ball_on_floor(scale);
        let light = scale * vec3(-5.0, 6.0, 4.0);
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        let image = expose(&PANEL, |point, _| {
            let ray = scene.camera.ray(point);
            let Some(hit) = geometry.intersect(&ray) else { return Rgb::new(0.05, 0.06, 0.08) };
            let surface = scene.surface(&ray, &hit);
            let cos_theta = surface.facing_normal().dot((light - surface.position).normalize());
            let lit = cos_theta > 0.0 && !geometry.occluded(&shadow_ray(&surface, light));
            Rgb::splat(0.06 + if lit { 0.6 * cos_theta } else { 0.0 })
        });
        Picture::from(&image)
    });
    Picture::side_by_side(&panels, 8).into()
}

/// A constant offset: right at one scale.
pub(super) fn epsilon() -> Drawing {
    at_all_scales(|surface, light| {
        let path = light - surface.position;
        let distance = path.length();
        let mut ray = surface_point::offset_by_epsilon(surface, path / distance, EPSILON);
        ray.extent.max = distance;
        ray
    })
}

/// The error bound: the same picture at every scale.
pub(super) fn spawn() -> Drawing {
    at_all_scales(SurfacePoint::spawn_to)
}
