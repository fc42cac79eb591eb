//! From one medium into the next.

use ray_casting::{Intersect, Ray, Rgb, Scene, ShearedRay, SurfacePoint};

use crate::contacts::Contacts;
use crate::material::Surface;
use crate::media::Media;

/// What a ray meets that crosses a boundary.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// η = ηᵢ/ηₜ: the index of refraction on the viewer's side divided by the one beyond.
    pub eta: f32,
    /// k_t of all bodies that are entered or left here, multiplied.
    pub kt: Rgb,
    /// What a ray is in that has crossed.
    pub beyond: Media,
    /// Where a reflected ray starts.
    pub near: SurfacePoint,
    /// Where a ray starts that has crossed: the same point, unless faces touch here and rounding
    /// has put one behind the other.
    pub far: SurfacePoint,
}

/// Knows what is on either side of a boundary.
///
/// Where faces touch, a ray crosses all of them at once: from one block into the next there is no
/// air between, and from one into another of the same material nothing happens at all. What is
/// exact, and what is not:
///
/// - Bodies beside, within or overlapping one another, and bodies whose faces lie on each other,
///   whole or in part, are exact.
/// - Glass that lies on an opaque surface shows that surface, as if the two were glued together.
/// - Two bodies of *one* material, the one inside the other, that share a face on the same side are
///   taken for one there. Two materials of the same index tell them apart.
/// - An eye inside glass is found out by [`Boundaries::media_at`].
/// - A body that is left without having been entered is open, or inside out: the ray then comes
///   from its index into what is known to be around.
pub struct Boundaries<'a> {
    scene: &'a Scene,
    surfaces: Vec<Surface>,
    contacts: Contacts,
}

impl<'a> Boundaries<'a> {
    /// Reads the materials of a scene, and finds out which faces touch.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        let surfaces = scene.materials.iter().map(Surface::from).collect();
        Self { scene, surfaces, contacts: Contacts::find(scene) }
    }

    /// What the surface is made of.
    #[inline]
    #[must_use]
    pub fn material(&self, point: &SurfacePoint) -> &Surface {
        &self.surfaces[point.material as usize]
    }

    /// The opaque surface that the glass at `point` lies on, or else `point` itself.
    ///
    /// It is seen where the glass is, so that rays that leave it start on the viewer's side of
    /// both.
    #[must_use]
    pub fn opaque_contact(&self, ray: &Ray, point: SurfacePoint) -> SurfacePoint {
        let mut others = self.touching(ray, &point);
        match others.find(|other| self.glass(other.material).is_none()) {
            None => point,
            Some(opaque) => SurfacePoint {
                position: point.position,
                position_error: point.position_error,
                ..opaque
            },
        }
    }

    // ANCHOR: crossing
    /// What happens to `ray`, in `media`, at the boundary that it meets in `point`.
    #[must_use]
    pub fn crossing(&self, ray: &Ray, point: &SurfacePoint, media: &Media) -> Crossing {
        let Meeting { sides, near, far } = self.meeting(ray, point);
        let mut crossing = Crossing { eta: media.ior(), kt: Rgb::ONE, beyond: *media, near, far };
        for (material, ior, kt) in sides.left() {
            if !crossing.beyond.leave(material) {
                crossing.eta = ior;
            }
            crossing.kt *= kt;
        }
        for (material, ior, kt) in sides.entered() {
            crossing.beyond.enter(material, ior);
            crossing.kt *= kt;
        }
        crossing.eta /= crossing.beyond.ior();
        crossing
    }
    // ANCHOR_END: crossing

    /// What is around the eye.
    #[must_use]
    pub fn media_at_eye<G: Intersect>(&self, geometry: &G) -> Media {
        let camera = &self.scene.camera;
        self.media_at(Ray::new(camera.eye, camera.forward), geometry)
    }

    /// What is around the start of `ray`.
    ///
    /// Far away, everything has been left. A body that the ray leaves on its way there without
    /// having entered it was around the start, and the first one to be left was the innermost. No
    /// ray is traced in a scene without glass.
    #[must_use]
    pub fn media_at<G: Intersect>(&self, mut ray: Ray, geometry: &G) -> Media {
        if !self.surfaces.iter().any(|surface| matches!(surface, Surface::Glass { .. })) {
            return Media::OUTSIDE;
        }
        let mut entered: Vec<u32> = Vec::new();
        let mut around: Vec<(u32, f32)> = Vec::new();
        for _ in 0..self.most_crossings() {
            let Some(hit) = geometry.intersect(&ray) else { break };
            let meeting = self.meeting(&ray, &self.scene.surface(&ray, &hit));
            for (material, ior, _) in meeting.sides.left() {
                match entered.iter().rposition(|&other| other == material) {
                    Some(place) => drop(entered.remove(place)),
                    None => around.push((material, ior)),
                }
            }
            entered.extend(meeting.sides.entered().map(|(material, ..)| material));
            ray = meeting.far.spawn(ray.direction);
        }
        let mut media = Media::OUTSIDE;
        for &(material, ior) in around.iter().rev() {
            media.enter(material, ior);
        }
        media
    }

    /// How often a straight line can cross a boundary: each face twice, as a sphere.
    #[inline]
    #[must_use]
    pub fn most_crossings(&self) -> u32 {
        self.scene.geometry.primitives().saturating_mul(2)
    }

    /// All that is known of the faces that `ray` meets in `point`.
    fn meeting(&self, ray: &Ray, point: &SurfacePoint) -> Meeting {
        let mut meeting = Meeting { sides: Sides::default(), near: *point, far: *point };
        meeting.sides.add(point, self.glass(point.material));

        let inward = -point.facing_normal();
        let depth = |p: &SurfacePoint, direction| p.spawn(direction).origin.dot(inward);
        for other in self.touching(ray, point) {
            meeting.sides.add(&other, self.glass(other.material));
            if depth(&other, -inward) < depth(&meeting.near, -inward) {
                meeting.near = other;
            }
            if depth(&other, inward) > depth(&meeting.far, inward) {
                meeting.far = other;
            }
        }
        meeting
    }

    /// What else `ray` meets in `point`.
    fn touching(&self, ray: &Ray, point: &SurfacePoint) -> impl Iterator<Item = SurfacePoint> {
        let others = self.contacts.of(point.hit.primitive);
        let prepared = (others.len() > 0).then(|| ShearedRay::new(ray));
        let ray = *ray;
        others.filter_map(move |other| {
            let hit = self.scene.geometry.intersect_primitive(prepared.as_ref()?, other)?;
            Some(self.scene.surface(&ray, &hit))
        })
    }

    /// η and k_t of a material that is glass.
    fn glass(&self, material: u32) -> Option<(f32, Rgb)> {
        match self.surfaces[material as usize] {
            Surface::Glass { ior, kt } => Some((ior, kt)),
            Surface::Diffuse(_) | Surface::Mirror { .. } => None,
        }
    }
}

