//! Flat lamps that are near: directions of a triangle, all equally likely (accuracy.md M2, M5, M10).

use std::f64::consts::PI;

use glam::{DVec3, Vec3, dvec3, vec3};
use light_sampling::{FlatLamp, Light, LightSample, Lights, Measure, SphericalTriangle};
use ray_casting::Rgb;
use statistics::{Moments, assert_mean, check_mean, seed};
use workbench::Sampler;

use crate::scenes::{LAMP, add_triangle, empty, in_ball, viewer};

/// Ω as the sum of the angles at the corners, less π: Girard's theorem, in double precision.
fn girard(corners: [DVec3; 3]) -> f64 {
    let angle = |i: usize| {
        let [a, b, c] = [0, 1, 2].map(|k| corners[(i + k) % 3].normalize());
        let (to_b, to_c) = (b - b.dot(a) * a, c - c.dot(a) * a);
        libm::atan2(to_b.cross(to_c).length(), to_b.dot(to_c))
    };
    angle(0) + angle(1) + angle(2) - PI
}

/// The irradiance that a polygon of radiance 1 causes at the origin on a surface with the normal
/// `facing`, if it lies above the horizon as a whole: ½ Σ θᵢ n·Γᵢ, where θᵢ is the angle that side
/// number i is seen under and Γᵢ the unit normal of the plane through it (Lambert 1760).
fn irradiance(corners: &[DVec3], facing: DVec3) -> f64 {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let sum: f64 = sides
        .map(|(a, b)| {
            let across = a.cross(*b);
            let angle = libm::atan2(across.length(), a.dot(*b));
            angle * facing.dot(across.normalize())
        })
        .sum();
    0.5 * sum.abs()
}

#[test]
fn an_octant_is_an_eighth_of_the_sphere_and_a_plane_half_of_it() {
    let octant = SphericalTriangle::new([DVec3::X, DVec3::Z, DVec3::Y]).expect("in view");
    assert!((octant.solid_angle / (PI / 2.0) - 1.0).abs() < 1e-7, "{}", octant.solid_angle);
    for height in [1e-3, 1e-6, 1e-9, 1e-12] {
        let corners =
            [dvec3(-1.0, -1.0, -height), dvec3(1.0, -1.0, -height), dvec3(0.0, 1.0, -height)];
        let seen = SphericalTriangle::new(corners).expect("in view").solid_angle;
        let missing = (2.0 * PI - seen) / height;
        // At the rim, which is about 1 away, height/1 is missing all around: some 2π and a bit.
        let limit = 10.0 + 1e-6 / height;
        assert!(missing < limit && seen <= 2.0 * PI + 1e-6, "at {height:e}: {seen}");
    }
}

#[test]
fn solid_angles_follow_girards_theorem() {
    let mut sampler = Sampler::new(seed(0x6107), 0, 0);
    let mut tested = 0;
    for _ in 0..20_000 {
        let place = in_ball(&mut sampler).as_dvec3();
        let [a, b, c] = [(); 3].map(|()| place + in_ball(&mut sampler).as_dvec3());
        let seen = SphericalTriangle::new([a, b, c]).or_else(|| SphericalTriangle::new([a, c, b]));
        let (seen, expected) = (seen.map_or(0.0, |seen| seen.solid_angle), girard([a, b, c]));
        // The oracle subtracts π, and so do its roundings.
        if expected > 1e-6 {
            tested += 1;
            assert!((seen / expected - 1.0).abs() < 1e-6, "{seen} for {a} {b} {c}: {expected}");
        }
    }
    assert!(tested > 19_000, "only {tested} triangles");
}

/// Where Girard's theorem has nothing left: far away, Ω = A cos θ'/r².
#[test]
fn small_solid_angles_keep_their_digits() {
    for exponent in 0..=15 {
        let distance = 100.0 * libm::pow(10.0, f64::from(exponent));
        let corners =
            [dvec3(0.0, 0.0, -distance), dvec3(1.0, 0.0, -distance), dvec3(0.0, 1.0, -distance)];
        let seen = SphericalTriangle::new(corners).expect("in view").solid_angle;
        let expected = 0.5 / (distance * distance);
        // The next term of the series is smaller by 1/r².
        let tolerance = 1e-6 + 1.0 / (distance * distance);
        assert!((seen / expected - 1.0).abs() < tolerance, "at {distance:e}: {seen:e}");
    }
}

