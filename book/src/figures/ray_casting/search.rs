//! What a linear search costs, counted.

use ray_casting::{LinearSearch, RayCaster, Show};
use workbench::{Counter, FilmSettings, Recorder, expose};

use super::stage::scene;
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::table::{Table, count};

/// Exact counts of one small render.
struct Cost {
    primitives: u64,
    camera_rays: u64,
    shadow_rays: u64,
    tests: u64,
    /// Camera rays of the scene's own size at 16 samples a pixel.
    full_rays: u64,
}

impl Cost {
    /// Renders the scene with 60 pixels a row or column and one sample a pixel.
    fn of(name: &str) -> Self {
        let scene = scene(name);
        let recorder = Recorder::new();
        let geometry = LinearSearch::new(&scene.geometry, &recorder);
        let caster = RayCaster::new(&scene, &geometry, &recorder, Show::Facing);
        let [width, height] = scene.exposure.size.map(u64::from);
        let size = [60, (60 * height / width) as u32];
        let settings = FilmSettings { size, samples: 1, seed: 0, threads: None };
        expose(&settings, |point, _| caster.incident_radiance(scene.camera.ray(point)));
        Self {
            primitives: u64::from(scene.geometry.primitives()),
            camera_rays: u64::from(size[0]) * u64::from(size[1]),
            shadow_rays: recorder.get(Counter::ShadowRays),
            tests: recorder.get(Counter::PrimitiveTests),
            full_rays: 16 * width * height,
        }
    }

    fn tests_per_camera_ray(&self) -> f64 {
        self.tests as f64 / self.camera_rays as f64
    }
}

/// Tests per camera ray on four scenes.
pub(super) fn tests() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "primitives",
        "camera rays",
        "shadow rays",
        "primitive tests",
        "tests per camera ray",
    ]);
    for name in ["whitted", "cornell-box", "sphereflake", "teapot"] {
        let cost = Cost::of(name);
        table.row([
            format!("`{name}`"),
            count(cost.primitives),
            count(cost.camera_rays),
            count(cost.shadow_rays),
            count(cost.tests),
            count(cost.tests_per_camera_ray().round() as u64),
        ]);
    }
    table.into()
}

/// What the teapot's own picture would take.
pub(super) fn numbers() -> Drawing {
    let cost = Cost::of("teapot");
    let mut numbers = Numbers::new();
    numbers.add("primitives", count(cost.primitives));
    numbers.add("full-rays", format!("{:.1}", cost.full_rays as f64 / 1e6));
    let tests = cost.full_rays as f64 * cost.tests_per_camera_ray();
    numbers.add("full-tests", format!("{:.0}", tests / 1e9));
    numbers.into()
}
