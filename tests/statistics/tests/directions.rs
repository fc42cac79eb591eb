//! The test of directions passes right samplers, and finds those with a planted fault.

use statistics::{Grid, Rejected, assert_directions, check_directions, seed};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

/// SplitMix64.
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// The direction at a uniform azimuth around z.
    fn at(&mut self, cos_theta: f64) -> [f64; 3] {
        let (sin_phi, cos_phi) = libm::sincos(TAU * self.next());
        let sin_theta = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
        [sin_theta * cos_phi, sin_theta * sin_phi, cos_theta]
    }

    /// cos θ = u^(1/(n + 1)): the density (n + 1) cosⁿ θ / 2π.
    fn lobe(&mut self, n: f64) -> [f64; 3] {
        let u = 1.0 - self.next();
        self.at(libm::pow(u, 1.0 / (n + 1.0)))
    }
}

fn lobe_pdf(n: f64, cos_theta: f64) -> f64 {
    if cos_theta > 0.0 { (n + 1.0) * libm::pow(cos_theta, n) / TAU } else { 0.0 }
}

fn single([x, y, z]: [f64; 3]) -> Option<[f32; 3]> {
    Some([x as f32, y as f32, z as f32])
}

fn z([_, _, z]: [f32; 3]) -> f64 {
    f64::from(z)
}

const UNIFORM: f64 = 0.25 * FRAC_1_PI;
const MILLION: u32 = 1_000_000;

#[test]
fn uniform_directions_pass_on_both_grids() {
    for (number, grid) in [(41, Grid::SPHERE), (42, Grid::ODD)] {
        let mut random = Uniform(seed(number));
        let sample = || {
            let cos_theta = 2.0 * random.next() - 1.0;
            single(random.at(cos_theta))
        };
        let [fine, coarse] =
            assert_directions("sphere", &grid, MILLION, Rejected::Never, sample, |_| UNIFORM);
        assert!(fine.visible_deviation < 0.035, "{fine:?}");
        assert!(coarse.visible_deviation < 0.0125, "{coarse:?}");
    }
}

/// The horizon cuts through cells: this is what the adaptive quadrature is for.
#[test]
fn a_cosine_lobe_around_any_axis_passes() {
    for (i, axis) in
        [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.6, 0.0, -0.8], [0.48, 0.6, 0.64]]
            .into_iter()
            .enumerate()
    {
        let mut random = Uniform(seed(43 + i as u64));
        let [x, y, z] = basis(axis);
        let sample = || {
            let local = random.lobe(1.0);
            single([0, 1, 2].map(|i| x[i] * local[0] + y[i] * local[1] + z[i] * local[2]))
        };
        let pdf = |direction: [f32; 3]| {
            let cos_theta: f64 = (0..3).map(|i| axis[i] * f64::from(direction[i])).sum();
            lobe_pdf(1.0, cos_theta)
        };
        assert_directions("cosine", &Grid::SPHERE, 300_000, Rejected::Never, sample, pdf);
    }
}

