//! One ray, one triangle.

use glam::{Vec3, vec3};
use ray_casting::math::gamma;
use ray_casting::{Hit, Interval, Ray, triangle};
use workbench::Sampler;

use crate::tools::{
    direction, exact_normal, in_cube, scene, surface, toward, triangles, ulp, ulps,
};

const RIGHT_ANGLED: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

fn intersect(ray: &Ray, corners: &[Vec3; 3]) -> Option<Hit> {
    triangle::intersect(&triangle::ShearedRay::new(ray), corners, 0)
}

/// A triangle and a ray aimed at a point of its plane, near or in it.
fn random_case(i: u64) -> ([Vec3; 3], Ray) {
    let mut sampler = Sampler::new(4, i, 0);
    let corners = [(); 3].map(|()| in_cube(&mut sampler));
    let (b1, b2) = (1.5 * sampler.next_1d() - 0.25, 1.5 * sampler.next_1d() - 0.25);
    let [v0, v1, v2] = corners;
    let target = v0 + b1 * (v1 - v0) + b2 * (v2 - v0);
    (corners, toward(3.0 * in_cube(&mut sampler), target))
}

/// accuracy T1, against double precision; 4 units in the last place of 1.
#[test]
fn weights_distance_normal_and_point_are_right_to_a_few_last_places() {
    let tolerance = 4.0 * ulp(1.0);
    let whole = scene(triangles(&[RIGHT_ANGLED]));
    for i in 0..256_u16 {
        let [x, y] = [i % 16, i / 16].map(|n| (f32::from(n) + 0.5) / 32.0);
        let ray = toward(Vec3::NEG_Z, vec3(x, y, 0.0));
        let d = ray.direction.as_dvec3();
        let surface = surface(&whole, &ray).unwrap_or_else(|| panic!("{ray:?} misses"));
        let hit = surface.hit;
        for (what, got, exact) in [
            ("t", hit.t, 1.0 / d.z),
            ("u", hit.barycentric.x, d.x / d.z),
            ("v", hit.barycentric.y, d.y / d.z),
            ("x", surface.position.x, d.x / d.z),
            ("y", surface.position.y, d.y / d.z),
            ("z", surface.position.z, 0.0),
        ] {
            let error = (f64::from(got) - exact).abs();
            assert!(error <= tolerance, "{what} = {got} for {exact}, {error:e} off");
        }
        assert_eq!(surface.geometric_normal, Vec3::Z, "the normal of a triangle in z = 0");
    }
}

/// accuracy T6.
#[test]
fn a_point_or_a_segment_is_never_hit() {
    for i in 0..20_000 {
        let ([a, b, _], _) = random_case(i);
        let origin = 3.0 * in_cube(&mut Sampler::new(5, i, 0));
        for corners in [[a, a, a], [a, a, b], [a, b, a], [b, a, a]] {
            for target in [a, b, a.midpoint(b)] {
                let hit = intersect(&toward(origin, target), &corners);
                assert_eq!(hit, None, "{corners:?} from {origin} to {target}");
            }
        }
    }
}

/// accuracy T8, in the three planes in which every coordinate is exact.
#[test]
fn a_ray_in_the_plane_of_a_triangle_misses() {
    for i in 0..20_000 {
        let (corners, ray) = random_case(i);
        for axis in 0..3 {
            let flat = |mut p: Vec3| {
                p[axis] = 0.0;
                p
            };
            let ray = Ray::new(flat(ray.origin), flat(ray.direction));
            let hit = intersect(&ray, &corners.map(flat));
            assert_eq!(hit, None, "{ray:?} within {:?}", corners.map(flat));
        }
    }
}

/// accuracy T9, T10.
#[test]
fn neither_winding_nor_first_corner_changes_the_answer() {
    let mut hits = 0;
    for i in 0..100_000 {
        let ([a, b, c], ray) = random_case(i);
        let hit = intersect(&ray, &[a, b, c]);
        let reversed = intersect(&ray, &[a, c, b]);
        let key = |hit: Option<Hit>| hit.map(|h| h.t.to_bits());
        assert_eq!(key(hit), key(reversed), "case {i}, reversed: {hit:?} and {reversed:?}");
        for turned in [[b, c, a], [c, a, b]] {
            let other = intersect(&ray, &turned);
            let agree = match (hit, other) {
                (None, None) => true,
                (Some(one), Some(two)) => ulps(one.t, f64::from(two.t)) <= 2.0,
                _ => false,
            };
            assert!(agree, "case {i}, turned: {hit:?} and {other:?}");
        }
        hits += usize::from(hit.is_some());
    }
    assert!((20_000..80_000).contains(&hits), "{hits} of 100000 rays hit: the test is one-sided");
}

