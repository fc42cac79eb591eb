//! Facts about the generated meshes.

use generator::{Blob, Mesh, Surface, TessellatedSpheres, blob, rings_for, side_for, sphereflake};
use generator::{Terrain, terrain, write_obj};
use sha2::{Digest, Sha256};
use std::collections::HashMap;

fn obj(surface: &impl Surface) -> Vec<u8> {
    let mut text = Vec::new();
    write_obj(&mut text, surface).expect("a Vec takes everything");
    text
}

/// The vertices and triangles of an OBJ text, read as simply as possible.
fn read(text: &[u8]) -> Mesh {
    let mut mesh = Mesh::default();
    for line in std::str::from_utf8(text).expect("the file is ASCII").lines() {
        let mut words = line.split(' ');
        let kind = words.next();
        let words: Vec<&str> = words.collect();
        if kind == Some("v") {
            mesh.positions.push([0, 1, 2].map(|k| words[k].parse().expect("a number")));
        } else {
            let index = |k: usize| words[k].parse::<u32>().expect("an index") - 1;
            mesh.triangles.push([0, 1, 2].map(index));
        }
    }
    mesh
}

/// Twice the area of a triangle times its unit normal, and its first vertex.
fn doubled_area(mesh: &Mesh, triangle: [u32; 3]) -> ([f64; 3], [f64; 3]) {
    let v = triangle.map(|i| mesh.positions[i as usize].map(f64::from));
    let edge = |k: usize| [0, 1, 2].map(|axis| v[k][axis] - v[0][axis]);
    let (a, b) = (edge(1), edge(2));
    let cross = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    ([cross(1, 2), cross(2, 0), cross(0, 1)], v[0])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// How many edges have no partner that runs the other way.
fn open_edges(mesh: &Mesh) -> usize {
    let mut balance: HashMap<(u32, u32), i32> = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (key, sign) = if from < to { ((from, to), 1) } else { ((to, from), -1) };
            let uses = balance.entry(key).or_insert(0);
            *uses += sign;
            assert!((-1..=1).contains(uses), "edge {key:?} is used twice in one direction");
        }
    }
    balance.values().filter(|&&uses| uses != 0).count()
}

