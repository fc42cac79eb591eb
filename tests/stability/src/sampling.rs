//! Samplers and their densities: M1 to M14.

use std::f64::consts::TAU;

use glam::{DVec3, Vec3};
use light_sampling::{Discrete, FlatLamp, LightSample, Measure, SphereLamp};
use ray_casting::{Rgb, Sphere};
use rendering_equation::directions::{
    cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere, uniform_hemisphere_pdf,
    uniform_sphere,
};
use rendering_equation::{Brdf, Density, Frame, Lambert, Lobe};
use workbench::Sampler;

use crate::bits::{self, U};
use crate::random::Random;
use crate::trial::Trial;

crate::catalogue! {
    M1 elsewhere "chapters/00-workbench/src/sampler.rs" numbers_stay_below_one;
    M2 elsewhere "chapters/07-light-sampling/tests/lamps/directions.rs"
        spheres_from_far_from_near_and_nearly_touching;
    M3 elsewhere "chapters/05-rendering-equation/tests/surfaces/hemispheres.rs"
        cosine_directions_follow_their_density;
    M4 random/1 the_numbers_of_a_direction_can_be_read_from_it;
    M5 random/2 every_sample_is_finite_and_has_a_density;
    M6 elsewhere "chapters/05-rendering-equation/tests/surfaces/extremes.rs"
        cosine_directions_stay_off_the_plane;
    M7 random/1 every_normal_gets_three_unit_vectors_at_right_angles;
    M8 elsewhere "chapters/07-light-sampling/tests/lamps/cones.rs" tiny_cones_do_not_collapse;
    M9 random/2 a_lamp_seen_from_next_to_it_gives_finite_samples;
    M10 elsewhere "chapters/07-light-sampling/tests/lamps/densities.rs"
        a_path_that_meets_a_lamp_is_told_the_density_of_its_sample;
    M11 absent every_stratum_has_one_point "there are no stratified points before chapter 8";
    M12 random/8 an_entry_without_weight_is_never_chosen;
    M13 elsewhere "chapters/00-workbench/src/sampler.rs"
        neighbours_in_every_part_of_the_key_are_uncorrelated;
    M14 absent a_normal_plus_its_opposite_is_handled
        "no sampler of the course adds a unit vector to the normal";
}

/// A random number as the samplers take it: now and then one of the ends of its range.
fn u(random: &mut Random) -> f32 {
    match random.below(16) {
        0 => 0.0,
        1 => U as f32,
        2 => 0.5,
        3 => 1.0 - U as f32,
        _ => random.u(),
    }
}

fn named(u: [f32; 2]) -> String {
    format!("u = [{}, {}]", bits::float(u[0]), bits::float(u[1]))
}

/// The map from numbers to directions is inverted in double precision: u₀ from z, u₁ from the angle
/// about it. Within 10⁻⁵ of both, the second where a hundredth of the circle is more than a rounding
/// of x and y (sin θ > 0.01).
fn the_numbers_of_a_direction_can_be_read_from_it(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let u = [u(&mut trial.random), u(&mut trial.random)];
        let [u0, u1] = u.map(f64::from);
        let error = |direction: Vec3, from_z: fn(f64) -> f64| {
            let d = direction.as_dvec3();
            let turn = libm::atan2(d.y, d.x) / TAU;
            let turn = if turn < 0.0 { turn + 1.0 } else { turn };
            // A turn of 1 is one of 0.
            let beside = (turn - u1).abs();
            let around = if d.truncate().length() > 0.01 { beside.min(1.0 - beside) } else { 0.0 };
            (from_z(d.z) - u0).abs().max(around)
        };
        let worst = error(cosine_hemisphere(u), |z| 1.0 - z * z)
            .max(error(uniform_hemisphere(u), |z| 1.0 - z))
            .max(error(uniform_sphere(u), |z| 0.5 * (1.0 - z)));
        trial.within(worst, 1e-5, || named(u));
    }
}

/// Directions of every sampler are unit vectors to 4 u (turned into a frame, 8 u) with a density above
/// 0, and weights are finite and not negative, for exponents from 0 to 10⁹ and viewers down to
/// grazing. Error in u, of the length.
fn every_sample_is_finite_and_has_a_density(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let u = [u(random), u(random)];
        let (cosine, uniform) = (cosine_hemisphere(u), uniform_hemisphere(u));
        let local = [cosine, uniform, uniform_sphere(u)].map(|w| off_unit(w) / 4.0);
        let has_density =
            cosine_hemisphere_pdf(cosine.z) > 0.0 && uniform_hemisphere_pdf(uniform.z) > 0.0;

        let brdf = some_brdf(random);
        let density = [Density::Cosine, Density::Uniform][random.below(2) as usize];
        let mut sampler = Sampler::new(random.bits(), 0, 0);
        let scattered = brdf.sample(density, &mut sampler);
        let is_sound = scattered.as_ref().is_none_or(|s| {
            s.weight.is_finite() && s.weight.min_element() >= 0.0 && s.pdf_solid_angle > 0.0
        });
        let turned = scattered.map_or(0.0, |s| off_unit(s.wi) / 8.0);
        let worst = local.into_iter().fold(turned, f64::max);
        let error = if is_sound && has_density { 8.0 * worst } else { f64::NAN };
        trial.within(error, 8.0, || format!("{}, {brdf:?}, {density:?}", named(u)));
    }
}