/// accuracy T11: a triangle as small as it can be seen from there.
#[test]
fn small_and_distant_triangles_are_hit_in_their_middle() {
    for (k, m) in (0..=3).flat_map(|k| (0..=3).map(move |m| (k, m))) {
        let (edge, distance) = (10.0_f32.powi(-k), 10.0_f32.powi(m));
        if edge / (distance * f32::EPSILON / 2.0) < 8.0 {
            continue;
        }
        for i in 0..1000 {
            let mut sampler = Sampler::new(6, i, 0);
            let corners = [(); 3].map(|()| edge * direction(&mut sampler));
            let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
            let ray = toward(
                distance * direction(&mut sampler),
                (corners[0] + corners[1] + corners[2]) / 3.0,
            );
            let slope = exact_normal(corners).dot(ray.direction.as_dvec3()).abs();
            if area < 0.5 * edge * edge || slope < 0.3 {
                continue;
            }
            let hit = intersect(&ray, &corners);
            assert!(hit.is_some(), "edge {edge}, distance {distance}: {ray:?} misses {corners:?}");
        }
    }
}

/// Whatever its size: rounding of the far corners does not hide what lies close by.
#[test]
fn a_wide_floor_is_seen_from_close_above() {
    for exponent in 2..=6 {
        let size = 10.0_f32.powi(exponent);
        let floor =
            [vec3(-size, 0.0, -size), vec3(-size, 0.0, 3.0 * size), vec3(3.0 * size, 0.0, -size)];
        for i in 0..2000 {
            let mut sampler = Sampler::new(6, i, 0);
            let d = in_cube(&mut sampler);
            let origin = vec3(0.5 * size * d.y, 1.0, -0.2 * size * d.x);
            let down = vec3(d.x, -0.2 - 0.8 * d.z.abs(), d.y).normalize();
            let hit = intersect(&Ray::new(origin, down), &floor);
            assert!(hit.is_some(), "floor of {size:e}: {origin} along {down} misses");
        }
    }
}

/// A ray that starts in the corner of a room, next to one wall, meets the other wall.
#[test]
fn a_wall_is_met_from_the_next_float_before_it() {
    let wall = [vec3(2.0, -9.0, -7.0), vec3(2.0, 11.0, -7.0), vec3(2.0, 1.0, 13.0)];
    for i in 0..20_000 {
        let mut sampler = Sampler::new(7, i, 0);
        let d = in_cube(&mut sampler);
        let direction = vec3(0.1 + d.x.abs(), d.y, d.z).normalize();
        let mut x = 2.0_f32;
        for _ in 0..1 + i % 4 {
            x = x.next_down();
        }
        let hit = intersect(&Ray::new(vec3(x, 0.3 * d.z, 0.2 * d.y), direction), &wall);
        assert!(hit.is_some(), "from x = {x} along {direction}");
    }
}

/// accuracy T12: a triangle of the size of an orbit, and a ray that goes on behind it.
#[test]
fn a_huge_triangle_is_hit_once() {
    let (z, span) = (120_000.0, 5.89e11);
    let corners = [vec3(-span, -span, z), vec3(span, -span, z), vec3(0.0, span, z)];
    let scene = scene(triangles(&[corners]));
    let ray = Ray::new(vec3(0.0, 0.0, 120_500.0), Vec3::NEG_Z);
    let surface = surface(&scene, &ray).unwrap_or_else(|| panic!("{ray:?} misses"));
    let error = (f64::from(surface.hit.t) - 500.0).abs();
    assert!(error <= 2.0 * ulp(120_000.0), "t = {} for 500", surface.hit.t);
    let next = intersect(&surface.spawn(ray.direction), &corners);
    assert_eq!(next, None, "the ray that goes on hits it again");
}

