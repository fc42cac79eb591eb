//! Estimators against closed forms, and that they never bring what is no number: E1 to E16.

use std::path::Path;
use std::sync::LazyLock;

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use light_sampling::{Choice, Estimator, Heuristic, LightTracer, Measure, Settings};
use path_tracing::{Ending, Roulette};
use ray_casting::Scene;
use rendering_equation::Anything;
use workbench::{FilmPoint, Sampler, Unwatched};

use crate::random::Random;
use crate::trial::Trial;

crate::catalogue! {
    E1 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        a_closed_furnace_shines_with_one_over_one_minus_albedo;
    E2 elsewhere "tests/acceptance/tests/stages/closed_forms.rs"
        a_point_light_at_the_centre_of_a_sphere_makes_it_evenly_bright;
    E3 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        an_integrating_sphere_is_evenly_bright;
    E4 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        concentric_spheres_have_the_radiosities_of_a_2_by_2_system;
    E5 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        a_sphere_light_above_the_horizon_obeys_the_inverse_square;
    E6 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        a_sphere_light_on_the_horizon_has_its_closed_form;
    E7 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        flat_lamps_have_the_form_factors_of_the_catalogue;
    E8 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        a_black_sphere_takes_a_quarter_of_the_sky;
    E9 elsewhere "chapters/06-path-tracing/tests/paths/furnace.rs"
        under_an_even_sky_every_path_finds_the_same;
    E10 elsewhere "chapters/06-path-tracing/tests/paths/roulette.rs"
        the_number_of_vertices_of_a_path_is_geometric;
    E11 elsewhere "chapters/07-light-sampling/src/heuristic.rs"
        the_weights_of_both_strategies_add_up_to_one;
    E12 elsewhere "chapters/06-path-tracing/tests/paths/convergence.rs"
        the_error_falls_as_one_over_the_root_of_the_number_of_paths;
    E13 random/32 no_path_brings_a_value_that_is_not_finite;
    E14 elsewhere "chapters/06-path-tracing/tests/paths/furnace.rs"
        a_lamp_that_fills_the_view_is_as_bright_from_anywhere;
    E15 elsewhere "chapters/05-rendering-equation/tests/branching/counts.rs"
        the_rays_of_a_closed_room_are_a_geometric_sum;
    E16 elsewhere "chapters/06-path-tracing/tests/paths/agreement.rs"
        renders_with_different_seeds_are_independent;
}

/// Everything that can go wrong: glass in glass, touching and flat glass, sphere lamps, many lamps,
/// highlights beside them, textures, a sky.
const SCENES: [&str; 8] = [
    "cornell-box",
    "cornell-spheres",
    "many-lights",
    "veach-plates",
    "nested-glass",
    "touching-glass",
    "whitted",
    "furnace",
];

struct Loaded {
    name: &'static str,
    scene: Scene,
    pictures: Vec<Picture>,
}

static LOADED: LazyLock<Vec<Loaded>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    let load = |name| {
        let scene = Scene::load(&folder.join(name).with_extension("toml"));
        let scene = scene.unwrap_or_else(|error| panic!("{error}"));
        let pictures = Picture::load_all(&scene).unwrap_or_else(|error| panic!("{error}"));
        Loaded { name, scene, pictures }
    };
    SCENES.map(load).into()
});

/// Paths in the course's scenes by every estimator, heuristic, choice and measure: no sample is NaN,
/// infinite or negative.
fn no_path_brings_a_value_that_is_not_finite(trial: &mut Trial) {
    let loaded = &LOADED[trial.random.below(SCENES.len() as u64) as usize];
    let settings = some_settings(&mut trial.random);
    let scene = &loaded.scene;
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: LightTracer<'_, _, _, Anything> =
        LightTracer::new(scene, &loaded.pictures, &tree, &Unwatched, settings);
    for _ in 0..trial.rays {
        let key = trial.random.bits();
        let mut sampler = Sampler::new(key, 0, 0);
        let size = scene.exposure.size;
        let pixel = size.map(|n| trial.random.below(n.into()) as u32);
        let point = FilmPoint::in_pixel(pixel, sampler.next_2d(), size);
        let radiance = tracer.incident_radiance(scene.camera.ray(point), &mut sampler);
        let holds = radiance.is_finite() && radiance.min_element() >= 0.0;
        trial.require(holds, || {
            format!("{radiance}: {} at {pixel:?}, seed {key}, {settings:?}", loaded.name)
        });
    }
}

fn some_settings(random: &mut Random) -> Settings {
    let roulette = [Roulette::Throughput, Roulette::Off][random.below(2) as usize];
    Settings {
        estimator: [Estimator::Light, Estimator::Mis, Estimator::Scatter][random.below(3) as usize],
        heuristic: [Heuristic::Balance, Heuristic::Power][random.below(2) as usize],
        choice: [Choice::Nearby, Choice::Power, Choice::Uniform][random.below(3) as usize],
        measure: [Measure::Area, Measure::SolidAngle][random.below(2) as usize],
        ending: Ending { depth: 64, roulette },
    }
}
