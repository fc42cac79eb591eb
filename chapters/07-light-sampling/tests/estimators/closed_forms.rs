//! Scenes whose light can be computed with a pencil (accuracy.md E1, E3 to E8).

use std::f64::consts::PI;

use glam::{Vec3, vec3};
use light_sampling::{Choice, Estimator, Measure, Settings};
use ray_casting::{Ray, Rgb, Scene};
use statistics::assert_mean;

use crate::scenes::{
    ESTIMATORS, add_hollow_ball, add_quad, add_room, add_sphere, add_triangle, at_receiver, dark,
    endless, lamp, limited, matte, point_light, radiance, receiver,
};

/// The bias that tests of this file must be able to see. Chance alone is at chapter 6's mercy: it
/// has to show no more than that it finds the same.
fn visible(estimator: Estimator) -> f64 {
    if estimator == Estimator::Scatter { 0.07 } else { 0.03 }
}

/// Asserts what arrives against a ray.
fn assert_radiance(name: &str, scene: &Scene, settings: Settings, ray: Ray, n: u32, expected: f64) {
    let name = format!("{name}, {:?}", settings.estimator);
    let bias = assert_mean(&name, &radiance(scene, settings, ray, n), expected);
    assert!(bias <= visible(settings.estimator), "{name}: only a bias of {bias} would be seen");
}

/// Asserts the irradiance E of the receiver, with all estimators. Its albedo is 1: L = E/π.
///
/// By chance, E/π of the directions find the lamp. As many samples as show 7 % of that are taken.
fn assert_irradiance(name: &str, scene: &Scene, n: u32, expected: f64) {
    let by_chance = 40_000 + (12_000.0 * PI / expected) as u32;
    for (estimator, n) in ESTIMATORS.into_iter().zip([by_chance, n, n]) {
        assert_radiance(name, scene, limited(estimator, 1), at_receiver(), n, expected / PI);
    }
}

/// E1: inside a closed body that shines with 1 and reflects ρ, the radiance is 1/(1 − ρ), whatever
/// its shape. A ball of 128 triangles.
#[test]
fn a_closed_furnace_shines_with_one_over_one_minus_albedo() {
    let ray = Ray::new(vec3(0.1, -0.2, 0.15), vec3(0.3, 0.4, -0.8).normalize());
    for (albedo, n) in [(0.5, 30_000), (0.8, 30_000), (0.95, 6_000)] {
        let mut scene = dark([lamp(1.0, albedo)]);
        add_hollow_ball(&mut scene, 2, |_| 0);
        for estimator in ESTIMATORS {
            let expected = 1.0 / (1.0 - f64::from(albedo));
            let name = format!("E1, albedo {albedo}");
            assert_radiance(&name, &scene, endless(estimator), ray, n, expected);
        }
    }
}

/// E1 in a room: near its edges, points of equal area would give the pure light estimator an
/// infinite variance. Directions of equal solid angle do not.
#[test]
fn a_room_is_a_furnace_too() {
    let ray = Ray::new(vec3(0.1, -0.2, 0.15), vec3(0.3, 0.4, -0.8).normalize());
    let mut scene = dark([lamp(1.0, 0.5)]);
    add_room(&mut scene, 0);
    for estimator in ESTIMATORS {
        assert_radiance("E1, room", &scene, endless(estimator), ray, 30_000, 2.0);
    }
}

/// E1 with a limit: Σ ρⁱ for i = 0 … D.
#[test]
fn a_depth_limit_keeps_a_partial_sum_of_the_furnace() {
    let ray = Ray::new(vec3(0.1, -0.2, 0.15), vec3(0.3, 0.4, -0.8).normalize());
    let mut scene = dark([lamp(1.0, 0.8)]);
    add_hollow_ball(&mut scene, 2, |_| 0);
    for depth in [0, 1, 2, 5] {
        let expected = (0..=depth).map(|i| f64::powi(f64::from(0.8_f32), i)).sum();
        for estimator in ESTIMATORS {
            let settings = limited(estimator, depth as u32);
            assert_radiance(&format!("D = {depth}"), &scene, settings, ray, 20_000, expected);
        }
    }
}

/// E3: two octants of an integrating sphere shine; anywhere, ρ f Lₑ / (1 − ρ) is reflected.
///
/// The sphere is made of triangles. In the middle of an octant is the middle of one of them, where
/// its normal points to the centre, as the sphere's does; elsewhere it may be tilted by a percent.
#[test]
fn an_integrating_sphere_is_evenly_bright() {
    let mut scene = dark([matte(0.8), lamp(1.0, 0.8)]);
    add_hollow_ball(&mut scene, 5, |octant| u32::from(octant == 0 || octant == 6));
    let [wall, bright] = [vec3(-1.0, 1.0, -1.0), vec3(1.0, 1.0, 1.0)]
        .map(|direction| Ray::new(Vec3::ZERO, direction.normalize()));
    for estimator in ESTIMATORS {
        let n = if estimator == Estimator::Scatter { 20_000 } else { 10_000 };
        let settings = endless(estimator);
        assert_radiance("E3, wall", &scene, settings, wall, n, 1.0);
        assert_radiance("E3, lamp", &scene, settings, bright, n, 2.0);
        let k_bounces = 0.8 * 0.25 * (1.0 + 0.8 + 0.64);
        let settings = limited(estimator, 3);
        assert_radiance("E3, 3 bounces", &scene, settings, wall, n, k_bounces);
    }
}

