//! k-DOPs: nested, and tighter with every direction.

use bv_tree::{Aabb, BoundingVolume, KDop};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Ray};
use workbench::Sampler;

use crate::tools::{Enclosed, in_cube, toward, triangles};

/// The four k-DOPs and the box around the same content.
struct Nest {
    aabb: Enclosed<Aabb>,
    k6: Enclosed<KDop<3>>,
    k14: Enclosed<KDop<7>>,
    k18: Enclosed<KDop<9>>,
    k26: Enclosed<KDop<13>>,
}

impl Nest {
    fn around(geometry: &Geometry) -> Self {
        Self {
            aabb: Enclosed::all_of(geometry),
            k6: Enclosed::all_of(geometry),
            k14: Enclosed::all_of(geometry),
            k18: Enclosed::all_of(geometry),
            k26: Enclosed::all_of(geometry),
        }
    }

    /// Which of them the ray meets: the box, then k = 6, 14, 18, 26.
    fn met(&self, ray: &Ray) -> [bool; 5] {
        [
            !self.aabb.clip(ray).is_empty(),
            !self.k6.clip(ray).is_empty(),
            !self.k14.clip(ray).is_empty(),
            !self.k18.clip(ray).is_empty(),
            !self.k26.clip(ray).is_empty(),
        ]
    }
}

fn random_content(sampler: &mut Sampler) -> Geometry {
    let corners: Vec<[Vec3; 3]> = (0..3).map(|_| [(); 3].map(|()| in_cube(sampler))).collect();
    triangles(&corners)
}

/// accuracy K1, K2. The 6-DOP is rounded outward once more than the box, so it may be met by a ray
/// that touches the box's edge from outside, but not the other way round.
#[test]
fn polytopes_are_nested_and_the_first_is_the_box() {
    let (mut differ, mut met) = (0, [0; 5]);
    for i in 0..2000 {
        let mut sampler = Sampler::new(6, i, 0);
        let nest = Nest::around(&random_content(&mut sampler));
        for _ in 0..50 {
            let ray = toward(3.0 * in_cube(&mut sampler), in_cube(&mut sampler));
            let [aabb, k6, k14, k18, k26] = nest.met(&ray);
            let nested = k6 >= (aabb || k14 || k18) && (k14 && k18) >= k26;
            assert!(nested, "case {i}, {ray:?}: {:?}", nest.met(&ray));
            differ += u32::from(aabb != k6);
            for (count, met) in met.iter_mut().zip(nest.met(&ray)) {
                *count += u32::from(met);
            }
        }
    }
    assert!(differ <= 2, "of 100000 rays, {differ} meet a box and not its 6-DOP, or vice versa");
    let [_, k6, k14, k18, k26] = met;
    assert!(k26 < k18 && k26 < k14 && k14 < k6 && k18 < k6, "rays that meet them: {met:?}");
}

/// accuracy K3: a ray parallel to the slab x + y, on its plane and beside it.
#[test]
fn a_ray_along_an_oblique_face_is_inside() {
    let wedge = triangles(&[[Vec3::X, Vec3::Y, vec3(0.5, 0.5, 1.0)]]);
    let nest = Nest::around(&wedge);
    for (offset, met) in [(0.0, true), (0.25, false), (-0.25, false)] {
        for zero in [0.0, -0.0] {
            let origin = vec3(-1.0 + offset, 2.0, 0.25);
            let ray = Ray::new(origin, vec3(1.0, -1.0, zero));
            let inside = nest.k18.clip(&ray);
            assert!(!inside.min.is_nan() && !inside.max.is_nan(), "{inside:?}");
            assert_eq!(!inside.is_empty(), met, "x + y = {}: {inside:?}", 1.0 + offset);
        }
    }
}

/// accuracy K5: of the rays that miss a ball, fewer meet a polytope of more faces.
#[test]
fn more_faces_are_met_in_vain_less_often() {
    let mesh = generator::blob(12);
    let ball = Geometry {
        vertices: mesh.positions.iter().map(|&p| Vec3::from_array(p)).collect(),
        triangles: mesh.triangles,
        spheres: Vec::new(),
    };
    let nest = Nest::around(&ball);
    let radius = ball.vertices.iter().map(|v| v.length()).fold(0.0, f32::max);
    let (mut vain, mut rays) = ([0_u32; 5], 0_u32);
    for i in 0..50_000 {
        let mut sampler = Sampler::new(7, i, 0);
        let ray = toward(3.0 * in_cube(&mut sampler), 1.5 * in_cube(&mut sampler));
        let nearest = ray.origin - ray.origin.dot(ray.direction) * ray.direction;
        if nearest.length() <= radius || ray.origin.length() <= 2.0 {
            continue;
        }
        rays += 1;
        for (count, met) in vain.iter_mut().zip(nest.met(&ray)) {
            *count += u32::from(met);
        }
    }
    let [aabb, k6, k14, k18, k26] = vain;
    assert!(aabb == k6 && k6 > k14 && k14 > k26 && k6 > k18 && k18 > k26, "{vain:?} of {rays}");
}

/// The box around a polytope stands in for its area.
#[test]
fn the_area_of_a_polytope_is_that_of_its_box() {
    let mut sampler = Sampler::new(8, 0, 0);
    let nest = Nest::around(&random_content(&mut sampler));
    let expected = nest.aabb.volume.surface_area();
    for area in [nest.k6.volume.surface_area(), nest.k26.volume.surface_area()] {
        assert!((area - expected).abs() <= 1e-5 * expected, "{area} for {expected}");
    }
}