#[test]
fn from_behind_in_the_plane_and_at_a_corner_nothing_is_seen() {
    let corners = [dvec3(1.0, 2.0, -3.0), dvec3(2.0, 2.5, -3.0), dvec3(1.5, 4.0, -3.5)];
    let seen_from = |place: DVec3| SphericalTriangle::new(corners.map(|corner| corner - place));
    assert!(seen_from(DVec3::ZERO).is_some(), "the front");
    let [a, b, c] = corners;
    let mirrored = 2.0 * ((a - DVec3::ZERO).project_onto((b - a).cross(c - a)));
    assert!(seen_from(mirrored).is_none(), "from behind: {:?}", seen_from(mirrored));
    for corner in corners {
        assert!(seen_from(corner).is_none(), "at a corner: {:?}", seen_from(corner));
    }

    // In the plane, exactly: inside, on a side, on a corner, outside.
    for measure in [Measure::Area, Measure::SolidAngle] {
        let radiance = Rgb::ONE;
        let triangle = FlatLamp::triangle([Vec3::ZERO, Vec3::X, Vec3::Y], radiance, measure);
        let square = [Vec3::ZERO, Vec3::X, vec3(1.0, 1.0, 0.0), Vec3::Y];
        let square = FlatLamp::parallelogram(square, radiance, measure).expect("it is one");
        for place in [[0.25, 0.25], [0.5, 0.0], [0.0, 0.0], [1.0, 0.0], [0.5, 0.5], [1.2, -0.1]] {
            let place = vec3(place[0], place[1], 0.0);
            for height in [0.0, -1e-30, -1e-6, -1.0] {
                let viewer = place + height * Vec3::Z;
                for lamp in [triangle, square] {
                    let sample = lamp.sample(viewer, [0.3, 0.7]);
                    assert!(sample.is_none(), "{measure:?} from {viewer}: {sample:?}");
                }
            }
            // A side's end: NaN must not get out.
            let pdf = square.pdf(place, Vec3::NEG_Z, 1.0);
            assert!(pdf.is_none_or(|pdf| pdf > 0.0 && pdf.is_finite()), "{measure:?}: {pdf:?}");
        }
    }
}

/// Lamps of all shapes and sizes, and viewers as near as can be.
#[test]
fn extreme_random_numbers_lamps_and_viewers_give_points_of_the_lamp() {
    let extremes = [0.0, 2.0_f32.powi(-24), 0.5, 1.0_f32.next_down()];
    let mut sampler = Sampler::new(seed(0x6507), 0, 0);
    let mut seen = 0;
    for scale in [1e-15_f32, 1e-6, 1.0, 1e6, 1e15] {
        for thinness in [1.0_f32, 1e-3, 1e-6] {
            for height in [1e-12_f32, 1e-6, 1e-3, 0.1, 1.0] {
                let [e1, e2] = [Vec3::X, vec3(0.3, thinness, 0.0)].map(|edge| scale * edge);
                let triangle = [Vec3::ZERO, e1, e2];
                let square = [Vec3::ZERO, e1, e1 + e2, e2];
                let measure = Measure::SolidAngle;
                let lamps = [
                    Some(FlatLamp::triangle(triangle, Rgb::ONE, measure)),
                    FlatLamp::parallelogram(square, Rgb::ONE, measure),
                ];
                for (lamp, [x, y]) in lamps.iter().flatten().flat_map(|lamp| {
                    let places = [[0.4, 0.3], [0.0, 0.0], [1.0, 0.0], [0.6, 1.0], [-0.2, 0.5]];
                    places.map(|place| (lamp, place))
                }) {
                    let place = vec3(x, thinness * y, height * (1.0 + sampler.next_1d()));
                    for u in extremes.iter().flat_map(|&a| extremes.map(|b| [a, b])) {
                        let Some(sample) = lamp.sample(scale * place, u) else { continue };
                        seen += 1;
                        let unit = (sample.wi.length() - 1.0).abs() <= 4.0 * f32::EPSILON;
                        let pdf = sample.pdf_solid_angle;
                        assert!(unit && pdf.is_finite() && pdf > 0.0, "{place}, {u:?}: {sample:?}");
                        // Up to what rounding does to a needle from a millionth of its thickness.
                        assert!(sample.wi.z <= 1e-6, "{place}, {u:?}: {sample:?} leads away");
                        let end = sample.end.expect("a lamp has a place").position / scale;
                        let (b2, b1) = (end.y / thinness, end.x - 0.3 * end.y / thinness);
                        let inside = [b1, b2].map(|b| (-1e-6..=1.0 + 1e-6).contains(&b));
                        assert!(inside == [true; 2] && end.z == 0.0, "{place}, {u:?}: {end}");
                    }
                }
            }
        }
    }
    assert!(seen > 10_000, "only {seen} points");
}

