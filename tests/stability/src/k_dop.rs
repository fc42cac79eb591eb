//! k-DOPs: K1 to K6.

use bv_tree::{Aabb, BoundingVolume, KDop};
use glam::Vec3;
use ray_casting::{Geometry, Interval, Ray};

use crate::bits;
use crate::random::Random;
use crate::trial::Trial;
use crate::volumes::{Enclosed, aimed, content, encloses, hits};

crate::catalogue! {
    K1 random/4 a_polytope_of_six_faces_is_the_box_one_float_wider;
    K2 random/4 polytopes_lie_in_those_of_fewer_directions;
    K3 elsewhere "chapters/04-bv-tree/tests/volumes/polytopes.rs"
        a_ray_along_an_oblique_face_is_inside;
    K4 random/16 no_ray_to_a_point_inside_misses_a_polytope;
    K5 elsewhere "chapters/04-bv-tree/tests/volumes/polytopes.rs"
        more_faces_are_met_in_vain_less_often;
    K6 random/32 what_encloses_both_is_met_where_either_is;
}

/// Rays for each content.
const PER_CONTENT: u64 = 16;

/// The size of a box.
fn size(bounds: &Aabb) -> f64 {
    f64::from((bounds.max - bounds.min).max_element())
}

/// The content with spheres left out: their extents are rounded once for the box and twice for a
/// polytope.
fn flat_content(random: &mut Random) -> Geometry {
    Geometry { spheres: Vec::new(), ..content(random) }
}

fn ends(interval: Interval) -> [u32; 2] {
    [interval.min.to_bits(), interval.max.to_bits()]
}

/// For k = 6 the extents are those of the box, which are exact, rounded outward by one float all the
/// same; so the interval has the bits of that of a box whose faces are one float farther out.
fn a_polytope_of_six_faces_is_the_box_one_float_wider(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_CONTENT) {
        let geometry = flat_content(&mut trial.random);
        let polytope = Enclosed::<KDop<3>>::all_of(&geometry);
        let Aabb { min, max } = polytope.bounds;
        let wider = Aabb {
            min: Vec3::from_array(min.to_array().map(f32::next_down)),
            max: Vec3::from_array(max.to_array().map(f32::next_up)),
        };
        let wider = Enclosed::new(wider, polytope.bounds);
        for _ in 0..PER_CONTENT {
            let ray = aimed(&geometry, size(&polytope.bounds), &mut trial.random).ray;
            let (six, four) = (polytope.clip(&ray), wider.clip(&ray));
            trial.require(ends(six) == ends(four) && !six.min.is_nan(), || {
                format!("{six:?} for {four:?}: {}\n{geometry:?}", bits::ray(&ray))
            });
        }
    }
}

/// The slabs of k = 6 are among those of 14, 18 and 26, and all of those of 14 and of 18 among those
/// of 26: an interval lies in that of fewer slabs, with no rounding in between.
fn polytopes_lie_in_those_of_fewer_directions(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_CONTENT) {
        let geometry = content(&mut trial.random);
        let k6 = Enclosed::<KDop<3>>::all_of(&geometry);
        let k14 = Enclosed::<KDop<7>>::all_of(&geometry);
        let k18 = Enclosed::<KDop<9>>::all_of(&geometry);
        let k26 = Enclosed::<KDop<13>>::all_of(&geometry);
        for _ in 0..PER_CONTENT {
            let ray = aimed(&geometry, size(&k6.bounds), &mut trial.random).ray;
            let nest = [k6.clip(&ray), k14.clip(&ray), k18.clip(&ray), k26.clip(&ray)];
            for (inner, outer) in [(1, 0), (2, 0), (3, 0), (3, 1), (3, 2)] {
                let holds = lies_in(nest[inner], nest[outer]);
                trial.require(holds, || {
                    format!("{inner} in {outer} of {nest:?}: {}\n{geometry:?}", bits::ray(&ray))
                });
            }
        }
    }
}

