//! Spheres, and roots that do not cancel.

use glam::{DVec3, Vec3};

use crate::ray::Ray;

/// The points at distance `radius` from `center`. Its front is the outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// **c**, in scene units.
    pub center: Vec3,
    /// r > 0, in scene units. A sphere of any other radius is never hit.
    pub radius: f32,
}

impl Sphere {
    // ANCHOR: intersect
    /// The smallest t that `ray` admits on the sphere.
    ///
    /// With **f** = **o** − **c**, the points **o** + t **d** of the sphere solve
    ///
    /// ```text
    /// a t² − 2 b t + c = 0,    a = d·d,   b = −f·d,   c = f·f − r²
    /// ```
    ///
    /// The school formula t = (b ± √(b² − a c)) / a loses digits twice: in b² − a c when the sphere
    /// is small or far away, and in b − √… when c is small beside b². Both are avoided
    /// \[Haines19]: **l** = **f** + (b/a) **d** reaches from the centre to the ray, so
    ///
    /// ```text
    /// b² − a c = a (r² − l·l),    q = b + sign(b) √(a (r² − l·l)),    t = c/q  or  t = q/a
    /// ```
    ///
    /// c still cancels for an eye just above a large ground sphere, hence double precision inside.
    /// A ray that only touches (r² = l·l) counts as a hit. [`intersect_naive`] is the school
    /// formula.
    #[inline]
    #[must_use]
    pub fn intersect(&self, ray: &Ray) -> Option<f32> {
        let d = ray.direction.as_dvec3();
        let f = ray.origin.as_dvec3() - self.center.as_dvec3();
        let r = f64::from(self.radius);

        let a = d.dot(d);
        let b = -f.dot(d);
        let l: DVec3 = f + (b / a) * d;
        let discriminant = a * (r * r - l.dot(l));
        let meets = discriminant >= 0.0 && r > 0.0;
        if !meets {
            return None;
        }

        let q = b + discriminant.sqrt().copysign(b);
        let c = f.dot(f) - r * r;
        let (t0, t1) = ((c / q) as f32, (q / a) as f32);
        let (near, far) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
        [near, far].into_iter().find(|&t| ray.admits(t) && t < f32::INFINITY)
    }
    // ANCHOR_END: intersect
}

// ANCHOR: intersect_naive
/// The school formula in single precision, kept to show what it gets wrong.
///
/// At distance 10⁴ from a unit sphere its t can be a thousand units in the last place off.
#[must_use]
pub fn intersect_naive(sphere: &Sphere, ray: &Ray) -> Option<f32> {
    let f = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = -f.dot(ray.direction);
    let c = f.dot(f) - sphere.radius * sphere.radius;
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    [(b - root) / a, (b + root) / a].into_iter().find(|&t| ray.admits(t))
}
// ANCHOR_END: intersect_naive

#[cfg(test)]
mod tests {
    use super::{Sphere, intersect_naive};
    use crate::ray::Ray;
    use glam::{Vec3, vec3};

