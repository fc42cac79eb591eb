//! What is done with the bytes that a fuzzer makes up: the bodies of `tests/fuzz`.
//!
//! They stand here so that a plain `cargo test` can replay, without the fuzzer, the inputs that once
//! were found to be a problem. Each takes any bytes and panics if something is wrong.

use std::fs;

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb};
use glam::{DVec3, Vec3};
use ray_casting::{Geometry, Hit, Intersect, LinearSearch, Ray, Scene, Sphere};
use tempfile::TempDir;
use workbench::{SceneFile, Texture, Unwatched};

use crate::bits;

/// A target: its name, and what it does with bytes.
pub type Target = (&'static str, fn(&[u8]));

/// Every target.
pub const TARGETS: [Target; 5] = [
    ("scene_file", scene_file),
    ("obj", obj),
    ("mtl", mtl),
    ("texture", texture),
    ("tree_against_linear_search", tree_against_linear_search),
];

/// What a scene file needs beside the record under test.
const HEAD: &str = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [8, 8]\n";

/// One corner after the other, with a normal and texture coordinates.
const MESH: &str =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";

/// The materials that meshes find.
const LIBRARY: &[u8] = b"newmtl a\nnewmtl b\nKe 1 1 1\n";

/// Bytes as a scene file, beside a mesh `a.obj` that it may name.
pub fn scene_file(bytes: &[u8]) {
    load(&[("scene.toml", bytes), ("a.obj", MESH.as_bytes()), ("a.mtl", LIBRARY)]);
}

/// Bytes as a mesh, beside the materials `a` and `b` of `a.mtl`.
pub fn obj(bytes: &[u8]) {
    let scene = format!("{HEAD}[[mesh]]\nfile = 'a.obj'\n");
    load(&[("scene.toml", scene.as_bytes()), ("a.obj", bytes), ("a.mtl", LIBRARY)]);
}

/// Bytes as the materials of a mesh that uses `a` and `b`.
pub fn mtl(bytes: &[u8]) {
    let scene = format!("{HEAD}[[mesh]]\nfile = 'a.obj'\n");
    load(&[("scene.toml", scene.as_bytes()), ("a.obj", MESH.as_bytes()), ("a.mtl", bytes)]);
}

/// Bytes as a PNG file that a material names. Pictures of more than a million pixels are left at
/// what their header says: to decode them takes time and finds nothing new.
pub fn texture(bytes: &[u8]) {
    let folder = folder(&[("t.png", bytes)]);
    let text = format!("{HEAD}[materials.a]\nmap_kd = 't.png'\n");
    let Ok(scene) = SceneFile::parse(&folder.path().join("scene.toml"), &text) else { return };
    let record = &scene.textures[0];
    let [width, height] = record.size;
    assert!(width > 0 && height > 0, "a texture of {width}×{height}");
    if u64::from(width) * u64::from(height) > 1 << 20 {
        return;
    }
    let Ok(texture) = Texture::load(record) else { return };
    assert_eq!([texture.width, texture.height], record.size, "header and texels differ");
    let last = texture.texel(width - 1, height - 1);
    assert!(last.iter().all(|x| (0.0..=1.0).contains(x)), "the last texel is {last:?}");
}

/// A folder with these files.
fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).expect("a temporary file is written");
    }
    folder
}

/// Reads `scene.toml` of these files as a stage does; what is accepted must be sound.
fn load(files: &[(&str, &[u8])]) {
    let folder = folder(files);
    match Scene::load(&folder.path().join("scene.toml")) {
        Ok(scene) => check(&scene),
        Err(error) => {
            let sentence = error.to_string();
            assert!(!sentence.is_empty() && sentence.len() < 4000, "{} bytes", sentence.len());
        }
    }
}

/// No number of a scene that was accepted is infinite or NaN, and no index leads nowhere.
fn check(scene: &Scene) {
    let Geometry { vertices, triangles, spheres } = &scene.geometry;
    assert!(vertices.iter().all(|v| v.is_finite()), "a vertex is not finite: {vertices:?}");
    let corner = |&i: &u32| (i as usize) < vertices.len();
    assert!(triangles.as_flattened().iter().all(corner), "a corner is no vertex: {triangles:?}");
    let sound = |s: &Sphere| s.radius > 0.0 && (s.center.abs() + s.radius).max_element() < f32::MAX;
    assert!(spheres.iter().all(sound), "a sphere is none: {spheres:?}");

    let materials = &scene.attributes.materials;
    assert_eq!(materials.len(), scene.geometry.primitives() as usize, "materials and primitives");
    let known = |&i: &u32| (i as usize) < scene.materials.len();
    assert!(materials.iter().all(known), "a primitive has no material: {materials:?}");
    let numbers = scene
        .materials
        .iter()
        .flat_map(|m| [m.kd, m.ks, m.kr, m.kt, m.ke, [m.ns, m.ni, 0.0]].into_iter().flatten());
    let positive = |x: f32| (0.0..f32::INFINITY).contains(&x);
    assert!(numbers.into_iter().all(positive), "a material is unsound: {:?}", scene.materials);
    let maps = scene.materials.iter().filter_map(|material| material.map_kd);
    assert!(maps.into_iter().all(|map| (map as usize) < scene.textures.len()), "a lost texture");

    let camera = &scene.camera;
    for axis in [camera.forward, camera.right, camera.up] {
        assert!((axis.length() - 1.0).abs() < 1e-5, "{camera:?}");
    }
    let [width, height] = scene.exposure.size;
    assert!(width > 0 && height > 0, "a picture of {width}×{height}");
    let lit = scene.lights.iter().all(|light| light.position.is_finite());
    assert!(lit, "a light is nowhere: {:?}", scene.lights);
}