/// accuracy T16: a grazing ray on a sliver reports no hit beyond the sliver.
#[test]
fn a_hit_is_no_farther_than_the_farthest_corner() {
    let mut hits = 0;
    for i in 0..200_000 {
        let mut sampler = Sampler::new(7, i, 0);
        let (start, along) = (100.0 * in_cube(&mut sampler), 50.0 * direction(&mut sampler));
        let across = 0.01 * direction(&mut sampler);
        let corners = [start, start + along, start + 0.5 * along + across];
        let target = start + sampler.next_1d() * along + 0.3 * across;
        let beside = 0.0087 * direction(&mut sampler);
        let ray = toward(target - 200.0 * (along.normalize() + beside), target);
        let Some(hit) = intersect(&ray, &corners) else { continue };
        hits += 1;
        let farthest = corners.map(|v| v.as_dvec3().distance(ray.origin.as_dvec3()));
        let farthest = farthest.into_iter().fold(0.0, f64::max);
        let limit = farthest * (1.0 + f64::from(gamma(7)));
        assert!(f64::from(hit.t) <= limit, "case {i}: t = {} beyond {farthest}", hit.t);
    }
    assert!(hits > 10_000, "only {hits} rays hit");
}

/// accuracy T17: every number here is a small binary fraction, so nothing is rounded, and corners
/// and edges are hit exactly.
#[test]
fn all_axes_and_signs_are_alike() {
    const ORDERS: [[usize; 3]; 6] =
        [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let corners = [vec3(-0.5, -1.0, 1.0), vec3(1.0, -0.25, 0.5), vec3(-0.25, 1.0, -0.5)];
    let weights = [0.0, 0.25, 0.5, 0.75, 1.0, -0.25];
    let cases = [vec3(1.0, 1.0, 1.0), vec3(1.0, 1.0, 0.0), vec3(1.0, 0.0, 0.0)];
    for d in cases {
        for (b1, b2) in weights.iter().flat_map(|&b1| weights.map(|b2| (b1, b2))) {
            let target =
                corners[0] + b1 * (corners[1] - corners[0]) + b2 * (corners[2] - corners[0]);
            let inside = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
            for (order, signs) in ORDERS.iter().flat_map(|o| (0..8).map(move |s| (o, s))) {
                let turned = |p: Vec3| {
                    let sign = |i: usize| if signs >> i & 1 == 1 { -1.0 } else { 1.0 };
                    Vec3::from_array([0, 1, 2].map(|i| sign(i) * p[order[i]]))
                };
                let ray = Ray::new(turned(target - 4.0 * d), turned(d));
                let hit = intersect(&ray, &corners.map(turned));
                let case = format!("d = {d}, weights {b1} and {b2}, {order:?}, signs {signs:03b}");
                assert_eq!(hit.is_some(), inside, "{case}");
                let t = hit.map_or(4.0, |hit| hit.t);
                assert!(ulps(t, 4.0) <= 1.0, "t = {t} for 4: {case}");
            }
        }
    }
}

/// accuracy T18.
#[test]
fn a_corner_that_is_not_finite_is_never_hit() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for i in 0..2_000 {
            let (corners, ray) = random_case(i);
            for (corner, axes) in (0..3).flat_map(|corner| (1..8).map(move |axes| (corner, axes))) {
                let mut corners = corners;
                for axis in (0..3).filter(|axis| axes >> axis & 1 == 1) {
                    corners[corner][axis] = bad;
                }
                for direction in [ray.direction, Vec3::X, Vec3::Y, Vec3::NEG_Z] {
                    let ray = Ray::new(ray.origin, direction);
                    assert_eq!(intersect(&ray, &corners), None, "{ray:?} on {corners:?}");
                }
            }
        }
    }
}

/// The rule of `Ray::extent`, min < t ≤ max, at a hit whose t is exactly 1.
#[test]
fn a_hit_counts_up_to_the_far_end_and_not_at_the_near_one() {
    let ray = |min, max| Ray {
        extent: Interval::new(min, max),
        ..Ray::new(vec3(0.25, 0.25, -1.0), Vec3::Z)
    };
    let (below, above) = (1.0_f32.next_down(), 1.0_f32.next_up());
    for (min, max, counts) in
        [(0.0, 1.0, true), (0.0, below, false), (1.0, 2.0, false), (below, above, true)]
    {
        let hit = intersect(&ray(min, max), &RIGHT_ANGLED);
        assert_eq!(hit.is_some(), counts, "extent ({min}, {max}]: {hit:?}");
    }
}