/// Seen from all but within one of its edges, whose ends then lie opposite each other: a direction was
/// 5.5 u too long. From the long run of accuracy.md M9.
#[test]
fn within_an_edge_of_a_lamp_directions_have_unit_length() {
    let corners = [
        vec3(-0.019_733_146, 0.022_561_507, 0.000_961_772_1),
        vec3(0.002_885_306, -0.002_800_433, -0.003_226_701_6),
        vec3(0.021_653_25, -0.025_373_934, 0.020_127_786),
    ];
    let viewer = Vec3::from([0xb7b2_b013, 0x3992_278d, 0x39f5_f989].map(f32::from_bits));
    let u = [0x3f27_73be, 0x3f2d_7a54].map(f32::from_bits);
    let lamp = FlatLamp::triangle(corners, Rgb::ONE, Measure::SolidAngle);
    let wi = lamp.sample(viewer, u).map(|sample| sample.wi.as_dvec3().length());
    let error = wi.map_or(f64::NAN, |length| (length - 1.0).abs());
    assert!(error <= 2.0 * f64::from(f32::EPSILON), "the length is {error:e} off");
}

/// cos θ / p, whose mean is the irradiance of the origin; `pdf` tells p.
fn irradiances(
    lamp: &FlatLamp,
    facing: Vec3,
    n: u32,
    pdf: impl Fn(&LightSample) -> f32,
) -> Moments {
    let mut sampler = Sampler::new(seed(0x6207), 0, 0);
    let mut once = || {
        let sample = lamp.sample(Vec3::ZERO, sampler.next_2d());
        sample.map_or(0.0, |light| f64::from(facing.dot(light.wi).max(0.0) / pdf(&light)))
    };
    (0..n).map(|_| once()).collect()
}

/// A quad and its halves before a viewer at the origin, in units of its radius, as far as
/// `distance`.
fn before_the_origin(distance: f32) -> [Vec3; 4] {
    let middle = distance * vec3(0.36, 0.48, -0.8);
    let (x, y) = (vec3(0.625, 0.0, 0.375), vec3(0.0, 0.75, 0.125));
    [middle - x - y, middle + x - y, middle + x + y, middle - x + y]
}

/// The mean of either measure is Lambert's closed form, and that of solid angle has less variance;
/// also where the one takes over from the other.
#[test]
fn both_measures_send_the_light_of_lamberts_formula() {
    for distance in [0.9, 1.2, 1.4, 1.6, 3.0, 30.0] {
        let corners = before_the_origin(distance);
        let facing = vec3(0.36, 0.48, -0.8);
        for outline in [&corners[..3], &corners[..]] {
            let exact: Vec<DVec3> = outline.iter().map(|corner| corner.as_dvec3()).collect();
            let expected = irradiance(&exact, facing.as_dvec3());
            let [area, solid_angle] = [Measure::Area, Measure::SolidAngle].map(|measure| {
                let lamp = match outline {
                    [a, b, c] => FlatLamp::triangle([*a, *b, *c], Rgb::ONE, measure),
                    _ => FlatLamp::parallelogram(corners, Rgb::ONE, measure).expect("it is one"),
                };
                let samples = irradiances(&lamp, facing, 40_000, |light| light.pdf_solid_angle);
                let name = format!("{measure:?}, {} corners at {distance}", outline.len());
                let bias = assert_mean(&name, &samples, expected);
                assert!(bias <= 0.03, "{name}: only a bias of {bias} would be seen");
                samples.variance()
            });
            assert!(solid_angle <= area, "at {distance}: {solid_angle} against {area}");
        }
    }
}

