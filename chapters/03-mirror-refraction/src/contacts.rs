//! Which faces of glass lie on other faces.
//!
//! Two blocks that touch share a place where a ray meets two faces at once. A search returns one of
//! them, the lower index or the one that rounding puts first, and a ray that goes on from there
//! starts beyond both: the other face is never met, and whoever counts the glasses a ray is in is
//! wrong from there on. So the pairs of faces that lie on each other are found once, before the
//! first ray. Most scenes have none, and then pay nothing for it while rendering.

use glam::Vec3;
use ray_casting::math::gamma;
use ray_casting::{Geometry, Scene};
use workbench::SurfaceKind;

/// For each face of glass, the faces that lie on it.
#[derive(Debug, Default)]
pub struct Contacts {
    /// Two faces, at least one of them of glass; each pair stands here both ways round, sorted.
    pairs: Vec<[u32; 2]>,
}

impl Contacts {
    /// Finds all contacts of glass in a scene, in a time of about n log n.
    ///
    /// Triangles touch when they lie in one plane, spheres when they are the same, each within the
    /// rounding of the file's numbers. Two faces of one material that look the same way do not
    /// count: they are neighbours in a flat part of one body, or else one too many.
    #[must_use]
    pub fn find(scene: &Scene) -> Self {
        let is_glass: Vec<bool> = (scene.materials.iter())
            .map(|material| material.surface == SurfaceKind::Glass)
            .collect();
        let mut finder = Finder { scene, is_glass, pairs: Vec::new() };
        let around_glass = (0..scene.geometry.primitives())
            .filter(|&face| finder.is_glass(face))
            .map(|face| Bounds::of(&scene.geometry, face))
            .reduce(Bounds::hull);
        if let Some(bounds) = around_glass {
            let near_glass = (0..scene.geometry.primitives())
                .map(|face| (face, Bounds::of(&scene.geometry, face)))
                .filter(|(_, face)| face.meets(&bounds))
                .collect();
            finder.search(near_glass, bounds, MOST_HALVINGS);
        }
        finder.pairs.sort_unstable();
        finder.pairs.dedup();
        Self { pairs: finder.pairs }
    }

    /// The faces that lie on this one, as primitive indices in ascending order. For an opaque face,
    /// those of glass.
    #[inline]
    #[must_use]
    pub fn of(&self, face: u32) -> impl ExactSizeIterator<Item = u32> {
        let start = self.pairs.partition_point(|pair| pair[0] < face);
        let here = self.pairs[start..].partition_point(|pair| pair[0] == face);
        self.pairs[start..start + here].iter().map(|pair| pair[1])
    }
}

/// Few enough faces to compare each with each.
const FEW: usize = 64;

/// So many faces in one spot that comparing each with each would take too long. Contacts there are
/// not found; what is inside of what is anyone's guess then.
const TOO_MANY: usize = 4096;

/// Enough to separate what can be separated, even in a scene of 10⁷ faces of uneven size.
const MOST_HALVINGS: u32 = 40;

struct Finder<'a> {
    scene: &'a Scene,
    is_glass: Vec<bool>,
    pairs: Vec<[u32; 2]>,
}

