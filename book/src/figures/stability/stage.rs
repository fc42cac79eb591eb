//! A ball on a floor, of any size and anywhere, and ways to leave a surface.

use glam::{Mat3, Vec3, vec3};
use ray_casting::{
    Attributes, Camera, Geometry, Intersect, Interval, LinearSearch, Ray, Rgb, Scene, Sphere,
    SurfacePoint, surface_point,
};
use workbench::{FilmPoint, FilmSettings, Unwatched, expose};

use crate::figures::scene_file;
use crate::picture::Picture;

/// How a shadow ray leaves a surface for a light.
pub(crate) type Leave = fn(&SurfacePoint, Vec3) -> Ray;

/// From the point itself, as if it lay on the surface.
pub(crate) fn unmoved(surface: &SurfacePoint, light: Vec3) -> Ray {
    let path = light - surface.position;
    let distance = path.length();
    let extent = Interval::new(0.0, distance);
    Ray { extent, ..Ray::new(surface.position, path / distance) }
}

/// The constant that ray tracers have used for decades.
const EPSILON: f32 = 1e-3;

/// A constant further on.
pub(crate) fn by_constant(surface: &SurfacePoint, light: Vec3) -> Ray {
    let path = light - surface.position;
    let distance = path.length();
    let mut ray = surface_point::offset_by_epsilon(surface, path / distance, EPSILON);
    ray.extent.max = distance;
    ray
}

/// By the error bound of the point.
pub(crate) fn by_bound(surface: &SurfacePoint, light: Vec3) -> Ray {
    surface.spawn_to(light)
}

/// Where the scene stands and how large it is.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    /// All lengths are multiplied by it,
    pub(crate) scale: f32,
    /// and then everything is moved by it.
    pub(crate) offset: Vec3,
}

/// At its own size, around the origin.
pub(crate) const HERE: Place = Place { scale: 1.0, offset: Vec3::ZERO };

/// A ball of radius 1 on a sloping floor, and its light.
///
/// Nothing is parallel to an axis: on a level floor, one coordinate of every point is exact.
pub(crate) struct Ball {
    pub(crate) scene: Scene,
    light: Vec3,
}

impl Ball {
    pub(crate) fn new(Place { scale, offset }: Place) -> Self {
        let turn = Mat3::from_cols(
            vec3(0.944_911_2, 0.289_474_7, 0.152_901_3),
            vec3(-0.299_437_1, 0.952_920_5, 0.046_382_5),
            vec3(-0.132_276_2, -0.089_613_2, 0.987_154_5),
        );
        let place = |x: f32, y: f32, z: f32| scale * (turn * vec3(x, y, z)) + offset;
        let camera = Camera {
            eye: place(0.0, 2.0, 6.0),
            forward: turn * vec3(0.0, -0.28, -0.96),
            right: turn * Vec3::X,
            up: turn * vec3(0.0, 0.96, -0.28),
            half_height: 0.35,
        };
        let floor = [(-9.0, 5.0), (9.0, 5.0), (9.0, -13.0), (-9.0, -13.0)];
        let scene = Scene::load(&scene_file("furnace")).unwrap_or_else(|error| panic!("{error}"));
        let scene = Scene {
            camera,
            geometry: Geometry {
                vertices: floor.map(|(x, z)| place(x, 0.0, z)).into(),
                triangles: vec![[0, 1, 2], [0, 2, 3]],
                spheres: vec![Sphere { center: place(0.3, 1.0, 0.1), radius: scale }],
            },
            attributes: Attributes { materials: vec![0; 3], ..Attributes::default() },
            ..scene
        };
        Self { scene, light: place(-5.0, 6.0, 4.0) }
    }

    /// Where the rays through the middle of each pixel meet the scene.
    pub(crate) fn points(&self, size: [u32; 2]) -> Vec<SurfacePoint> {
        let geometry = LinearSearch::new(&self.scene.geometry, &Unwatched);
        let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y]));
        let rays = pixels.map(|pixel| FilmPoint::in_pixel(pixel, [0.5; 2], size));
        let rays = rays.map(|point| self.scene.camera.ray(point));
        rays.filter_map(|ray| Some(self.scene.surface(&ray, &geometry.intersect(&ray)?))).collect()
    }

    /// The scene lit by its light, with shadow rays by `leave`.
    pub(crate) fn draw(&self, size: [u32; 2], samples: u32, leave: Leave) -> Picture {
        let Self { scene, light } = self;
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        let settings = FilmSettings { size, samples, seed: 0, threads: None };
        let image = expose(&settings, |point, _| {
            let ray = scene.camera.ray(point);
            let Some(hit) = geometry.intersect(&ray) else { return Rgb::new(0.05, 0.06, 0.08) };
            let surface = scene.surface(&ray, &hit);
            let cos_theta = surface.facing_normal().dot((*light - surface.position).normalize());
            let lit = cos_theta > 0.0 && !geometry.occluded(&leave(&surface, *light));
            Rgb::splat(0.06 + if lit { 0.6 * cos_theta } else { 0.0 })
        });
        Picture::from(&image)
    }
}
