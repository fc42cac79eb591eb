//! What a search is asked: every ray of a small render, recorded once and asked again of each tree.

use std::sync::Mutex;

use blinn_phong::Picture;
use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb, Shape};
use generator::Mesh;
use glam::{Vec3, vec3};
use mirror_refraction::{Limits, RayTracer};
use ray_casting::{
    Attributes, Camera, Geometry, Hit, Intersect, LinearSearch, PointLight, Ray, Scene, Sphere,
};
use workbench::{CameraRecord, Counter, FilmSettings, Recorder, Sampler, Unwatched, expose};

use crate::figures::scene_file;

/// How many reflections and refractions the recursion follows: the default of the stage.
const DEPTH: u32 = 8;

/// A ray, and whether any hit will do.
#[derive(Clone, Copy)]
pub(crate) struct Question {
    pub(crate) ray: Ray,
    any: bool,
}

/// Primitives, and what a render asks about them.
pub(crate) struct Workload {
    pub(crate) name: &'static str,
    pub(crate) geometry: Geometry,
    pub(crate) questions: Vec<Question>,
}

impl Workload {
    /// The rays of the recursion of chapter 3, for a picture `width` pixels wide with one sample a
    /// pixel. Any search gives the same hits, hence the same rays.
    pub(crate) fn record(name: &'static str, scene: Scene, width: u32) -> Self {
        let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
        let questions = asked(&scene, &tree, width);
        Self { name, geometry: scene.geometry, questions }
    }

    /// Asks everything of `search` and adds up what makes the answers differ from one another.
    pub(crate) fn ask(&self, search: &(impl Intersect + ?Sized)) -> u64 {
        let answer = |question: &Question| {
            if question.any {
                u64::from(search.occluded(&question.ray))
            } else {
                search.intersect(&question.ray).map_or(0, |hit| u64::from(hit.t.to_bits()))
            }
        };
        self.questions.iter().map(answer).sum()
    }

    /// What a ray of [`Workload::record`] costs with boxes; for meshes that are built over only
    /// once.
    pub(crate) fn box_cost(scene: &Scene, width: u32) -> Cost {
        let recorder = Recorder::new();
        let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &recorder);
        let questions = asked(scene, &tree, width);
        Cost { shape: tree.shape(), ..Cost::each(&recorder, questions.len()) }
    }

    /// What a ray costs with a tree.
    pub(crate) fn cost(&self, volume: &Volume, builder: Builder) -> Cost {
        let recorder = Recorder::new();
        let (tree, shape) = (volume.build)(&self.geometry, builder, &recorder);
        let answers = self.ask(&*tree);
        Cost { shape, answers, ..Cost::each(&recorder, self.questions.len()) }
    }

    /// What a ray costs if it looks at every primitive.
    pub(crate) fn linear_cost(&self) -> Cost {
        let recorder = Recorder::new();
        let answers = self.ask(&LinearSearch::new(&self.geometry, &recorder));
        Cost { answers, ..Cost::each(&recorder, self.questions.len()) }
    }
}

/// The chapter 3 picture of a scene, whatever finds the hits.
pub(super) fn trace(
    scene: &Scene,
    search: &impl Intersect,
    settings: &FilmSettings,
) -> workbench::Image {
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let limits = Limits::new(Some(DEPTH), Limits::CUTOFF);
    let tracer = RayTracer::new(scene, &pictures, search, &Unwatched, limits);
    expose(settings, |point, _| tracer.incident_radiance(scene.camera.ray(point)))
}

/// All that a render of one sample a pixel asks of `search`.
fn asked(scene: &Scene, search: &impl Intersect, width: u32) -> Vec<Question> {
    let diary = Diary { search, questions: Mutex::default() };
    let [w, h] = scene.exposure.size;
    // One thread keeps the rays in the order in which a render asks.
    let size = [width, (width * h).div_ceil(w)];
    let settings = FilmSettings { size, samples: 1, seed: 0, threads: Some(1) };
    trace(scene, &diary, &settings);
    diary.questions.into_inner().expect("no thread has panicked")
}