/// Bytes as triangles, spheres and rays: every tree finds what looking at all of them finds, the
/// same primitive, the same t and the same weights to the bit.
pub fn tree_against_linear_search(bytes: &[u8]) {
    let mut numbers = Numbers { bytes };
    let geometry = geometry(&mut numbers);
    let rays: Vec<Ray> = (0..16).map_while(|_| ray(&mut numbers, &geometry)).collect();
    let linear = LinearSearch::new(&geometry, &Unwatched);
    for builder in [Builder::Median, Builder::Sah] {
        compare::<Aabb>("AABB", &geometry, builder, &linear, &rays);
        compare::<Obb>("OBB", &geometry, builder, &linear, &rays);
        compare::<KDop<7>>("14-DOP", &geometry, builder, &linear, &rays);
    }
}

fn compare<V: BoundingVolume>(
    volume: &str,
    geometry: &Geometry,
    builder: Builder,
    linear: &impl Intersect,
    rays: &[Ray],
) {
    let tree = BvTree::<V, _>::build(geometry, builder, &Unwatched);
    let bits = |hit: Option<Hit>| {
        hit.map(|h| (h.primitive, h.t.to_bits(), h.barycentric.to_array().map(f32::to_bits)))
    };
    for ray in rays {
        let (expected, found) = (linear.intersect(ray), tree.intersect(ray));
        assert!(
            bits(found) == bits(expected) && tree.occluded(ray) == expected.is_some(),
            "{volume}, {builder:?}: {found:?} instead of {expected:?} for {}\n{geometry:?}",
            bits::ray(ray),
        );
    }
}

/// Up to 20 triangles, which may share corners, and up to 10 spheres; all numbers are finite.
fn geometry(numbers: &mut Numbers<'_>) -> Geometry {
    let mut geometry = Geometry::default();
    let [triangles, spheres, shared] = [21, 11, 16].map(|n| numbers.below(n).unwrap_or(0));
    let points = if shared > 0 { 2 + shared } else { 3 * triangles };
    geometry.vertices.extend((0..points).map_while(|_| numbers.point()));
    let count = geometry.vertices.len() as u32;
    if count > 0 {
        let corner = |i| numbers.below(256).map_or(i, |j| if shared > 0 { j } else { i }) % count;
        let corners: Vec<u32> = (0..3 * triangles).map(corner).collect();
        geometry.triangles.extend(corners.as_chunks().0);
    }
    geometry.spheres.extend((0..spheres).map_while(|_| {
        let center = numbers.point()?;
        let radius = numbers.float()?.abs();
        // A tree leaves out what has no finite box; a scene file with such a sphere is refused.
        let has_box = radius > 0.0 && (center.abs() + radius).max_element() < f32::MAX;
        has_box.then_some(Sphere { center, radius })
    }));
    geometry
}

/// A ray from any point along any direction, or to a corner, an edge, the outline of a sphere.
fn ray(numbers: &mut Numbers<'_>, geometry: &Geometry) -> Option<Ray> {
    let kind = numbers.below(6)?;
    let origin = numbers.point()?;
    let vertex = |i: u32| geometry.vertices.get(i as usize % geometry.vertices.len().max(1));
    let target = match kind {
        0 => numbers.point()?,
        1 => *vertex(numbers.below(256)?)?,
        2 => vertex(numbers.below(256)?)?.midpoint(*vertex(numbers.below(256)?)?),
        3 => {
            let i = numbers.below(256)? as usize % geometry.spheres.len().max(1);
            let sphere = geometry.spheres.get(i)?;
            sphere.center + sphere.radius * Vec3::AXES[numbers.below(3)? as usize]
        }
        kind => {
            // Along an axis.
            let axis = Vec3::AXES[numbers.below(3)? as usize];
            return Some(Ray::new(origin, if kind == 4 { axis } else { -axis }));
        }
    };
    // In double precision differences of the largest numbers are finite, and so are their squares.
    let way = target.as_dvec3() - origin.as_dvec3();
    let direction = way.normalize_or(DVec3::X).as_vec3();
    Some(Ray::new(origin, direction))
}

/// Numbers from bytes, until there are none left.
struct Numbers<'a> {
    bytes: &'a [u8],
}

impl Numbers<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (&first, rest) = self.bytes.split_first()?;
        self.bytes = rest;
        Some(first)
    }

    fn below(&mut self, n: u32) -> Option<u32> {
        Some(u32::from(self.byte()?) % n)
    }

    /// A finite number: a small multiple of 1/16, a power of two, or any bits.
    fn float(&mut self) -> Option<f32> {
        let kind = self.byte()?;
        match kind % 8 {
            0..=4 => Some(f32::from(self.byte()?.cast_signed()) / 16.0),
            5 => {
                let power = f32::from_bits(u32::from(self.byte()?.clamp(1, 254)) << 23);
                Some(if kind < 128 { power } else { -power })
            }
            _ => {
                let bits = [self.byte()?, self.byte()?, self.byte()?, self.byte()?];
                Some(f32::from_le_bytes(bits)).filter(|x| x.is_finite())
            }
        }
    }

    fn point(&mut self) -> Option<Vec3> {
        Some(Vec3::new(self.float()?, self.float()?, self.float()?))
    }
}
