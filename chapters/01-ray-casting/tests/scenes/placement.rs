//! Meshes are scaled, turned and moved, in this order.

use glam::{Vec3, vec3};

use crate::tools::{scene_with_mesh, surface};

/// Its last corner is the only one beside the origin's octants: x, y and z tell it apart.
const OBJ: &str = "v 0.1 0.2 0.3\nv 2 0 0\nv 0 3 0\nvn 0 0 1\nvn 1 0 0\nvn 0 0.6 0.8\n\
                   f 1//1 2//2 3//3\n";

const MESH: &str = "[[mesh]]\nfile = 'a.obj'\nmaterial = 'white'\n";

#[test]
fn a_mesh_that_is_not_moved_keeps_every_bit() {
    let scene = scene_with_mesh(MESH, OBJ);
    let expected = [vec3(0.1, 0.2, 0.3), vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)];
    assert_eq!(scene.geometry.vertices, expected, "the corners");
    assert_eq!(scene.attributes.normals[2], vec3(0.0, 0.6, 0.8), "a normal");
}

#[test]
fn scale_comes_first_then_x_y_z_then_the_move() {
    let cases = [
        ("scale = 2", [0.0, 6.0, 0.0], Vec3::Z),
        ("translate = [1, 2, 3]", [1.0, 5.0, 3.0], Vec3::Z),
        ("rotate = [90, 0, 0]", [0.0, 0.0, 3.0], Vec3::NEG_Y),
        ("rotate = [0, 90, 0]", [0.0, 3.0, 0.0], Vec3::X),
        ("rotate = [0, 0, 90]", [-3.0, 0.0, 0.0], Vec3::Z),
        ("rotate = [90, 90, 0]", [3.0, 0.0, 0.0], Vec3::NEG_Y),
        ("rotate = [90, 0, 90]", [0.0, 0.0, 3.0], Vec3::X),
        ("scale = 2\nrotate = [0, 0, 90]\ntranslate = [1, 1, 1]", [-5.0, 1.0, 1.0], Vec3::Z),
    ];
    for (placement, corner, normal) in cases {
        let scene = scene_with_mesh(&format!("{MESH}{placement}"), OBJ);
        let got = scene.geometry.vertices[2];
        let error = got.distance(Vec3::from_array(corner));
        assert!(error <= 1e-6, "{placement}: the corner is at {got} for {corner:?}");
        let got = scene.attributes.normals[0];
        let error = got.distance(normal);
        assert!(error <= 1e-7, "{placement}: the normal is {got} for {normal}");
    }
}

/// Interpolated, unit length, and on the viewer's side; the geometric normal stays what it is.
#[test]
fn shading_normals_are_interpolated_and_face_the_viewer() {
    let obj = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn -0.6 0 0.8\nvn 0.6 0 0.8\nvn 0 0 1\n\
               f 1//1 2//2 3//3\n";
    let scene = scene_with_mesh(MESH, obj);
    for (x, expected) in [(-0.9, vec3(-0.6, 0.0, 0.8)), (0.0, Vec3::Z), (0.9, vec3(0.6, 0.0, 0.8))]
    {
        for side in [1.0, -1.0] {
            let seen = surface(&scene, vec3(x, -0.99, side), vec3(0.0, 0.0, -side));
            assert_eq!(seen.geometric_normal, Vec3::Z, "the geometric normal");
            assert_eq!(seen.is_front(), side > 0.0, "seen from z = {side}");
            assert_eq!(seen.facing_normal(), side * Vec3::Z, "the side of the viewer");
            let normal = scene.shading_normal(&seen);
            let length = normal.length();
            assert!((length - 1.0).abs() <= 2.0 * f32::EPSILON, "x = {x}: length {length}");
            let error = normal.distance(side * expected);
            assert!(error <= 0.08, "x = {x}: {normal} for {expected}, from z = {side}");
        }
    }
}

#[test]
fn without_normals_the_geometric_one_shades() {
    let obj = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    let records = format!("{MESH}[[sphere]]\ncenter = [5, 0, 0]\nradius = 1\nmaterial = 'white'");
    let scene = scene_with_mesh(&records, obj);
    let triangle = surface(&scene, vec3(0.0, 0.0, 2.0), Vec3::NEG_Z);
    assert_eq!(scene.shading_normal(&triangle), Vec3::Z, "on the triangle");
    let sphere = surface(&scene, vec3(5.0, 0.0, 2.0), Vec3::NEG_Z);
    assert_eq!(scene.shading_normal(&sphere), Vec3::Z, "on the sphere");
    let inside = surface(&scene, vec3(5.0, 0.0, 0.0), Vec3::NEG_Z);
    assert_eq!(scene.shading_normal(&inside), Vec3::Z, "inside the sphere");
    assert_eq!(inside.geometric_normal, Vec3::NEG_Z, "the sphere's front is the outside");
}