/// Writes down what is asked of a search.
struct Diary<'a, G> {
    search: &'a G,
    questions: Mutex<Vec<Question>>,
}

impl<G> Diary<'_, G> {
    fn write(&self, ray: Ray, any: bool) {
        self.questions.lock().expect("no thread has panicked").push(Question { ray, any });
    }
}

impl<G: Intersect> Intersect for Diary<'_, G> {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.write(*ray, false);
        self.search.intersect(ray)
    }

    fn occluded(&self, ray: &Ray) -> bool {
        self.write(*ray, true);
        self.search.occluded(ray)
    }
}

/// Tests a ray, and the tree that they are made in.
pub(crate) struct Cost {
    pub(crate) volume: f64,
    pub(crate) primitive: f64,
    pub(crate) shape: Shape,
    /// Equal for all searches that find the same hits.
    pub(crate) answers: u64,
}

impl Cost {
    fn each(recorder: &Recorder, questions: usize) -> Self {
        let each = |counter| recorder.get(counter) as f64 / questions as f64;
        Self {
            volume: each(Counter::VolumeTests),
            primitive: each(Counter::PrimitiveTests),
            shape: Shape::default(),
            answers: 0,
        }
    }
}

/// A kind of volume and how to build a tree of it.
pub(crate) struct Volume {
    pub(crate) name: &'static str,
    /// How many slabs a test looks at, at most.
    pub(crate) slabs: u32,
    pub(crate) build: for<'a> fn(&'a Geometry, Builder, &'a Recorder) -> Built<'a>,
}

/// A tree of some kind of volume, and how large it is.
pub(crate) type Built<'a> = (Box<dyn Intersect + 'a>, Shape);

/// Axis-aligned boxes.
pub(crate) const AABB: Volume = volume::<Aabb>("AABB", 3);

/// All the volumes of the chapter.
pub(crate) const VOLUMES: [Volume; 6] = [
    AABB,
    volume::<Obb>("OBB", 3),
    volume::<KDop<3>>("6-DOP", 3),
    volume::<KDop<7>>("14-DOP", 7),
    volume::<KDop<9>>("18-DOP", 9),
    volume::<KDop<13>>("26-DOP", 13),
];

/// A kind of volume by its type.
pub(super) const fn volume<V: BoundingVolume>(name: &'static str, slabs: u32) -> Volume {
    Volume { name, slabs, build: build::<V> }
}

fn build<'a, V: BoundingVolume>(
    geometry: &'a Geometry,
    builder: Builder,
    recorder: &'a Recorder,
) -> Built<'a> {
    let tree = BvTree::<V, Recorder>::build(geometry, builder, recorder);
    let shape = tree.shape();
    (Box::new(tree), shape)
}

/// One of the course's scenes.
pub(crate) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The scenes on which volumes and builders are compared.
pub(crate) fn comparison(width: u32) -> Vec<Workload> {
    vec![
        Workload::record("`whitted-teapot`", scene("whitted-teapot"), width),
        Workload::record("`sphereflake`", scene("sphereflake"), width),
        Workload::record("terrain", terrain(71), width),
        Workload::record("slanted rods", rods(), width),
    ]
}

/// The bumpy ball with 2n(n − 1) triangles, in the middle of the picture.
pub(crate) fn blob(n: u32) -> Scene {
    let camera = CameraRecord {
        eye: [0.0, 1.2, 4.2],
        target: [0.0, 0.0, 0.0],
        up: [0.0, 1.0, 0.0],
        fov: 32.0,
        size: [300, 300],
    };
    made(from_mesh(generator::blob(n)), &camera, vec3(4.0, 5.0, 3.0))
}

/// The fractal landscape with 2 side² triangles, in low light.
pub(crate) fn terrain(side: u32) -> Scene {
    let camera = CameraRecord {
        eye: [5.0, 42.0, 85.0],
        target: [0.0, 4.0, 5.0],
        up: [0.0, 1.0, 0.0],
        fov: 45.0,
        size: [300, 200],
    };
    made(from_mesh(generator::terrain(side, 1)), &camera, vec3(120.0, 55.0, -20.0))
}