/// E4: a shining sphere in a reflecting one. B₁ = 4/3, B₂ = 2/3.
#[test]
fn concentric_spheres_have_the_radiosities_of_a_2_by_2_system() {
    let mut scene = dark([lamp(1.0, 0.5), matte(0.8)]);
    add_sphere(&mut scene, Vec3::ZERO, 1.0, 0);
    add_sphere(&mut scene, Vec3::ZERO, 2.0, 1);
    let from = vec3(0.2, 1.4, 0.3);
    let inner = Ray::new(from, (vec3(0.1, 0.2, 0.3) - from).normalize());
    let outer = Ray::new(from, vec3(0.9, 0.3, -0.2).normalize());
    for estimator in ESTIMATORS {
        let settings = endless(estimator);
        assert_radiance("E4, inner", &scene, settings, inner, 40_000, 4.0 / 3.0);
        assert_radiance("E4, outer", &scene, settings, outer, 60_000, 2.0 / 3.0);
    }
}

/// A sphere of radius 1 and radiance 1, at distance `h` and at the angle `beta` from the normal.
fn sphere_light(beta: f64, h: f64) -> Scene {
    let mut scene = receiver([lamp(1.0, 0.0)]);
    let (sin, cos) = libm::sincos(beta);
    let center = vec3((h * sin) as f32, (h * cos) as f32, 0.0);
    add_sphere(&mut scene, center, 1.0, 1);
    scene
}

/// E5, and by all estimators I5: E = πL (r/d)² cos θ, as long as the whole sphere is above the horizon.
#[test]
fn a_sphere_light_above_the_horizon_obeys_the_inverse_square() {
    let facing = PI / 9.0;
    assert!((facing - 0.349_065_9).abs() < 1e-7, "accuracy.md's value for {facing}");
    let n = 60_000;
    assert_irradiance("E5, θ = 0", &sphere_light(0.0, 3.0), n, facing);
    assert_irradiance("E5, θ = 60°", &sphere_light(PI / 3.0, 3.0), n, 0.5 * facing);
    // Nearly touching: the cone is nearly the hemisphere.
    let near = sphere_light(0.0, f64::from(1.01_f32));
    assert_irradiance("E5, touching", &near, 150_000, PI / (1.01 * 1.01));
}

/// E6: cut by the horizon, with x = √(h² − 1), y = −x cot β:
/// E/L = (cos β acos y − x sin β √(1 − y²)) / h² + atan(sin β √(1 − y²) / x).
#[test]
fn a_sphere_light_on_the_horizon_has_its_closed_form() {
    for (beta, h, value) in
        [(PI / 2.0, 2.0_f64, 0.090_586_1), (1.45, 3.0, 0.051_133_7), (1.8, 2.0, 0.023_703_4)]
    {
        let x = (h * h - 1.0).sqrt();
        let (sin, cos) = libm::sincos(beta);
        let y = -x * cos / sin;
        let root = (1.0 - y * y).sqrt();
        let expected =
            (cos * libm::acos(y) - x * sin * root) / (h * h) + libm::atan(sin * root / x);
        assert!((expected - value).abs() < 1e-7, "({beta}, {h}): {expected}, not {value}");
        assert_irradiance(&format!("E6, β = {beta}"), &sphere_light(beta, h), 300_000, expected);
    }
}

/// E7: form factors F, with E = πLF. The lamps face the receiver.
#[test]
fn flat_lamps_have_the_form_factors_of_the_catalogue() {
    let quad = |[a, b]: [f32; 2], size: f32| {
        let corners = [(a, b), (a + size, b), (a + size, b + size), (a, b + size)];
        let mut scene = receiver([lamp(1.0, 0.0)]);
        add_quad(&mut scene, corners.map(|(x, z)| vec3(x, 1.0, z)), 1);
        scene
    };
    let mut perpendicular = receiver([lamp(1.0, 0.0)]);
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    add_quad(&mut perpendicular, corners.map(|(y, z)| vec3(1.0, y, z)).map(turned), 1);
    let mut triangle = receiver([lamp(1.0, 0.0)]);
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)];
    add_triangle(&mut triangle, corners.map(|(x, z)| vec3(x, 1.0, z)), 1);

    for (name, scene, factor) in [
        ("corner", quad([0.0, 0.0], 1.0), 0.138_531_6),
        ("centre", quad([-1.0, -1.0], 2.0), 0.554_126_4),
        ("perpendicular", perpendicular, 0.055_734_2),
        ("triangle", triangle, 0.096_225_0),
    ] {
        assert_irradiance(&format!("E7, {name}"), &scene, 100_000, PI * factor);
    }
}