/// What the tests above are there to notice: the other measure's density.
#[test]
fn the_density_of_the_other_measure_is_noticed() {
    let corners = before_the_origin(1.2);
    let facing = vec3(0.36, 0.48, -0.8);
    let exact = corners.map(|corner| corner.as_dvec3());
    let expected = irradiance(&exact, facing.as_dvec3());
    let lamp = |measure| FlatLamp::parallelogram(corners, Rgb::ONE, measure).expect("it is one");
    let [area, solid_angle] = [Measure::Area, Measure::SolidAngle].map(lamp);
    let mixed = irradiances(&solid_angle, facing, 40_000, |light| {
        let end = light.end.expect("a lamp has a place").position;
        area.pdf(Vec3::ZERO, light.wi, end.length_squared()).expect("it shines there")
    });
    let result = check_mean("mixed measures", &mixed, expected);
    assert!(result.is_err(), "the wrong measure passes: {result:?}");
}

/// From just in front of one corner of a wide lamp, the middle is so far away that rounding alone
/// could put the viewer behind it. It is lit, and from as far behind the lamp it is not.
#[test]
fn a_viewer_just_in_front_of_a_wide_lamp_is_lit() {
    let mut sampler = Sampler::new(seed(0x6608), 0, 0);
    for i in 0..2_000 {
        let [b, c] = [(); 2].map(|()| 1e4 * in_ball(&mut sampler).normalize());
        if b.cross(c).length() < 1e7 {
            continue; // a needle
        }
        let lamp = FlatLamp::triangle([Vec3::ZERO, b, c], Rgb::ONE, Measure::SolidAngle);
        let normal = b.as_dvec3().cross(c.as_dvec3()).normalize();
        let foot = (b + c).as_dvec3() * 1e-6;
        for side in [1.0, -1.0] {
            let viewer = (foot + side * 1e-4 * normal).as_vec3();
            let drawn =
                (0..20).filter(|_| lamp.sample(viewer, sampler.next_2d()).is_some()).count();
            let expected = if side > 0.0 { 20 } else { 0 };
            assert_eq!(drawn, expected, "of 20 points, lamp {i}: {lamp:?}, viewer {viewer}");
        }
    }
}

/// A lamp of any position and tilt does not light itself, on whichever side of its plane rounding
/// has put the point: from a height of some last digits, it would fill half of all directions.
#[test]
fn a_lamp_does_not_light_itself_wherever_rounding_puts_the_point() {
    let mut sampler = Sampler::new(seed(0x6607), 0, 0);
    let mut asked = 0;
    for offset in [0.0, 1.0, 1e2] {
        for _ in 0..300 {
            let place = offset * in_ball(&mut sampler);
            let corners = [(); 3].map(|()| place + in_ball(&mut sampler));
            let mut scene = empty();
            add_triangle(&mut scene, corners, LAMP);
            let lights = Lights::new(&scene);
            let Light::Flat(lamp) = lights.all()[0] else { panic!("{:?}", lights.all()) };
            for _ in 0..100 {
                let [a, b, c] = corners.map(|corner| corner.as_dvec3());
                let (x, y) = (f64::from(sampler.next_1d()), f64::from(sampler.next_1d()));
                let (x, y) = if x + y > 1.0 { (1.0 - x, 1.0 - y) } else { (x, y) };
                let surface = viewer((a + x * (b - a) + y * (c - a)).as_vec3(), lamp.normal);
                let Some(light) = lights.sample(&surface, &mut sampler) else { continue };
                asked += 1;
                let sent = lamp.normal.dot(light.wi).max(0.0) / light.pdf_solid_angle;
                assert!(sent <= 1e-6, "{sent} from {corners:?} at {}: {light:?}", surface.position);
            }
        }
    }
    assert!(asked > 10_000, "only {asked} directions were drawn");
}