/// Whether all of `inner` lies in `outer`; false where an end is not a number.
fn lies_in(inner: Interval, outer: Interval) -> bool {
    let is_empty = inner.min > inner.max;
    is_empty || (outer.min <= inner.min && inner.max <= outer.max)
}

/// Content of any shape, and rays aimed at it: no hit, and no point that a ray passes as near as
/// rounding can tell, is outside, neither of a polytope nor of the box.
fn no_ray_to_a_point_inside_misses_a_polytope(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_CONTENT) {
        let geometry = content(&mut trial.random);
        let aabb = Enclosed::<Aabb>::all_of(&geometry);
        let k6 = Enclosed::<KDop<3>>::all_of(&geometry);
        let k14 = Enclosed::<KDop<7>>::all_of(&geometry);
        let k18 = Enclosed::<KDop<9>>::all_of(&geometry);
        let k26 = Enclosed::<KDop<13>>::all_of(&geometry);
        for _ in 0..PER_CONTENT {
            let aimed = aimed(&geometry, size(&aabb.bounds), &mut trial.random);
            let hits = hits(&geometry, &aimed.ray);
            encloses(trial, &geometry, &aabb, &aimed, &hits);
            encloses(trial, &geometry, &k6, &aimed, &hits);
            encloses(trial, &geometry, &k14, &aimed, &hits);
            encloses(trial, &geometry, &k18, &aimed, &hits);
            encloses(trial, &geometry, &k26, &aimed, &hits);
        }
    }
}

/// The course merges boxes, and fits polytopes to all that lies in both. Either way, what is around
/// two contents contains what is around one of them, bit for bit; and nothing adds nothing.
fn what_encloses_both_is_met_where_either_is(trial: &mut Trial) {
    for _ in 0..trial.rays.div_ceil(PER_CONTENT) {
        let [first, second] = [(); 2].map(|()| flat_content(&mut trial.random));
        merged::<Aabb>(trial, &first, &second);
        merged::<KDop<3>>(trial, &first, &second);
        merged::<KDop<7>>(trial, &first, &second);
        merged::<KDop<9>>(trial, &first, &second);
        merged::<KDop<13>>(trial, &first, &second);
    }
}

fn merged<V: BoundingVolume>(trial: &mut Trial, first: &Geometry, second: &Geometry) {
    let whole = Enclosed::<V>::all_of(&joined(first, second));
    for part in [first, second] {
        let own = Enclosed::<V>::all_of(part);
        let union = own.bounds.union(&whole.bounds);
        let neutral = own.bounds.union(&Aabb::EMPTY);
        trial.require(union == whole.bounds && neutral == own.bounds, || {
            format!("{:?} and {:?}", own.bounds, whole.bounds)
        });
        let far = size(&own.bounds);
        // Seen with the reach of the whole, as in a tree.
        let own = Enclosed::new(own.volume, whole.bounds);
        let nothing = Enclosed::new(V::EMPTY, whole.bounds);
        for _ in 0..PER_CONTENT / 2 {
            let ray = aimed(part, far, &mut trial.random).ray;
            let [inner, outer] = [own.clip(&ray), whole.clip(&ray)];
            let holds = lies_in(inner, outer) && nothing_is_met(&nothing, &ray);
            trial.require(holds, || {
                format!("{inner:?} in {outer:?}: {}\n{first:?}\n{second:?}", bits::ray(&ray))
            });
        }
    }
}

/// Whether the ray passes what is around nothing.
fn nothing_is_met<V: BoundingVolume>(nothing: &Enclosed<V>, ray: &Ray) -> bool {
    let inside = nothing.clip(ray);
    inside.min > inside.max
}

/// The triangles of both.
fn joined(first: &Geometry, second: &Geometry) -> Geometry {
    let mut all = first.clone();
    let moved = first.vertices.len() as u32;
    all.vertices.extend(&second.vertices);
    all.triangles.extend(second.triangles.iter().map(|corners| corners.map(|i| i + moved)));
    all
}