/// Every way to choose a light and every way to sample it has the same mean: two squares of which
/// one is near, a sphere and a point.
#[test]
fn no_choice_and_no_measure_changes_the_mean() {
    let mut scene = receiver([lamp(1.0, 0.0), lamp(3.0, 0.0)]);
    let square = |x0: f32, size: f32| {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        corners.map(|(x, z)| vec3(x0 + size * x, size, size * z))
    };
    add_quad(&mut scene, square(0.0, 1.0), 1);
    add_quad(&mut scene, square(-3.0, 3.0), 2);
    add_sphere(&mut scene, vec3(0.0, 2.0, -3.0), 1.0, 1);
    scene.lights.push(point_light(vec3(0.5, 1.0, -1.0), Rgb::splat(0.5)));
    let squares = PI * 0.138_531_6 * 4.0;
    let sphere = PI * 2.0 / f64::powf(13.0, 1.5);
    let point = PI * 0.5 / f64::powf(2.25, 1.5);
    let expected = squares + sphere + point;
    for choice in [Choice::Uniform, Choice::Power, Choice::Nearby] {
        for measure in [Measure::Area, Measure::SolidAngle] {
            for estimator in [Estimator::Light, Estimator::Mis] {
                let settings = Settings { choice, measure, ..limited(estimator, 1) };
                let name = format!("{choice:?}, {measure:?}");
                assert_radiance(&name, &scene, settings, at_receiver(), 120_000, expected / PI);
            }
        }
    }
}

/// The wall x = 1 faces the receiver if its vertices run the other way round.
fn turned(v: Vec3) -> Vec3 {
    vec3(v.x, v.y, -v.z)
}

/// E7: a disk as a fan of 256 triangles with the disk's area.
#[test]
fn a_disk_has_its_form_factor_as_a_fine_fan() {
    const SECTORS: u16 = 256;
    let angle = |i: u16| 2.0 * PI * f64::from(i) / f64::from(SECTORS);
    let wedge = angle(1);
    let radius = (wedge / libm::sin(wedge)).sqrt();
    for (name, offset, factor) in [("axis", 0.0, 0.5), ("offset", 1.0, 0.276_393_2)] {
        let mut scene = receiver([lamp(1.0, 0.0)]);
        let rim = |i: u16| {
            let (sin, cos) = libm::sincos(angle(i));
            vec3((offset + radius * cos) as f32, 1.0, (radius * sin) as f32)
        };
        for i in 0..SECTORS {
            add_triangle(&mut scene, [vec3(offset as f32, 1.0, 0.0), rim(i), rim(i + 1)], 1);
        }
        assert_irradiance(&format!("E7, disk, {name}"), &scene, 100_000, PI * factor);
    }
}

/// E8: a white sky, of which a black sphere takes sin²θ = ¼.
#[test]
fn a_black_sphere_takes_a_quarter_of_the_sky() {
    let mut scene = receiver([matte(0.0)]);
    scene.background = Vec3::ONE;
    add_sphere(&mut scene, vec3(0.0, 2.0, 0.0), 1.0, 1);
    assert_irradiance("E8", &scene, 200_000, 0.75 * PI);
}

/// A black wall without an end, behind the receiver, hides half of the sky. Everything lies on one
/// side of it, but the sky is no thing: a ray toward it does not end.
#[test]
fn a_wall_hides_the_sky_behind_it() {
    let mut scene = receiver([matte(0.0)]);
    scene.background = Vec3::ONE;
    let far = 1e4;
    let corners = [(-far, -far), (far, -far), (far, far), (-far, far)];
    add_quad(&mut scene, corners.map(|(x, y)| vec3(x, y, -0.01)), 1);
    // From a height above the wall's lower end, a hundredth before it.
    assert_irradiance("wall", &scene, 200_000, 0.5 * PI);
}

/// The furnace of the open kind: with cosine sampling alone, there is nothing left to chance.
#[test]
fn in_an_even_sky_every_estimator_is_exact_without_variance() {
    let mut scene = receiver([]);
    scene.background = Vec3::ONE;
    for estimator in ESTIMATORS {
        let samples = radiance(&scene, limited(estimator, 1), at_receiver(), 10_000);
        assert_mean(&format!("sky, {estimator:?}"), &samples, 1.0);
        let variance = samples.variance();
        assert!(variance <= 1e-12, "{estimator:?} has the variance {variance}");
    }
}

/// The weights of multiple importance sampling are 1 together: no heuristic moves the mean (E11).
#[test]
fn balance_and_power_have_the_same_mean() {
    use light_sampling::Heuristic::{Balance, Power};
    let expected = PI / 9.0 / PI;
    for heuristic in [Balance, Power] {
        let settings = Settings { heuristic, ..limited(Estimator::Mis, 1) };
        let scene = sphere_light(0.0, 3.0);
        assert_radiance(
            &format!("{heuristic:?}"),
            &scene,
            settings,
            at_receiver(),
            60_000,
            expected,
        );
        let samples = radiance(&sphere_light(0.0, 1.01), settings, at_receiver(), 60_000);
        assert_mean(&format!("{heuristic:?}, touching"), &samples, 1.0 / (1.01 * 1.01));
    }
}