/// How many u the length of a vector is off.
fn off_unit(direction: Vec3) -> f64 {
    (direction.as_dvec3().length() - 1.0).abs() / U
}

fn some_brdf(random: &mut Random) -> Brdf {
    let n = random.direction();
    let mut wo = random.direction();
    if random.below(2) == 0 {
        wo = (n.any_orthonormal_vector() + random.magnitude(-7.0, 0.0) * n).normalize();
    }
    let (normal, wo) = (n.as_vec3(), if wo.dot(n) < 0.0 { -wo } else { wo }.as_vec3());
    let exponent = if random.below(8) == 0 { 0.0 } else { random.magnitude(-2.0, 9.0) as f32 };
    let lobe = (random.below(2) == 0).then(|| Lobe::new(Rgb::splat(0.5), exponent));
    let albedo = Rgb::splat(if random.below(4) == 0 { 0.0 } else { 0.4 });
    Brdf { normal, facing: normal, wo, lambert: Lambert { albedo }, lobe }
}

/// Normals anywhere, next to a pole and on the axes: right angles and lengths to 5 · 10⁻⁷, some 8 u.
/// Duff's formula has no pole; the older one is off by 8 · 10⁻² next to one.
fn every_normal_gets_three_unit_vectors_at_right_angles(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let pole = DVec3::AXES[random.below(3) as usize] * (2.0 * random.below(2) as f64 - 1.0);
        let normal = match random.below(3) {
            0 => random.direction(),
            1 => (pole + random.magnitude(-12.0, -1.0) * random.direction()).normalize(),
            _ => pole,
        }
        .as_vec3();
        let frame = Frame::around(normal);
        let [t, b, n] = [frame.tangent, frame.bitangent, normal].map(|v| v.as_dvec3());
        let errors = [
            t.length() - 1.0,
            b.length() - 1.0,
            t.dot(b),
            t.dot(n),
            b.dot(n),
            t.cross(b).dot(n) - 1.0,
        ];
        let worst = errors.into_iter().map(f64::abs).fold(0.0, f64::max);
        let worst = if frame.tangent.is_finite() { worst } else { f64::NAN };
        trial.within(worst, 5e-7, || bits::vec3(normal));
    }
}

/// Viewers on, within, 1 ULP outside, and down to 10⁻⁷ of its size beside a lamp: every sample has a
/// unit direction, a finite density above 0, and leads to a finite point.
fn a_lamp_seen_from_next_to_it_gives_finite_samples(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let u = [u(random), u(random)];
        let scale = random.magnitude(-6.0, 6.0);
        let place = scale * random.magnitude(-3.0, 3.0) * random.direction();
        let gap = [0.0, 1.0, -1.0][random.below(3) as usize] * random.magnitude(-8.0, 1.0);

        let sphere = Sphere { center: place.as_vec3(), radius: scale as f32 };
        let ball = SphereLamp { sphere, radiance: Rgb::ONE };
        let beside = place + scale * (1.0 + gap) * random.direction();
        let beside = random.beside_point(beside.as_vec3());

        let corners = [(); 3].map(|()| (place + scale * random.in_cube()).as_vec3());
        let measure = [Measure::Area, Measure::SolidAngle][random.below(2) as usize];
        let flat = FlatLamp::triangle(corners, Rgb::ONE, measure);
        let [b, c] = [random.unit(), random.unit()];
        let [p, q, r] = corners.map(|corner| corner.as_dvec3());
        let over = p + b * (q - p) + c * (r - p) + gap * scale * flat.normal.as_dvec3();
        let over = random.beside_point(over.as_vec3());

        trial.require(is_sound(ball.sample(beside, u)), || {
            format!("{ball:?} from {}, {}", bits::vec3(beside), named(u))
        });
        trial.require(is_sound(flat.sample(over, u)), || {
            format!("{corners:?}, {measure:?} from {}, {}", bits::vec3(over), named(u))
        });
    }
}

/// Whether a sample, if there is one, can be used.
fn is_sound(sample: Option<LightSample>) -> bool {
    sample.is_none_or(|sample| {
        let end = sample.end.map_or(Vec3::NAN, |end| end.position);
        let pdf = sample.pdf_solid_angle;
        off_unit(sample.wi) <= 4.0 && pdf > 0.0 && pdf.is_finite() && end.is_finite()
    })
}

/// Up to 40 weights over 30 decades, a third of them 0: what is picked has a weight, by numbers at
/// both ends of their range and between.
fn an_entry_without_weight_is_never_chosen(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let count = 1 + random.below(40) as usize;
        let mut weights: Vec<f64> = (0..count)
            .map(|_| if random.below(3) == 0 { 0.0 } else { random.magnitude(-15.0, 15.0) })
            .collect();
        weights[random.below(count as u64) as usize] = 1.0;
        let discrete = Discrete::new(&weights);
        for _ in 0..4 {
            let u = u(&mut trial.random);
            let picked = discrete.pick(u);
            let holds = weights[picked] > 0.0 && discrete.pmf(picked) > 0.0;
            trial.require(holds, || format!("{u} picks {picked} of {weights:?}"));
        }
    }
}
