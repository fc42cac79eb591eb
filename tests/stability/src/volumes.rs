//! Bounding volumes around given content, rays that are hard to answer, and trees of any kind.

use std::any::type_name;

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, FourIntervals, Item, KDop, Obb, Shape};
use glam::DVec3;
use ray_casting::{Geometry, Hit, Intersect, Interval, Ray, ShearedRay, Sphere};
use workbench::Unwatched;

use crate::bits::{self, gamma};
use crate::random::Random;
use crate::scenes::toward;
use crate::trial::Trial;

/// A volume, alone and among four, and the box around what it encloses.
#[derive(Clone, Copy, Debug)]
pub struct Enclosed<V: BoundingVolume> {
    /// The volume itself.
    pub volume: V,
    /// The box.
    pub bounds: Aabb,
    /// It in the places 0 and 2; nothing in the others.
    four: V::Four,
}

impl<V: BoundingVolume> Enclosed<V> {
    /// The volume around everything in `geometry`, as a tree makes it.
    #[must_use]
    pub fn all_of(geometry: &Geometry) -> Self {
        let items = Item::all(geometry);
        let bounds = items.iter().fold(Aabb::EMPTY, |all, item| all.union(&item.bounds));
        Self::new(V::enclosing(&bounds, &items, geometry), bounds)
    }

    /// A volume at hand.
    #[must_use]
    pub fn new(volume: V, bounds: Aabb) -> Self {
        Self { volume, bounds, four: V::four(&[volume, V::EMPTY, volume, V::EMPTY]) }
    }

    /// The t for which the ray is inside.
    ///
    /// As a tree asks, four volumes at a time, and as the book says, one alone. If the two differ in
    /// any bit, or an empty place is entered, the ends are NaN, and no t is inside.
    #[must_use]
    pub fn clip(&self, ray: &Ray) -> Interval {
        let query = V::query(ray, self.bounds.reach(ray.origin));
        let alone = self.volume.clip(&query);
        let FourIntervals { min, max } = V::clip_four(&self.four, &query);
        let is_same = |i: usize| {
            min[i].to_bits() == alone.min.to_bits() && max[i].to_bits() == alone.max.to_bits()
        };
        let is_empty = |i: usize| Interval::new(min[i], max[i]).is_empty();
        let agree = is_same(0) && is_empty(1) && is_same(2) && is_empty(3);
        if agree { alone } else { Interval::new(f32::NAN, f32::NAN) }
    }
}

/// One to six triangles and spheres near each other: round, flat, long, along the axes or not; of any
/// size, and up to 10⁷ times as far from the origin as they are large, where the boxes of spheres,
/// and all oblique planes, round to other floats than the exact ones.
#[must_use]
pub fn content(random: &mut Random) -> Geometry {
    let count = 1 + random.below(4);
    let decades = if random.below(8) == 0 { [-44.0, 30.0] } else { [-6.0, 6.0] };
    let scale = random.magnitude(decades[0], decades[1]);
    cluster(count, scale, random)
}