/// All the faces that a ray meets in one point.
struct Meeting {
    sides: Sides,
    /// The face that lies nearest to the viewer.
    near: SurfacePoint,
    /// The one that lies farthest.
    far: SurfacePoint,
}

/// Of each glass that a ray meets in one point, whether it shows its front, its back, or both.
///
/// Both: one body ends here and another of the same glass begins, or the ray touches an edge.
/// Nothing changes then. Twice the same side counts once: it is the edge between two faces of one
/// body.
#[derive(Default)]
struct Sides {
    met: [Side; Self::CAPACITY],
    len: usize,
}

#[derive(Clone, Copy, Default)]
struct Side {
    material: u32,
    ior: f32,
    kt: Rgb,
    front: bool,
    back: bool,
}

impl Sides {
    /// More kinds of glass do not touch in one point; if they do, the rest is not seen.
    const CAPACITY: usize = 4;

    /// Adds a face, if it is `glass`.
    fn add(&mut self, point: &SurfacePoint, glass: Option<(f32, Rgb)>) {
        let Some((ior, kt)) = glass else { return };
        let met = &mut self.met[..self.len];
        let (front, back) = (point.is_front(), !point.is_front());
        if let Some(side) = met.iter_mut().find(|side| side.material == point.material) {
            side.front |= front;
            side.back |= back;
        } else if self.len < Self::CAPACITY {
            self.met[self.len] = Side { material: point.material, ior, kt, front, back };
            self.len += 1;
        }
    }

    /// Material, η and k_t of each body that is left.
    fn left(&self) -> impl Iterator<Item = (u32, f32, Rgb)> {
        self.net(|side| side.back && !side.front)
    }

    /// Material, η and k_t of each body that is entered.
    fn entered(&self) -> impl Iterator<Item = (u32, f32, Rgb)> {
        self.net(|side| side.front && !side.back)
    }

    fn net(&self, counts: impl Fn(&Side) -> bool) -> impl Iterator<Item = (u32, f32, Rgb)> {
        let met = self.met[..self.len].iter();
        met.filter(move |side| counts(side)).map(|side| (side.material, side.ior, side.kt))
    }
}