fn basis(z: [f64; 3]) -> [[f64; 3]; 3] {
    let far = if z[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let x = cross(far, z);
    let length = x.iter().map(|c| c * c).sum::<f64>().sqrt();
    let x = x.map(|c| c / length);
    [x, cross(z, x), z]
}

/// A missing cosine: the direction is drawn with the cosine, the density forgot it.
#[test]
fn a_cosine_sampler_with_a_uniform_density_is_found() {
    let mut random = Uniform(seed(51));
    let uniform = |direction| if z(direction) > 0.0 { 0.5 * FRAC_1_PI } else { 0.0 };
    let found = check_directions(
        "cosine as uniform",
        &Grid::SPHERE,
        100_000,
        Rejected::Never,
        || single(random.lobe(1.0)),
        uniform,
    );
    let sentence = found.expect_err("the planted fault passes");
    assert!(sentence.contains("χ²"), "{sentence}");
}

#[test]
fn a_squared_cosine_is_no_cosine() {
    let mut random = Uniform(seed(52));
    let pdf = |direction| lobe_pdf(1.0, z(direction));
    let sample = || single(random.lobe(2.0));
    let found = check_directions("squared", &Grid::SPHERE, 100_000, Rejected::Never, sample, pdf);
    let sentence = found.expect_err("the planted fault passes");
    assert!(sentence.contains("χ²"), "{sentence}");
}

/// A smooth fault that 12 800 cells are too fine to see: 1.5 % more above, 1.5 % less below.
#[test]
fn a_smooth_fault_of_one_and_a_half_percent_is_found_by_the_coarse_grid() {
    let mut random = Uniform(seed(53));
    let sample = || {
        let cos_theta = 2.0 * random.next() - 1.0;
        let tilted = if random.next() < 0.015 { cos_theta.abs() } else { cos_theta };
        single(random.at(tilted))
    };
    let found =
        check_directions("tilted", &Grid::SPHERE, MILLION, Rejected::Never, sample, |_| UNIFORM);
    let sentence = found.expect_err("the planted fault passes");
    assert!(sentence.contains("coarse"), "{sentence}");
}

#[test]
fn a_density_that_is_not_normalised_is_found() {
    for factor in [0.99, 1.01] {
        let mut random = Uniform(seed(54));
        let pdf = |direction| factor * lobe_pdf(1.0, z(direction));
        let sample = || single(random.lobe(1.0));
        let found = check_directions("2π", &Grid::SPHERE, 1000, Rejected::Never, sample, pdf);
        assert!(found.is_err_and(|sentence| sentence.contains("∫ pdf")), "{factor} passes");
    }
}

#[test]
fn what_is_not_a_direction_is_found_at_the_first_sample() {
    for broken in [f32::NAN, f32::INFINITY, 0.0, 2.0, 0.999] {
        let mut random = Uniform(seed(55));
        let mut countdown = 500;
        let sample = || {
            countdown -= 1;
            let cos_theta = 2.0 * random.next() - 1.0;
            let direction = single(random.at(cos_theta));
            if countdown == 0 { Some([broken, 0.0, 0.0]) } else { direction }
        };
        let found =
            check_directions("broken", &Grid::ODD, 10_000, Rejected::Never, sample, |_| UNIFORM);
        assert!(found.is_err(), "{broken} passes as a direction");
    }
}

#[test]
fn a_density_that_is_not_finite_is_found() {
    for broken in [f64::NAN, f64::INFINITY, -UNIFORM] {
        let mut random = Uniform(seed(56));
        let sample = || {
            let cos_theta = 2.0 * random.next() - 1.0;
            single(random.at(cos_theta))
        };
        let pdf = |direction| if z(direction) > 0.9 { broken } else { UNIFORM };
        let found = check_directions("pole", &Grid::ODD, 10_000, Rejected::Never, sample, pdf);
        assert!(found.is_err(), "a density of {broken} passes");
    }
}

/// One sample in ten thousand below the horizon, where the density is 0.
#[test]
fn a_single_sample_where_none_can_be_is_found() {
    let mut random = Uniform(seed(57));
    let mut countdown = 9_000;
    let sample = || {
        countdown -= 1;
        let [x, y, z] = random.lobe(1.0);
        single([x, y, if countdown == 0 { -z } else { z }])
    };
    let pdf = |direction| lobe_pdf(1.0, z(direction));
    let found = check_directions("below", &Grid::SPHERE, 10_000, Rejected::Never, sample, pdf);
    assert!(found.is_err_and(|sentence| sentence.contains("density 0")), "it passes");
}

/// A sampler that rejects what lies below a plane: the remaining density is less than 1.
#[test]
fn rejected_samples_are_one_more_cell() {
    let cut = 0.3;
    let run = |keep: f64, rejected: Rejected| {
        let mut random = Uniform(seed(58));
        let sample = move || {
            let direction = random.lobe(1.0);
            (direction[2] > cut || random.next() < keep).then(|| single(direction)).flatten()
        };
        let pdf = move |direction| {
            let cos_theta = z(direction);
            if cos_theta > cut { lobe_pdf(1.0, cos_theta) } else { keep * lobe_pdf(1.0, cos_theta) }
        };
        check_directions("cut", &Grid::SPHERE, 200_000, rejected, sample, pdf)
    };
    assert!(run(0.0, Rejected::Remainder).is_ok(), "{:?}", run(0.0, Rejected::Remainder));
    assert!(run(0.5, Rejected::Remainder).is_ok(), "{:?}", run(0.5, Rejected::Remainder));
    assert!(run(0.5, Rejected::Never).is_err(), "samples without direction pass");
}

#[test]
fn too_many_rejections_are_found() {
    let mut random = Uniform(seed(59));
    let sample = || (random.next() < 0.97).then(|| single(random.lobe(1.0))).flatten();
    let pdf = |direction| 0.98 * lobe_pdf(1.0, z(direction));
    let found =
        check_directions("rejects", &Grid::SPHERE, 200_000, Rejected::Remainder, sample, pdf);
    assert!(found.is_err(), "3 % of rejections pass for 2 %");
}

/// A lobe of half a degree fills one cell of the whole sphere, but 12 800 of a grid around it.
#[test]
fn a_narrow_lobe_has_a_grid_of_its_own() {
    let grid = Grid::SPHERE.within(0.05);
    let run = |exponent: f64, number: u64| {
        let mut random = Uniform(seed(number));
        let pdf = |direction: [f32; 3]| {
            let [x, y, z] = direction.map(f64::from);
            // cos θ as a single-precision number has lost what is needed here; the sine has not.
            let cos_theta = (1.0 - x * x - y * y).max(0.0).sqrt();
            if z > 0.0 { lobe_pdf(10_000.0, cos_theta) } else { 0.0 }
        };
        let sample = || single(random.lobe(exponent));
        check_directions("lobe", &grid, 300_000, Rejected::Never, sample, pdf)
    };
    let [fine, _] = run(10_000.0, 60).unwrap_or_else(|sentence| panic!("{sentence}"));
    assert!(fine.degrees > 3_000, "{fine:?}");
    assert!(run(10_500.0, 61).is_err(), "an exponent that is 5 % too large passes");
}

/// θ up to a milliradian, in single precision.
#[test]
fn a_narrow_cone_passes() {
    let theta_max = 1e-3;
    let versine = 2.0 * libm::sin(0.5 * theta_max) * libm::sin(0.5 * theta_max);
    let mut random = Uniform(seed(62));
    let sample = || {
        let s = versine * random.next();
        let (sin_phi, cos_phi) = libm::sincos(TAU * random.next());
        let sin_theta = (s * (2.0 - s)).sqrt();
        single([sin_theta * cos_phi, sin_theta * sin_phi, 1.0 - s])
    };
    let limit = libm::sin(theta_max);
    let pdf = |[x, y, z]: [f32; 3]| {
        let [x, y] = [f64::from(x), f64::from(y)];
        let inside = z > 0.0 && x * x + y * y <= limit * limit * (1.0 + 1e-6);
        if inside { 1.0 / (TAU * versine) } else { 0.0 }
    };
    let grid = Grid::SPHERE.within(theta_max * (1.0 + 0.5e-6));
    assert_directions("cone", &grid, 300_000, Rejected::Never, sample, pdf);
}

#[test]
fn a_grid_without_an_axis_is_refused() {
    for axis in [[0.0; 3], [f32::NAN, 0.0, 1.0]] {
        let refused = std::panic::catch_unwind(|| Grid::SPHERE.around(axis)).is_err();
        assert!(refused, "{axis:?} is an axis");
    }
    assert!(std::panic::catch_unwind(|| Grid::ODD.within(PI + 0.1)).is_err(), "beyond π");
}