/// The same with `count` triangles, of this size.
#[must_use]
pub fn cluster(count: u64, scale: f64, random: &mut Random) -> Geometry {
    let far = [0.0, random.magnitude(-1.0, 7.0)][random.below(2) as usize];
    let center = scale * far * random.direction();
    let thin = random.magnitude(-7.0, 0.0);
    let stretch = scale
        * match random.below(5) {
            0 => DVec3::new(1.0, 1.0, 0.0),
            1 => DVec3::new(thin, 1.0, thin),
            2 => DVec3::new(0.0, 0.0, 1.0),
            3 => DVec3::new(1.0, thin, 1.0),
            _ => DVec3::ONE,
        };
    let frame = if random.below(2) == 0 { DVec3::AXES } else { some_frame(random) };
    let point = |random: &mut Random| {
        let p = stretch * random.in_cube();
        center + p.x * frame[0] + p.y * frame[1] + p.z * frame[2]
    };
    let mut geometry = Geometry::default();
    for i in 0..count as u32 {
        geometry.vertices.extend([(); 3].map(|()| point(random).as_vec3()));
        geometry.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    if random.below(3) == 0 {
        for _ in 0..1 + random.below(2) {
            let radius = (scale * random.magnitude(-3.0, 0.0)) as f32;
            geometry.spheres.push(Sphere { center: point(random).as_vec3(), radius });
        }
    }
    geometry
}

/// Three unit vectors at right angles.
#[must_use]
pub fn some_frame(random: &mut Random) -> [DVec3; 3] {
    let first = random.direction();
    let second = first.any_orthonormal_vector();
    let third = first.cross(second);
    let [c, s] = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
    let turned = (c * second + s * third).normalize_or(second);
    [first, turned, first.cross(turned)]
}

/// A ray that is aimed at a point inside.
#[derive(Clone, Copy, Debug)]
pub struct Aimed {
    /// The ray.
    pub ray: Ray,
    /// The point.
    pub target: DVec3,
}

/// A ray for `geometry`: to a corner, along an edge, through a face, to the outline of a sphere, or to
/// a point between two of those; along an axis, a diagonal, nearly along them, within a face, or anyhow;
/// from close by or from afar; of any length; with the near end of its extent at 0 or about the target.
#[must_use]
pub fn aimed(geometry: &Geometry, size: f64, random: &mut Random) -> Aimed {
    let mut target = point_of(geometry, random);
    if random.below(4) == 0 {
        target = target.lerp(point_of(geometry, random), random.unit());
    }
    let mut way = random.direction();
    match random.below(8) {
        0 => way = DVec3::AXES[random.below(3) as usize] * (1.0_f64).copysign(way.x),
        1 => way[random.below(3) as usize] *= random.magnitude(-45.0, -5.0),
        2 => way[random.below(3) as usize] = 0.0_f64.copysign(way.x),
        3 => way = way.signum() * [DVec3::ONE, DVec3::new(1.0, 1.0, 0.0)][random.below(2) as usize],
        4 => way = (point_of(geometry, random) - target).normalize_or(way),
        _ => {}
    }
    let away = size * random.magnitude(-3.0, 4.0);
    let origin = random.beside_point((target - away * way).as_vec3());
    let mut ray = Ray::new(origin, way.as_vec3());
    if random.below(2) == 0 {
        ray = toward(origin, target.as_vec3()).unwrap_or(ray);
    }
    // Of long directions the smallest t is a long way: content must not be smaller than that.
    if random.below(4) == 0 && size > 1e-30 {
        ray.direction *= random.magnitude(-3.0, 3.0) as f32;
    }
    if random.below(8) == 0 {
        let t = origin.as_dvec3().distance(target) / ray.direction.as_dvec3().length();
        ray.extent.min = random.beside(t as f32);
    }
    Aimed { ray, target }
}

/// A point of the content, where it is easily missed.
fn point_of(geometry: &Geometry, random: &mut Random) -> DVec3 {
    let primitive = random.below(u64::from(geometry.primitives())) as u32;
    if let Some(sphere) = geometry.sphere(primitive) {
        let mut normal = random.direction();
        match random.below(4) {
            0 => normal = DVec3::AXES[random.below(3) as usize] * (1.0_f64).copysign(normal.x),
            1 => normal = normal.signum().normalize(),
            2 => normal = (normal.signum() * DVec3::new(1.0, 1.0, 0.0)).normalize(),
            _ => {}
        }
        return sphere.center.as_dvec3() + f64::from(sphere.radius) * normal;
    }
    let [a, b, c] = geometry.corners(primitive).map(|v| v.as_dvec3());
    let edge = a.lerp(b, random.unit());
    match random.below(3) {
        0 => a,
        1 => edge,
        _ => edge.lerp(c, random.unit()),
    }
}

/// The hits of `ray` on each primitive by itself.
#[must_use]
pub fn hits(geometry: &Geometry, ray: &Ray) -> Vec<Hit> {
    let prepared = ShearedRay::new(ray);
    (0..geometry.primitives()).filter_map(|i| geometry.intersect_primitive(&prepared, i)).collect()
}

/// Requires of a volume what a tree relies on: that it contains the t of all `hits`; and what that is
/// built on, without the primitives' own tests and in double precision: that it contains the t at
/// which the ray passes its target nearest, if that is as near as such a test may be wrong, γ(6) of
/// the reach for each axis.
pub fn encloses<V: BoundingVolume>(
    trial: &mut Trial,
    geometry: &Geometry,
    volume: &Enclosed<V>,
    aimed: &Aimed,
    hits: &[Hit],
) {
    let Aimed { ray, target } = aimed;
    let inside = volume.clip(ray);
    let case = || format!("{}: {inside:?}, {}\n{geometry:?}", type_name::<V>(), bits::ray(ray));
    for hit in hits {
        trial.require(inside.contains(hit.t), || format!("{hit:?} outside of {}", case()));
    }
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let t = (target - o).dot(d) / d.length_squared();
    let beside = (o + t * d - target).abs().max_element();
    let reach = f64::from(volume.bounds.reach(ray.origin));
    if t >= 0.0 && beside <= gamma(6) * reach {
        let contains = f64::from(inside.min) <= t && t <= f64::from(inside.max);
        trial.require(contains, || format!("{target} at t = {t:e} outside of {}", case()));
    }
}

/// A tree, whatever encloses its nodes.
pub struct AnyTree {
    /// The volume and the builder.
    pub name: String,
    /// How large it has become.
    pub shape: Shape,
    /// The tree itself.
    pub search: Box<dyn Intersect>,
}

/// How many kinds of volumes there are.
pub const VOLUMES: u64 = 6;

/// A tree over `geometry` with the volume number `volume`, by either builder.
#[must_use]
pub fn tree(geometry: &Geometry, volume: u64, builder: Builder) -> AnyTree {
    match volume {
        0 => any::<Aabb>(geometry, builder),
        1 => any::<Obb>(geometry, builder),
        2 => any::<KDop<3>>(geometry, builder),
        3 => any::<KDop<7>>(geometry, builder),
        4 => any::<KDop<9>>(geometry, builder),
        _ => any::<KDop<13>>(geometry, builder),
    }
}

/// A tree of any kind.
#[must_use]
pub fn some_tree(geometry: &Geometry, random: &mut Random) -> AnyTree {
    tree(geometry, random.below(VOLUMES), some_builder(random))
}

/// Either builder.
#[must_use]
pub fn some_builder(random: &mut Random) -> Builder {
    [Builder::Median, Builder::Sah][random.below(2) as usize]
}

fn any<V: BoundingVolume>(geometry: &Geometry, builder: Builder) -> AnyTree {
    let tree = BvTree::<V, _>::build(geometry, builder, &Unwatched);
    AnyTree {
        name: format!("{}, {builder:?}", type_name::<V>()),
        shape: tree.shape(),
        search: Box::new(tree),
    }
}

/// What two searches must agree on.
#[must_use]
pub fn hit_bits(hit: Option<Hit>) -> Option<(u32, u32, [u32; 2])> {
    hit.map(|h| (h.primitive, h.t.to_bits(), h.barycentric.to_array().map(f32::to_bits)))
}
