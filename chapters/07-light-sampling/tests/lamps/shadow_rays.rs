//! Shadow rays end before the lamp and after everything else, at every scale and place.

use glam::{Vec3, vec3};
use light_sampling::Lights;
use ray_casting::{Intersect, LinearSearch, Ray, Scene, SurfacePoint};
use statistics::seed;
use workbench::{Sampler, Unwatched};

use crate::scenes::{LAMP, MATTE, add_sphere, add_triangle, empty, in_ball};

/// Sizes of scenes, and how far from the origin they lie; the product of all combinations.
const SCALES: [f32; 5] = [1e-6, 1e-3, 1.0, 1e3, 1e6];
const OFFSETS: [f32; 4] = [0.0, 1.0, 1e3, 1e5];

/// How many scenes of each combination, and shadow rays in each.
const SCENES: u32 = 60;
const RAYS: u32 = 100;

/// What is put into a scene beside the floor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Lamp {
    Quad,
    Sphere,
}

/// A random scene: a floor, a lamp, and perhaps a sheet just before the lamp or just before the
/// floor.
struct Setup {
    scene: Scene,
    /// The way from the origin to its middle.
    place: Vec3,
    scale: f32,
}

impl Setup {
    fn new(lamp: Lamp, scale: f32, offset: f32, sampler: &mut Sampler) -> Self {
        let place = offset * in_ball(sampler).normalize();
        let mut setup = Self { scene: empty(), place, scale };
        let floor = in_ball(sampler).normalize();
        setup.add_square(Vec3::ZERO, floor, 1.0, MATTE);
        // Not below the floor, and not in it.
        let away = (floor + 0.9 * in_ball(sampler)) * (0.5 + 2.0 * sampler.next_1d());
        match lamp {
            Lamp::Quad => {
                // Every other one is seen nearly along its edge.
                let toward = -away.normalize();
                let aslant = 10.0_f32.powf(-3.0 * sampler.next_1d()) * toward;
                let edge = toward.any_orthonormal_vector() + aslant;
                let facing = match sampler.next_1d() < 0.5 {
                    true => (toward + 0.9 * in_ball(sampler)).normalize(),
                    false => edge.normalize(),
                };
                setup.add_square(away, facing, 0.2 + 0.5 * sampler.next_1d(), LAMP);
            }
            Lamp::Sphere => {
                let radius = 0.05 + 0.3 * sampler.next_1d();
                let center = setup.at(away);
                add_sphere(&mut setup.scene, center, scale * radius, LAMP);
            }
        }
        setup
    }

    fn at(&self, local: Vec3) -> Vec3 {
        self.place + self.scale * local
    }

    fn add_square(&mut self, middle: Vec3, normal: Vec3, size: f32, material: u32) {
        let x = size * normal.any_orthonormal_vector();
        let y = normal.cross(x);
        let corners = [-x - y, x - y, x + y, y - x].map(|corner| self.at(middle + corner));
        let [a, b, c, d] = corners;
        add_triangle(&mut self.scene, [a, b, c], material);
        add_triangle(&mut self.scene, [a, c, d], material);
    }

    /// Whether the scene is large enough for its place that floats tell the floor from the lamp.
    fn is_resolved(&self) -> bool {
        self.place.length() * f32::EPSILON < 1e-3 * self.scale
    }

    /// The floor, seen from its front, at a random point.
    fn surface(&self, sampler: &mut Sampler) -> Option<SurfacePoint> {
        let geometry = LinearSearch::new(&self.scene.geometry, &Unwatched);
        let [a, b, c] = self.scene.geometry.corners(0);
        let [u, v] = sampler.next_2d();
        let target = a + 0.5 * u * (b - a) + 0.5 * v * (c - a);
        let normal = (b - a).cross(c - a).normalize();
        let origin = target + 0.01 * self.scale * normal;
        let ray = Ray::new(origin, (target - origin).normalize());
        let hit = geometry.intersect(&ray)?;
        (hit.primitive < 2).then(|| self.scene.surface(&ray, &hit))
    }
}

/// Runs through all combinations; the number of rays that were cast, and of those that failed.
fn stress(
    lamp: Lamp,
    mut check: impl FnMut(&Setup, &SurfacePoint, &light_sampling::LightSample) -> Option<bool>,
) -> [u64; 2] {
    let mut sampler = Sampler::new(seed(0x5407), 0, lamp as u64);
    let [mut cast, mut failed] = [0, 0];
    for (scale, offset) in SCALES.iter().flat_map(|&s| OFFSETS.map(|o| (s, o))) {
        for _ in 0..SCENES {
            let setup = Setup::new(lamp, scale, offset, &mut sampler);
            if !setup.is_resolved() {
                continue;
            }
            let lights = Lights::new(&setup.scene);
            for _ in 0..RAYS {
                let Some(surface) = setup.surface(&mut sampler) else { break };
                let Some(light) = lights.sample(&surface, &mut sampler) else { continue };
                if surface.geometric_normal.dot(light.wi) <= 0.0 {
                    continue;
                }
                let Some(right) = check(&setup, &surface, &light) else { continue };
                cast += 1;
                failed += u64::from(!right);
            }
        }
    }
    [cast, failed]
}