/// Thin prisms in all directions: what a box along the axes encloses worst.
pub(crate) fn rods() -> Scene {
    let camera = CameraRecord {
        eye: [0.0, 0.0, 4.0],
        target: [0.0, 0.0, 0.0],
        up: [0.0, 1.0, 0.0],
        fov: 36.0,
        size: [300, 200],
    };
    let mut geometry = Geometry::default();
    (0..300).for_each(|i| add_rod(&mut geometry, &mut Sampler::new(5, i, 0)));
    made(geometry, &camera, vec3(4.0, 6.0, 8.0))
}

/// Four thousand balls that fill a cube: behind what a ray hits there is always more.
pub(super) fn balls() -> Scene {
    let camera = CameraRecord {
        eye: [1.5, 1.2, 4.0],
        target: [0.0, 0.0, 0.0],
        up: [0.0, 1.0, 0.0],
        fov: 36.0,
        size: [300, 200],
    };
    let ball = |i| {
        let mut sampler = Sampler::new(10, i, 0);
        let [x, y] = sampler.next_2d();
        Sphere { center: 2.0 * vec3(x, y, sampler.next_1d()) - 1.0, radius: 0.06 }
    };
    let geometry = Geometry { spheres: (0..4000).map(ball).collect(), ..Geometry::default() };
    made(geometry, &camera, vec3(4.0, 6.0, 8.0))
}

/// A rod of random place and direction: six long sides, two slim triangles each.
fn add_rod(geometry: &mut Geometry, sampler: &mut Sampler) {
    let mut cube = || {
        let [x, y] = sampler.next_2d();
        2.0 * vec3(x, y, sampler.next_1d()) - 1.0
    };
    let center = cube() * vec3(1.2, 0.8, 0.8);
    let axis = cube().normalize();
    let across = axis.cross(cube()).normalize();
    let up = axis.cross(across);
    let first = geometry.vertices.len() as u32;
    let root = 0.75_f32.sqrt();
    let corners = [(1.0, 0.0), (0.5, root), (-0.5, root), (-1.0, 0.0), (-0.5, -root), (0.5, -root)];
    for (x, y) in corners {
        let side = 0.008 * (x * across + y * up);
        geometry.vertices.extend([center - 0.45 * axis + side, center + 0.45 * axis + side]);
    }
    for i in 0..6 {
        let [a, b] = [first + 2 * i, first + 2 * ((i + 1) % 6)];
        geometry.triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
    }
}

fn from_mesh(mesh: Mesh) -> Geometry {
    Geometry {
        vertices: mesh.positions.into_iter().map(Vec3::from_array).collect(),
        triangles: mesh.triangles,
        ..Geometry::default()
    }
}

/// A scene of one matte material, the porcelain of the teapot, under one light.
fn made(geometry: Geometry, camera: &CameraRecord, light: Vec3) -> Scene {
    let mut scene = scene("teapot");
    let porcelain = scene.materials.iter().position(|material| material.name == "porcelain");
    let material = porcelain.expect("the teapot is of porcelain") as u32;
    let intensity = Vec3::splat(1.6 * light.length_squared());
    scene.attributes = Attributes {
        materials: vec![material; geometry.primitives() as usize],
        ..Attributes::default()
    };
    scene.camera = Camera::from(camera);
    scene.exposure.size = camera.size;
    scene.geometry = geometry;
    scene.lights = vec![PointLight::new(light, intensity)];
    scene
}

/// Builds a tree and asks everything of it, for a stopwatch: nothing is counted, and the kind of
/// volume is known to the compiler.
pub(crate) fn stopwatch<'a, V: BoundingVolume>(workload: &'a Workload) -> impl Fn() -> u64 + 'a {
    let tree = BvTree::<V, _>::build(&workload.geometry, Builder::Sah, &Unwatched);
    move || workload.ask(&tree)
}