    const UNIT: Sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };

    fn ulps(a: f32, b: f64) -> f64 {
        let spacing = f64::from(a.abs().next_up() - a.abs());
        (f64::from(a) - b).abs() / spacing
    }

    /// accuracy S1, S2.
    #[test]
    fn a_head_on_hit_is_exact_for_directions_of_any_length() {
        for k in -20..=20 {
            let scale = f32::powi(2.0, k);
            let ray = Ray::new(vec3(0.0, 0.0, -3.0), vec3(0.0, 0.0, scale));
            assert_eq!(UNIT.intersect(&ray), Some(2.0 / scale), "direction of length 2^{k}");
        }
    }

    /// accuracy S3: the naive formula loses hundreds of units, the stable one less than one.
    #[test]
    fn a_distant_sphere_is_hit_to_the_last_place_and_the_school_formula_is_not() {
        let mut worst_naive = 0.0_f64;
        for distance in [1e1_f32, 1e2, 1e3, 4096.0, 1e4, 1e5, 1e6, 1e7] {
            let ray = Ray::new(vec3(0.3, 0.4, -distance), Vec3::Z);
            let (x, y) = (f64::from(0.3_f32), f64::from(0.4_f32));
            let exact = f64::from(distance) - (1.0 - x * x - y * y).sqrt();
            let error = UNIT.intersect(&ray).map(|t| ulps(t, exact));
            assert!(error.is_some_and(|e| e <= 1.0), "D = {distance}: {error:?} ULP");
            let naive = intersect_naive(&UNIT, &ray).map_or(0.0, |t| ulps(t, exact));
            worst_naive = worst_naive.max(naive);
        }
        assert!(worst_naive > 100.0, "the naive formula is only {worst_naive} ULP off");
    }

    /// accuracy S4, S5: grazing rays are decided exactly, and touching counts.
    #[test]
    fn grazing_rays_hit_inside_and_miss_outside() {
        for k in 4..=22 {
            let step = f32::powi(2.0, -k);
            let hit = UNIT.intersect(&Ray::new(vec3(-10.0, 1.0 - step, 0.0), Vec3::X));
            let miss = UNIT.intersect(&Ray::new(vec3(-10.0, 1.0 + step, 0.0), Vec3::X));
            let s = f64::from(step);
            let exact = 10.0 - (2.0 * s - s * s).sqrt();
            assert!(hit.is_some_and(|t| ulps(t, exact) <= 1.0), "k = {k}: {hit:?} for {exact}");
            assert_eq!(miss, None, "k = {k}: a ray beside the sphere");
        }
        let touching = UNIT.intersect(&Ray::new(vec3(-10.0, 1.0, 0.0), Vec3::X));
        assert_eq!(touching, Some(10.0), "an exact tangent");
    }

    /// accuracy S7, S8, S10.
    #[test]
    fn rays_from_inside_and_from_the_surface_find_the_other_side() {
        let from = |z: f32, d: Vec3| UNIT.intersect(&Ray::new(vec3(0.0, 0.0, z), d));
        assert_eq!(from(0.5, Vec3::Z), Some(0.5), "inside, forward");
        assert_eq!(from(0.5, Vec3::NEG_Z), Some(1.5), "inside, backward");
        assert_eq!(from(1.0, Vec3::Z), None, "on the surface, leaving");
        assert_eq!(from(1.0, Vec3::NEG_Z), Some(2.0), "on the surface, entering");
        assert_eq!(from(1.0, Vec3::X), None, "on the surface, along it");
        assert_eq!(from(3.0, Vec3::Z), None, "the sphere is behind");
    }

    /// accuracy S13, S14.
    #[test]
    fn what_is_not_a_sphere_or_not_a_ray_is_never_hit() {
        let ray = Ray::new(vec3(0.0, 0.0, -3.0), Vec3::Z);
        for radius in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            let sphere = Sphere { radius, ..UNIT };
            assert_eq!(sphere.intersect(&ray), None, "radius {radius}");
        }
        for (origin, direction) in [
            (ray.origin, Vec3::ZERO),
            (ray.origin, Vec3::NAN),
            (Vec3::INFINITY, Vec3::Z),
            (Vec3::NAN, Vec3::Z),
        ] {
            let hit = UNIT.intersect(&Ray::new(origin, direction));
            assert_eq!(hit, None, "from {origin} along {direction}");
        }
    }

    /// accuracy S15: squares of these numbers overflow or vanish in single precision.
    #[test]
    fn very_large_and_very_small_spheres_are_hit() {
        for scale in [1e20_f32, 1e-25] {
            let sphere = Sphere { radius: scale, ..UNIT };
            let hit = sphere.intersect(&Ray::new(vec3(0.0, 0.0, -3.0 * scale), Vec3::Z));
            let exact = f64::from(3.0 * scale) - f64::from(scale);
            assert!(hit.is_some_and(|t| ulps(t, exact) <= 1.0), "scale {scale}: {hit:?}");
        }
    }
}