fn smallest_doubled_area(mesh: &Mesh) -> f64 {
    let areas = mesh.triangles.iter().map(|&t| doubled_area(mesh, t).0);
    areas.map(|n| dot(n, n).sqrt()).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_blob_of_320_is_the_mesh_of_the_reference_images() {
    let digest = Sha256::digest(obj(&Blob { n: 320 }));
    let hex: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(
        hex, "d386a77d681cf59a1d341c8165cd45f43e428ee6b92dcf4fdc6b1cf816125415",
        "SHA-256 of blob.obj"
    );
}

#[test]
fn the_file_holds_the_mesh_in_memory_bit_for_bit() {
    let check = |read: Mesh, kept: Mesh| {
        let bits = |mesh: &Mesh| mesh.positions.iter().flatten().map(|x| x.to_bits()).collect();
        let (a, b): (Vec<u32>, Vec<u32>) = (bits(&read), bits(&kept));
        assert_eq!(a, b, "positions of {} triangles", kept.triangles.len());
        assert_eq!(read.triangles, kept.triangles, "of {}", kept.triangles.len());
    };
    check(read(&obj(&Blob { n: 60 })), blob(60));
    check(read(&obj(&Terrain { side: 50, seed: 3 })), terrain(50, 3));
}

#[test]
fn a_blob_of_n_rings_has_2n_times_n_minus_1_triangles_and_is_closed() {
    for n in [3, 4, 7, 100] {
        let mesh = blob(n);
        assert_eq!(mesh.triangles.len() as u32, 2 * n * (n - 1), "triangles for n = {n}");
        assert_eq!(mesh.positions.len() as u32, n * (n - 1) + 2, "vertices for n = {n}");
        assert_eq!(open_edges(&mesh), 0, "open edges for n = {n}");
    }
}

#[test]
fn every_triangle_of_a_blob_faces_outwards_and_has_an_area() {
    for n in [40, 320] {
        let mesh = blob(n);
        let smallest = smallest_doubled_area(&mesh);
        assert!(smallest > 0.0, "a triangle of blob({n}) has area {smallest}");
        let inwards = mesh.triangles.iter().filter(|&&t| {
            let (normal, vertex) = doubled_area(&mesh, t);
            dot(normal, vertex) <= 0.0
        });
        assert_eq!(inwards.count(), 0, "triangles of blob({n}) that face the origin");
    }
}

#[test]
fn a_terrain_is_a_grid_that_faces_upwards_and_is_open_at_its_rim_only() {
    let side = 64;
    let mesh = terrain(side, 0);
    assert_eq!(mesh.triangles.len() as u32, 2 * side * side, "triangles");
    assert_eq!(mesh.positions.len() as u32, (side + 1) * (side + 1), "vertices");
    assert_eq!(open_edges(&mesh) as u32, 4 * side, "open edges");
    let lowest = mesh.triangles.iter().map(|&t| doubled_area(&mesh, t).0[1]);
    let lowest = lowest.fold(f64::INFINITY, f64::min);
    assert!(lowest > 0.0, "the normals' smallest height is {lowest}");
}

#[test]
fn a_terrain_stays_between_0_and_24_and_uses_much_of_it() {
    let mesh = terrain(200, 0);
    let heights = || mesh.positions.iter().map(|p| p[1]);
    let (low, high) = (heights().fold(f32::MAX, f32::min), heights().fold(f32::MIN, f32::max));
    assert!((0.0..6.0).contains(&low), "lowest {low}");
    assert!((12.0..24.0).contains(&high), "highest {high}");
}

#[test]
fn a_finer_terrain_shows_the_same_landscape() {
    let (coarse, fine) = (terrain(16, 5), terrain(32, 5));
    for i in 0..=16 {
        for j in 0..=16 {
            let (a, b) = (coarse.positions[i * 17 + j], fine.positions[2 * i * 33 + 2 * j]);
            assert_eq!(a, b, "grid point ({i}, {j})");
        }
    }
}

#[test]
fn another_seed_is_another_landscape() {
    assert_ne!(terrain(16, 0), terrain(16, 1), "seeds 0 and 1");
}

/// A changed formula changes the plots of the book and every measurement: it must be noticed.
#[test]
fn the_terrain_does_not_change_from_version_to_version() {
    let digest = Sha256::digest(obj(&Terrain { side: 32, seed: 0 }));
    let hex: String = digest[..8].iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(hex, "98fbd1b99b537333", "first 8 bytes of the SHA-256 of terrain --side 32");
}

#[test]
fn a_tessellated_flake_is_closed_and_lies_on_its_spheres() {
    let spheres = sphereflake(2);
    let flake = TessellatedSpheres { spheres: spheres.clone(), rings: 6 };
    let mesh = flake.mesh();
    assert_eq!(mesh.triangles.len(), 91 * 2 * 6 * 5, "triangles");
    assert_eq!(open_edges(&mesh), 0, "open edges");
    let of_a_sphere = mesh.positions.len() / spheres.len();
    for (sphere, vertices) in spheres.iter().zip(mesh.positions.chunks(of_a_sphere)) {
        for vertex in vertices {
            let d = [0, 1, 2].map(|k| f64::from(vertex[k]) - f64::from(sphere.center[k]));
            let off = dot(d, d).sqrt() - f64::from(sphere.radius);
            assert!(off.abs() < 3e-7, "{vertex:?} is {off} off {sphere:?}");
        }
    }
}

#[test]
fn the_size_helpers_come_as_near_as_a_whole_number_can() {
    for wanted in [20, 1_000, 204_160, 1_000_000, 10_000_000] {
        let blob = |n: u64| (2 * n * (n - 1)).abs_diff(wanted);
        let n = u64::from(rings_for(wanted));
        assert!(blob(n) <= blob(n + 1) && blob(n) <= blob(n - 1), "rings_for({wanted}) = {n}");
        let terrain = |side: u64| (2 * side * side).abs_diff(wanted);
        let side = u64::from(side_for(wanted));
        let nearest = terrain(side) <= terrain(side + 1) && terrain(side) <= terrain(side - 1);
        assert!(nearest, "side_for({wanted}) = {side}");
    }
    assert_eq!(rings_for(204_160), 320, "the reference mesh");
}