#[test]
fn a_lamp_never_stands_in_its_own_light() {
    for lamp in [Lamp::Quad, Lamp::Sphere] {
        let [cast, failed] = stress(lamp, |setup, surface, light| {
            let geometry = LinearSearch::new(&setup.scene.geometry, &Unwatched);
            Some(!geometry.occluded(&light.shadow_ray(surface)))
        });
        assert!(cast > 50_000, "{lamp:?}: only {cast} rays were cast");
        assert_eq!(failed, 0, "{lamp:?}: of {cast} shadow rays so many met the lamp or the floor");
    }
}

/// A sheet across the shadow ray, `gap` before its end, or after its start.
fn blocked(gap_at_end: bool, lamp: Lamp) -> [u64; 2] {
    stress(lamp, |_, surface, light| {
        let end = light.end.expect("a lamp has a place").position;
        let path = end - surface.position;
        let distance = path.length();
        // As near as 64 units in the last place of the largest number that is involved.
        let size = surface.position.abs().max(end.abs()).max_element() + distance;
        let gap = 64.0 * f32::EPSILON * size;
        if gap > 0.1 * distance {
            return None;
        }
        let middle =
            if gap_at_end { end - gap * light.wi } else { surface.position + gap * light.wi };
        let x = 0.01 * distance * light.wi.any_orthonormal_vector();
        let y = 0.01 * distance * light.wi.cross(x).normalize();
        let mut sheet = empty();
        let corners = [-x - y, x - y + 0.3 * x, y + 0.1 * x].map(|corner| middle + corner);
        add_triangle(&mut sheet, corners, MATTE);
        let geometry = LinearSearch::new(&sheet.geometry, &Unwatched);
        Some(geometry.occluded(&light.shadow_ray(surface)))
    })
}

#[test]
fn what_stands_just_before_the_lamp_is_in_its_light() {
    for lamp in [Lamp::Quad, Lamp::Sphere] {
        let [cast, failed] = blocked(true, lamp);
        assert!(cast > 30_000, "{lamp:?}: only {cast} rays were cast");
        assert_eq!(failed, 0, "{lamp:?}: of {cast} shadow rays so many missed the sheet");
    }
}

#[test]
fn what_stands_just_before_the_surface_shades_it() {
    for lamp in [Lamp::Quad, Lamp::Sphere] {
        let [cast, failed] = blocked(false, lamp);
        assert!(cast > 30_000, "{lamp:?}: only {cast} rays were cast");
        assert_eq!(failed, 0, "{lamp:?}: of {cast} shadow rays so many missed the sheet");
    }
}

/// A ball of triangles as a lamp: where two of them meet, the neighbour is not in the way.
#[test]
fn the_parts_of_a_mesh_do_not_shade_each_other() {
    let mesh = generator::blob(24);
    let mut sampler = Sampler::new(seed(0x5507), 0, 0);
    let [mut cast, mut shaded] = [0, 0];
    // Farther away, rounded vertices make dents: two triangles in a plane are a shallow valley.
    for offset in [0.0, 1.0] {
        let mut scene = empty();
        let place = offset * vec3(0.6, 0.48, -0.64);
        // A plain ball: on a bumpy one, parts do shade each other.
        let vertices: Vec<Vec3> =
            (mesh.positions.iter()).map(|p| place + Vec3::from_array(*p).normalize()).collect();
        for triangle in &mesh.triangles {
            add_triangle(&mut scene, triangle.map(|i| vertices[i as usize]), LAMP);
        }
        let lights = Lights::new(&scene);
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        for _ in 0..10_000 {
            let away = in_ball(&mut sampler).normalize();
            let surface = crate::scenes::viewer(place + 3.0 * away, -away);
            let Some(light) = lights.sample(&surface, &mut sampler) else { continue };
            cast += 1;
            shaded += u32::from(geometry.occluded(&light.shadow_ray(&surface)));
        }
    }
    assert!(cast > 5000, "only {cast} rays were cast");
    assert_eq!(shaded, 0, "of {cast} shadow rays to a convex lamp");
}

/// The other way round: from a lamp's own surface nothing of itself is asked.
#[test]
fn a_flat_lamp_gets_no_light_from_itself() {
    let mut scene = empty();
    add_triangle(&mut scene, [Vec3::ZERO, Vec3::X, Vec3::Y], LAMP);
    let lights = Lights::new(&scene);
    let mut sampler = Sampler::new(seed(0x5607), 0, 0);
    let surface = crate::scenes::viewer(vec3(0.25, 0.25, 0.0), Vec3::Z);
    for _ in 0..10_000 {
        let sample = lights.sample(&surface, &mut sampler);
        assert!(sample.is_none(), "{sample:?} from the lamp itself");
    }
}
