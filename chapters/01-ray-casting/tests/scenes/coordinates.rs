//! Texture coordinates.

use glam::{Vec2, Vec3, vec2, vec3};

use crate::tools::{scene, scene_with_mesh, surface};

#[test]
fn a_quad_runs_from_its_first_vertex_to_its_third() {
    // A sphere's record and a quad's before it: the attributes must not slip.
    let quad = |x: f32| {
        let [a, b] = [x, x + 2.0];
        format!(
            "[[quad]]\nmaterial = 'white'\n\
             vertices = [[{a}, 0, 0], [{b}, 0, 0], [{b}, 4, 0], [{a}, 4, 0]]\n"
        )
    };
    let scene = scene(&format!("{}{}", quad(-9.0), quad(0.0)));
    for (x, y, expected) in [
        (0.25, 0.25, vec2(0.125, 0.0625)),
        (1.75, 0.25, vec2(0.875, 0.0625)),
        (1.75, 3.75, vec2(0.875, 0.9375)),
        (0.25, 3.75, vec2(0.125, 0.9375)),
        (1.0, 2.0, vec2(0.5, 0.5)),
        (-8.5, 1.0, vec2(0.25, 0.25)),
    ] {
        let seen = surface(&scene, vec3(x, y, 3.0), Vec3::NEG_Z);
        let got = scene.texture_coordinates(&seen);
        assert!(got.distance(expected) <= 4.0 * f32::EPSILON, "({x}, {y}): {got} for {expected}");
    }
}

#[test]
fn a_sphere_has_longitude_and_latitude() {
    let scene = scene("[[sphere]]\ncenter = [1, 2, 3]\nradius = 2\nmaterial = 'white'");
    let diagonal = vec3(1.0, 0.0, 1.0);
    for (outward, expected) in [
        (Vec3::Z, vec2(0.0, 0.5)),
        (diagonal, vec2(0.125, 0.5)),
        (Vec3::X, vec2(0.25, 0.5)),
        (Vec3::NEG_Z, vec2(0.5, 0.5)),
        (Vec3::NEG_X, vec2(0.75, 0.5)),
        (vec3(0.0, 1.0, -1.0), vec2(0.5, 0.75)),
        (vec3(0.0, -1.0, -1.0), vec2(0.5, 0.25)),
    ] {
        let seen = surface(&scene, vec3(1.0, 2.0, 3.0) + 5.0 * outward, -outward);
        let got = scene.texture_coordinates(&seen);
        assert!(got.distance(expected) <= 1e-6, "{outward}: {got} for {expected}");
    }
    for (outward, latitude) in [(Vec3::Y, 1.0), (Vec3::NEG_Y, 0.0)] {
        let seen = surface(&scene, vec3(1.0, 2.0, 3.0) + 5.0 * outward, -outward);
        let got = scene.texture_coordinates(&seen);
        assert!(got.is_finite() && (got.y - latitude).abs() <= 1e-3, "{outward}: {got}");
    }
}

/// Every longitude lies in [0, 1], also where the seam is.
#[test]
fn coordinates_of_a_sphere_stay_between_0_and_1() {
    let scene = scene("[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = 'white'");
    for i in -100..=100_i16 {
        let outward = vec3(f32::from(i) * 1e-9, f32::from(i) / 101.0, 1.0);
        let seen = surface(&scene, 5.0 * outward, -outward);
        let got = scene.texture_coordinates(&seen);
        let inside = got.cmpge(Vec2::ZERO).all() && got.cmple(Vec2::ONE).all();
        assert!(inside, "{outward}: {got}");
    }
}

#[test]
fn a_mesh_has_the_coordinates_of_its_file() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nvt 1 0.25\nvt 0.5 0.75\n\
               f 1/1 2/2 3/3\n";
    let quad = "[[quad]]\nmaterial = 'white'\n\
                vertices = [[5, 0, 0], [6, 0, 0], [6, 1, 0], [5, 1, 0]]\n";
    let mesh = "[[mesh]]\nfile = 'a.obj'\nmaterial = 'white'\n";
    let scene = scene_with_mesh(&format!("{quad}{mesh}"), obj);
    let seen = surface(&scene, vec3(0.25, 0.5, 1.0), Vec3::NEG_Z);
    let got = scene.texture_coordinates(&seen);
    assert_eq!(got, vec2(0.625, 0.5), "a quarter and a half of the way");
}