/// accuracy T15: the tilted triangle lies a rounding ahead of the origin, at t = 0.0027. Moving its
/// corners by a rounding puts it behind, by more than one rounding, since they lie far aside.
#[test]
fn a_tilted_wall_is_met_from_a_few_floats_before_it() {
    let corners = [
        [0xc550_c1e0, 0xc54c_73be, 0x45a8_8b83],
        [0xc52a_9da6, 0xc53b_b268, 0xc549_695d],
        [0x441f_c512, 0xc640_f6af, 0x4568_2377],
    ];
    let origin = bits([0xc510_0d3e, 0xc599_b106, 0x44a9_970a]);
    let ray = Ray::new(origin, bits([0xbe37_96ef, 0x3e7d_6492, 0x3f73_c13f]));
    let hit = intersect(&ray, &corners.map(bits));
    assert!(hit.is_some(), "{ray:?} leaves through the wall");
    let back = Ray::new(origin, -ray.direction);
    let hit = intersect(&back, &corners.map(bits));
    assert_eq!(hit, None, "{back:?} leads away from the wall");
}

/// accuracy T13: a ray from one point of a triangle to another, but for roundings. It starts on one
/// side and leads, by 5 u, to the other.
#[test]
fn a_ray_toward_a_point_of_the_same_plane_does_not_meet_it() {
    let corners = [
        [0x4348_2785, 0xb807_8376, 0xb4b1_2274],
        [0x377a_f24a, 0x4814_1e32, 0x49af_6a45],
        [0xca59_73fb, 0x37e7_8dee, 0xb523_b807],
    ];
    let origin = bits([0xc92a_6851, 0x4636_8046, 0x47d8_228a]);
    let ray = Ray {
        extent: Interval::new(0.0, 706_803.4),
        ..Ray::new(origin, bits([0x3f7c_ceb9, 0xbc87_5fdb, 0xbe20_52ba]))
    };
    let hit = intersect(&ray, &corners.map(bits));
    assert_eq!(hit, None, "{ray:?}");
}

/// accuracy T13: a needle 5·10⁷ long and 0.07 wide. The ray starts on the side to which it leads.
#[test]
fn a_ray_that_leaves_a_long_needle_does_not_meet_it() {
    let corners = [
        [0x4c56_3979, 0x4aa9_e105, 0xc74c_426e],
        [0x3b1c_3367, 0xbd6f_54b3, 0x3bb9_71ee],
        [0xbc41_5804, 0x3c66_3c6e, 0x374d_bedd],
    ];
    let origin = bits([0x4825_b7fc, 0x4683_69ed, 0xc31e_014a]);
    let ray = Ray::new(origin, bits([0xbe9e_fa6a, 0xbf72_4f0e, 0x3db3_9610]));
    let hit = intersect(&ray, &corners.map(bits));
    assert_eq!(hit, None, "{ray:?}");
}

/// accuracy B9: seen along its plane, the triangle seems to be met a rounding behind the origin, but
/// the exact plane is met ahead, far beside the triangle, and no box of it holds the origin.
#[test]
fn a_hit_is_put_forward_only_where_the_plane_is_met() {
    let corners = [
        vec3(0.008_249_67, -0.005_997_126_5, 0.008_708_856),
        vec3(0.007_825_632, -0.003_844_774_6, 0.009_337_152),
        vec3(0.007_825_286, -0.000_474_532_1, 0.009_307_008),
    ];
    let origin = bits([0x3c00_2dfd, 0xbaf4_d2ad, 0x3c18_bd48]);
    let ray = Ray::new(origin, bits([0xbeba_f43d, 0x3f40_155f, 0x3f0d_130b]));
    let hit = intersect(&ray, &corners);
    assert_eq!(hit, None, "{ray:?} starts beside the triangle and leads away from it");
}

/// A vector from the bits of its components.
fn bits(v: [u32; 3]) -> Vec3 {
    Vec3::from_array(v.map(f32::from_bits))
}