impl Finder<'_> {
    fn is_glass(&self, face: u32) -> bool {
        self.is_glass[self.scene.attributes.materials[face as usize] as usize]
    }

    /// Compares the faces in `bounds`, halving it until few are left. A face that lies in both
    /// halves goes to both.
    fn search(&mut self, faces: Vec<(u32, Bounds)>, bounds: Bounds, halvings: u32) {
        if !faces.iter().any(|&(face, _)| self.is_glass(face)) {
            return;
        }
        if faces.len() > FEW && halvings > 0 {
            let (low, high) = bounds.halves();
            let part = |half: &Bounds| -> Vec<_> {
                faces.iter().filter(|(_, face)| face.meets(half)).copied().collect()
            };
            let (in_low, in_high) = (part(&low), part(&high));
            // Halving must be worth it: else the faces lie on one spot, or are as large as the box.
            if in_low.len() + in_high.len() <= faces.len() + faces.len() / 8 {
                drop(faces);
                self.search(in_low, low, halvings - 1);
                self.search(in_high, high, halvings - 1);
                return;
            }
        }
        if faces.len() <= TOO_MANY {
            self.compare(&faces);
        }
    }

    fn compare(&mut self, faces: &[(u32, Bounds)]) {
        for &(glass, glass_bounds) in faces {
            if !self.is_glass(glass) {
                continue;
            }
            for &(other, other_bounds) in faces {
                if glass != other && glass_bounds.meets(&other_bounds) && self.touch(glass, other) {
                    self.pairs.extend([[glass, other], [other, glass]]);
                }
            }
        }
    }

    fn touch(&self, a: u32, b: u32) -> bool {
        let geometry = &self.scene.geometry;
        let materials = &self.scene.attributes.materials;
        let same_material = materials[a as usize] == materials[b as usize];
        match (geometry.sphere(a), geometry.sphere(b)) {
            (None, None) => {
                let (a, b) = (geometry.corners(a), geometry.corners(b));
                let same_way = vector_area(a).dot(vector_area(b)) > 0.0;
                !(same_material && same_way) && lie_in_one_plane(a, b)
            }
            (Some(a), Some(b)) if !same_material => {
                let rounding = gamma(2) * (a.center.abs() + a.radius);
                let apart = (a.center - b.center).abs() + (a.radius - b.radius).abs();
                apart.cmple(rounding).all()
            }
            _ => false,
        }
    }
}

/// Twice the area of a triangle, as a vector along its front normal.
fn vector_area([v0, v1, v2]: [Vec3; 3]) -> Vec3 {
    (v1 - v0).cross(v2 - v0)
}

/// Whether two triangles lie in one plane, as far as the rounding of their corners lets one say.
///
/// The corners of the smaller one are held against the plane of the larger one. Rounding a corner
/// moves it by u |v| for each axis, and the plane by as much within the triangle; a smaller
/// triangle that overlaps it reaches out of it by no more than its size, which may triple that.
/// With the corner's own, and the roundings of this test, eight are enough.
fn lie_in_one_plane(a: [Vec3; 3], b: [Vec3; 3]) -> bool {
    let a_is_larger = vector_area(a).length_squared() >= vector_area(b).length_squared();
    let (larger, smaller) = if a_is_larger { (a, b) } else { (b, a) };
    let [v0, v1, v2] = larger.map(|v| v.as_dvec3());
    let normal = (v1 - v0).cross(v2 - v0).normalize();
    let size = a.into_iter().chain(b).fold(Vec3::ZERO, |size, v| size.max(v.abs()));
    let rounding = f64::from(gamma(8)) * normal.abs().dot(size.as_dvec3());
    smaller.iter().all(|v| normal.dot(v.as_dvec3() - v0).abs() <= rounding)
}

/// A box around a face.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    min: Vec3,
    max: Vec3,
}

impl Bounds {
    /// Widened by as much as rounding can have moved the face.
    fn of(geometry: &Geometry, face: u32) -> Self {
        let (min, max) = match geometry.sphere(face) {
            Some(sphere) => (sphere.center - sphere.radius, sphere.center + sphere.radius),
            None => {
                let [v0, v1, v2] = geometry.corners(face);
                (v0.min(v1).min(v2), v0.max(v1).max(v2))
            }
        };
        let rounding = gamma(8) * min.abs().max(max.abs());
        Self { min: min - rounding, max: max + rounding }
    }

    fn hull(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    fn meets(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Cut in the middle of the longest side.
    fn halves(&self) -> (Self, Self) {
        let axis = (self.max - self.min).max_position();
        let middle = 0.5 * self.min[axis] + 0.5 * self.max[axis];
        let (mut low, mut high) = (*self, *self);
        low.max[axis] = middle;
        high.min[axis] = middle;
        (low, high)
    }
}
