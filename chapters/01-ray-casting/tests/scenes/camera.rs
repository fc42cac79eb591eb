//! Where rays through the film go.

use glam::{DVec3, Vec3, vec3};
use ray_casting::Camera;
use workbench::{CameraRecord, FilmPoint, Sampler};

/// u, the largest relative error of one rounding.
const U: f32 = f32::EPSILON / 2.0;

const RECORD: CameraRecord = CameraRecord {
    eye: [0.0; 3],
    target: [0.0, 0.0, -1.0],
    up: [0.0, 1.0, 0.0],
    fov: 90.0,
    size: [4, 2],
};

fn direction(camera: &Camera, x: f32, y: f32, size: [u32; 2]) -> Vec3 {
    camera.ray(FilmPoint { x, y, size }).direction
}

/// Cameras that look in every direction.
fn random_cameras() -> impl Iterator<Item = Camera> {
    (0..1000).map(|i| {
        let mut sampler = Sampler::new(1, i, 0);
        let mut vector = || [(); 3].map(|()| 2.0 * sampler.next_1d() - 1.0);
        Camera::from(&CameraRecord { eye: vector(), target: vector(), up: vector(), ..RECORD })
    })
}

/// accuracy C1.
#[test]
fn the_middle_of_the_picture_is_where_the_camera_looks() {
    for camera in random_cameras() {
        for size in [[1, 1], [5, 3], [641, 481]] {
            let [x, y] = size.map(|n| n as f32 / 2.0);
            let difference = direction(&camera, x, y, size) - camera.forward;
            let error = difference.abs().max_element() / U;
            assert!(error <= 2.0, "{size:?}: {error} u beside {}", camera.forward);
        }
    }
}

/// accuracy C2: a right angle, twice as wide as high.
#[test]
fn the_corners_of_the_picture_are_where_the_angle_of_view_says() {
    let camera = Camera::from(&RECORD);
    for (x, y, corner) in [
        (0.0, 0.0, vec3(-2.0, 1.0, -1.0)),
        (4.0, 0.0, vec3(2.0, 1.0, -1.0)),
        (4.0, 2.0, vec3(2.0, -1.0, -1.0)),
        (0.0, 2.0, vec3(-2.0, -1.0, -1.0)),
    ] {
        let expected = corner / 6.0_f32.sqrt();
        let got = direction(&camera, x, y, RECORD.size);
        let error = (got - expected).abs().max_element() / U;
        assert!(error <= 4.0, "film ({x}, {y}): {got} for {expected}, {error} u");
    }
}

/// accuracy C3. At a millionth of a degree, neighbouring pixels are 2 · 10⁻¹⁰ apart: less than one
/// place of a direction's long component, but its short one still tells them apart.
#[test]
fn extreme_angles_of_view_give_sound_directions_in_order() {
    for fov in [1e-6, 1e-3, 179.9] {
        let camera = Camera::from(&CameraRecord { fov, ..RECORD });
        let mut last = f32::NEG_INFINITY;
        for column in 0_u16..101 {
            let d = direction(&camera, f32::from(column) + 0.5, 50.5, [101, 101]);
            assert!(d.is_finite(), "{fov}°, column {column}: {d}");
            let length = d.as_dvec3().length();
            assert!((length - 1.0).abs() <= 4.0 * f64::from(U), "{fov}°: |{d}| = {length}");
            let slope = d.x / -d.z;
            assert!(slope > last, "{fov}°, column {column}: {slope} is not beyond {last}");
            last = slope;
        }
    }
}

/// accuracy C7.
#[test]
fn the_frame_is_orthonormal_and_right_handed() {
    for camera in random_cameras() {
        let [f, r, u] = [camera.forward, camera.right, camera.up].map(Vec3::as_dvec3);
        for (what, value, expected) in [
            ("|forward|", f.length(), 1.0),
            ("|right|", r.length(), 1.0),
            ("|up|", u.length(), 1.0),
            ("forward · right", f.dot(r), 0.0),
            ("forward · up", f.dot(u), 0.0),
            ("right · up", r.dot(u), 0.0),
            ("(right × up) · −forward", r.cross(u).dot(-f), 1.0),
        ] {
            let error = (value - expected).abs() / f64::from(U);
            assert!(error <= 4.0, "{what} = {value}, {error} u off, of {camera:?}");
        }
    }
}

#[test]
fn up_is_up_in_the_picture_and_right_is_right() {
    for (i, camera) in random_cameras().enumerate() {
        let mut sampler = Sampler::new(1, i as u64, 0);
        let mut vector = || [(); 3].map(|()| f64::from(2.0 * sampler.next_1d() - 1.0));
        let [_, _, up] = [vector(), vector(), vector()].map(DVec3::from_array);
        let cosine = camera.up.as_dvec3().dot(up);
        assert!(cosine > 0.0, "camera {i}: its up is {cosine} along the wanted one");
        let (left, right) =
            (direction(&camera, 0.0, 1.0, [4, 2]), direction(&camera, 4.0, 1.0, [4, 2]));
        assert!((right - left).dot(camera.right) > 0.0, "camera {i}: {left} to {right}");
    }
}

/// accuracy C8: narrow pictures, and square pixels in all of them.
#[test]
fn pixels_are_square_in_pictures_of_every_shape() {
    let camera = Camera::from(&RECORD);
    for size in [[1, 1], [1, 40], [40, 1], [300, 200]] {
        let [x, y] = size.map(|n| n as f32 / 2.0);
        let slope = |d: Vec3| vec3(d.x, d.y, 0.0) / -d.z;
        let middle = slope(direction(&camera, x, y, size));
        let across = slope(direction(&camera, x + 0.5, y, size)) - middle;
        let down = slope(direction(&camera, x, y + 0.5, size)) - middle;
        let half_pixel = 1.0 / size[1] as f32;
        for (what, step) in [("right", across.x), ("down", -down.y)] {
            let error = (step - half_pixel).abs();
            assert!(error <= 8.0 * U, "{size:?}: half a pixel {what} is {step} for {half_pixel}");
        }
    }
}
