//! Light between surfaces, with a known sum of all bounces.

use crate::mistakes::{Mistake, Mistaken};
use crate::scenes::{
    BOUNDED, ROULETTE, anywhere, assert_sees, constant, depth, found, gather, matte, quad, scene,
    sphere, with_paths,
};
use glam::{Vec3, vec3};
use path_tracing::Ending;
use ray_casting::{Ray, Rgb, Scene};
use rendering_equation::Density;
use rendering_equation::directions::uniform_sphere;
use statistics::check_mean;
use workbench::Sampler;

const U: f32 = f32::EPSILON / 2.0;

/// The part of a unit sphere below z = ½, closed by a lamp: a ball so large that its face is flat.
///
/// From any point of the wall the lamp looks like the cap that it cuts off, a quarter of the
/// sphere, and in a sphere the form factor of a part is its share of the area.
fn integrating_sphere(albedo: f32, albedo_of_lamp: f32) -> Scene {
    let far = 100_000.0;
    let wall = matte("wall", albedo, 0.0) + &sphere([0.0; 3], 1.0, "wall");
    let lamp = matte("lamp", albedo_of_lamp, 1.0) + &sphere([0.0, 0.0, far + 0.5], far, "lamp");
    scene(0.0, &(wall + &lamp))
}

/// From a point within the unit sphere's lower half, in any direction that meets the wall.
fn to_the_wall(sampler: &mut Sampler) -> Ray {
    let origin = vec3(0.3, -0.2, -0.4);
    loop {
        let direction = uniform_sphere(sampler.next_2d());
        if direction.z < 0.2 {
            return Ray::new(origin, direction);
        }
    }
}

/// accuracy.md E3. With a black lamp that fills f of what every point of the wall sees,
/// B = ρ f / (1 − ρ (1 − f)), and with k bounces ρ f Σ (ρ (1 − f))ⁱ.
#[test]
fn the_wall_of_an_integrating_sphere_is_equally_bright_everywhere() {
    let scene = integrating_sphere(0.8, 0.0);
    for (most, samples) in [(1, 1_400_000), (2, 800_000), (5, 400_000)] {
        let shares = (0..most).map(|i| 0.6_f64.powi(i));
        let expected = 0.2 * shares.sum::<f64>();
        let moments = found(&scene, depth(most as u32), Density::Cosine, samples, to_the_wall);
        assert_sees(0.01, &format!("{most} bounces"), &moments, expected);
    }
    let moments = found(&scene, ROULETTE, Density::Cosine, 400_000, to_the_wall);
    assert_sees(0.01, "all bounces", &moments, 0.5);
}

/// E3 with a lamp that reflects 0.8 as well: the lamp sees nothing but wall, so
/// B = ρ (f (1 + ρ B) + (1 − f) B) = 0.2 / 0.24.
#[test]
fn the_lamp_of_an_integrating_sphere_reflects_too() {
    let scene = integrating_sphere(0.8, 0.8);
    let moments = found(&scene, ROULETTE, Density::Cosine, 300_000, to_the_wall);
    assert_sees(0.01, "a lamp that reflects", &moments, 0.2 / 0.24);
}

/// accuracy.md E4: two concentric spheres, the inner one (r = 1, ρ = ½) shines with 1, the outer
/// one (r = 2, ρ = 0.8) does not. A quarter of what the outer one sees is the inner one:
/// B₁ = 1 + ½ B₂ = 4/3, B₂ = 0.8 (¼ B₁ + ¾ B₂) = 2/3.
#[test]
fn between_two_concentric_spheres_both_have_their_radiance() {
    let materials = matte("inner", 0.5, 1.0) + &matte("outer", 0.8, 0.0);
    let spheres = sphere([0.0; 3], 1.0, "inner") + &sphere([0.0; 3], 2.0, "outer");
    let scene = scene(0.0, &(materials + &spheres));
    let between = |sampler: &mut Sampler| uniform_sphere(sampler.next_2d());
    for density in [Density::Cosine, Density::Uniform] {
        let n = if density == Density::Cosine { 120_000 } else { 280_000 };
        let inner = found(&scene, ROULETTE, density, n, |sampler| {
            let outwards = between(sampler);
            Ray::new(1.5 * outwards, -outwards)
        });
        assert_sees(0.01, &format!("inner, {density:?}"), &inner, 4.0 / 3.0);
        let outer = found(&scene, ROULETTE, density, 2 * n, |sampler| {
            let outwards = between(sampler);
            Ray::new(1.5 * outwards, outwards)
        });
        assert_sees(0.015, &format!("outer, {density:?}"), &outer, 2.0 / 3.0);
    }
}

/// accuracy.md E8: a black ball of radius 1, its centre 2 above the floor, hides sin² 30° = ¼ of
/// the sky's light.
#[test]
fn a_black_ball_takes_a_quarter_of_the_sky() {
    let floor = [[-1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
    let materials = matte("floor", 0.9, 0.0) + &matte("black", 0.0, 0.0);
    let records = materials + &quad(floor, "floor") + &sphere([0.0, 2.0, 0.0], 1.0, "black");
    let scene = scene(1.0, &records);
    let down = |_: &mut Sampler| Ray::new(vec3(0.0, 0.5, 0.0), Vec3::NEG_Y);
    for density in [Density::Cosine, Density::Uniform] {
        let moments = found(&scene, ROULETTE, density, 500_000, down);
        assert_sees(0.01, &format!("{density:?}"), &moments, 0.75 * f64::from(0.9_f32));
    }
}

/// What these tests are worth.
#[test]
fn the_integrating_sphere_finds_planted_mistakes() {
    let scene = integrating_sphere(0.8, 0.8);
    let check = |mistake| {
        let paths = Mistaken::new(&scene, mistake, Density::Cosine, BOUNDED);
        let moments = gather(120_000, |sampler| paths.radiance(to_the_wall(sampler), sampler));
        check_mean("a lamp that reflects", &moments, 0.2 / 0.24)
    };
    let right = check(Mistake::None);
    assert!(right.is_ok(), "{right:?}");
    for mistake in
        [Mistake::DividesTwice, Mistake::NeverDivides, Mistake::OnePercent, Mistake::LampsOnlyShine]
    {
        let wrong = check(mistake);
        assert!(wrong.is_err(), "{mistake:?} was not found: {wrong:?}");
    }
}

/// accuracy.md I6: what paths of k events bring, added up, is what the picture holds; and a limit
/// leaves out exactly the longer ones.
#[test]
fn contributions_by_length_add_up_to_the_whole() {
    let scene = integrating_sphere(0.8, 0.8);
    let paths = Mistaken::new(&scene, Mistake::None, Density::Cosine, constant(0.75));
    for most in [0, 1, 3, 7, 63] {
        let ending = Ending { depth: most, ..constant(0.75) };
        with_paths(&scene, ending, Density::Cosine, |whole| {
            for i in 0..2_000 {
                let [ours, theirs] = &mut [0; 2].map(|_| Sampler::new(1, 0, i));
                let mut sum = 0.0;
                let up_to = |events, part: Rgb| sum += if events <= most { part.x } else { 0.0 };
                paths.follow(anywhere(ours), ours, up_to);
                let whole = whole(anywhere(theirs), theirs).x;
                let error = (whole - sum).abs();
                assert!(error <= 32.0 * U * sum, "path {i}, at most {most}: {whole} for {sum}");
            }
        });
    }
}
