//! Cameras: C1 to C8.

use std::path::Path;

use glam::{DVec3, Vec3};
use ray_casting::{Camera, Ray, Sphere};
use workbench::{CameraRecord, FilmPoint, SceneFile};

use crate::bits::{U, ulp};
use crate::random::Random;
use crate::trial::Trial;

crate::catalogue! {
    C1 random/1 the_middle_of_an_odd_picture_is_where_the_camera_looks;
    C2 elsewhere "chapters/01-ray-casting/tests/scenes/camera.rs"
        the_corners_of_the_picture_are_where_the_angle_of_view_says;
    C3 elsewhere "chapters/01-ray-casting/tests/scenes/camera.rs"
        extreme_angles_of_view_give_sound_directions_in_order;
    C4 random/64 a_camera_that_does_not_know_up_is_an_error;
    C5 elsewhere "chapters/00-workbench/src/film_point.rs" a_point_stays_in_its_pixel;
    C6 random/1 a_million_away_depth_is_as_good_as_the_places_of_things;
    C7 random/1 the_frame_of_any_camera_is_right_angled;
    C8 elsewhere "chapters/01-ray-casting/tests/scenes/camera.rs"
        pixels_are_square_in_pictures_of_every_shape;
}

/// A camera anywhere, up to 10⁶ from the origin, that looks at something near or far.
fn some_record(random: &mut Random) -> CameraRecord {
    let eye = random.magnitude(-3.0, 6.0) * random.direction();
    let target = eye + random.magnitude(-3.0, 6.0) * random.direction();
    let up = random.magnitude(-6.0, 6.0) * random.direction();
    let array = |v: DVec3| v.as_vec3().to_array();
    CameraRecord {
        eye: array(eye),
        target: array(target),
        up: array(up),
        fov: random.between(1.0, 179.0) as f32,
        size: [1; 2],
    }
}

/// Whether the view has a direction and `up` another one, by more than the loader asks.
fn knows_up(record: &CameraRecord) -> bool {
    let vector = |v: [f32; 3]| Vec3::from_array(v).as_dvec3();
    let (view, up) = (vector(record.target) - vector(record.eye), vector(record.up));
    view.cross(up).length() > 2e-6 * view.length() * up.length()
}

/// Pictures of odd size, up to 16383 pixels wide and high: the middle of the middle pixel lies in
/// `forward` to 2 u, one rounding of each component and those of the length. Error in u.
fn the_middle_of_an_odd_picture_is_where_the_camera_looks(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let record = some_record(&mut trial.random);
        if !knows_up(&record) {
            continue;
        }
        let camera = Camera::from(&record);
        let size = [(); 2].map(|()| 1 + 2 * trial.random.below(8192) as u32);
        let point = FilmPoint::in_pixel(size.map(|n| n / 2), [0.5; 2], size);
        let beside = camera.ray(point).direction - camera.forward;
        let error = f64::from(beside.abs().max_element()) / U;
        trial.within(error, 2.0, || format!("{size:?}, {record:?}"));
    }
}

/// `up` of zero, parallel or opposite to the view, or as nearly as floats can be: the scene is refused,
/// or the camera is as good as any other one. Exactly parallel ones are refused for certain: multiples
/// by a power of two of a view along exact numbers.
fn a_camera_that_does_not_know_up_is_an_error(trial: &mut Trial) {
    for i in 0..trial.rays {
        let random = &mut trial.random;
        let mut record = some_record(random);
        let is_hopeless = i % 2 == 0;
        let power = random.below(60) as f64 - 30.0;
        let scale = [-1.0, 1.0][random.below(2) as usize] * libm::exp2(power);
        if is_hopeless {
            // Small whole numbers, so that the view is exact.
            let whole = |p: DVec3| (100.0 * p).round();
            let eye = whole(random.in_cube());
            let view = whole(random.in_cube()) + DVec3::new(0.0, 0.0, 101.0);
            let scale = if random.below(8) == 0 { 0.0 } else { scale };
            record.eye = eye.as_vec3().to_array();
            record.target = (eye + view).as_vec3().to_array();
            record.up = (scale * view).as_vec3().to_array();
        } else {
            let vector = |v: [f32; 3]| Vec3::from_array(v).as_dvec3();
            let view = vector(record.target) - vector(record.eye);
            let beside = random.magnitude(-9.0, -3.0) * view.length() * random.direction();
            record.up = (scale * (view + beside)).as_vec3().to_array();
        }
        match parsed(&record) {
            None => trial.require(is_hopeless || !knows_up(&record), || {
                format!("refused, and has an up: {record:?}")
            }),
            Some(parsed) => {
                trial.require(!is_hopeless, || format!("up is not known, and taken: {record:?}"));
                check_frame(trial, &parsed);
            }
        }
    }
}

/// What the loader makes of the record, written as a scene file.
fn parsed(record: &CameraRecord) -> Option<CameraRecord> {
    let CameraRecord { eye, target, up, fov, size } = record;
    let text = format!(
        "[camera]\neye = {eye:?}\ntarget = {target:?}\nup = {up:?}\nfov = {fov:?}\nsize = {size:?}\n"
    );
    SceneFile::parse(Path::new("camera.toml"), &text).ok().map(|file| file.camera)
}

/// Requires unit vectors at right angles, right-handed, to 4 u: each component has been rounded once, by
/// at most u times itself. Error in u.
fn check_frame(trial: &mut Trial, record: &CameraRecord) {
    let camera = Camera::from(record);
    let [f, r, u] = [camera.forward, camera.right, camera.up].map(Vec3::as_dvec3);
    let lengths = [f, r, u].map(|e| e.length() - 1.0);
    let angles = [f.dot(r), f.dot(u), r.dot(u), r.cross(u).dot(-f) - 1.0];
    for error in lengths.into_iter().chain(angles) {
        trial.within(error.abs() / U, 4.0, || format!("{camera:?} of {record:?}"));
    }
}

/// A camera and a ball of radius 3 in front of it, ten units apart: the depths of a hundred pixels, with
/// both at 10⁶ in any direction, against those in double precision with both where they were meant to
/// be. Their root mean square error is at most 4 units in the last place of 10⁶, of which the rounding
/// of the two places alone takes one. Error in those units.
fn a_million_away_depth_is_as_good_as_the_places_of_things(trial: &mut Trial) {
    const PIXELS: u64 = 100;
    for _ in 0..trial.rays.div_ceil(PIXELS) {
        let random = &mut trial.random;
        let eye = 1e6 * random.direction();
        let ball = eye + 10.0 * random.direction();
        let up = random.direction();
        let [at, target, up] = [eye, ball, up].map(|v| v.as_vec3().to_array());
        let record = CameraRecord { eye: at, target, up, fov: 20.0, size: [10; 2] };
        if !knows_up(&record) {
            continue;
        }
        let camera = Camera::from(&record);
        let sphere = Sphere { center: ball.as_vec3(), radius: 3.0 };
        let mut sum = 0.0;
        for i in 0..PIXELS as u32 {
            let point = FilmPoint::in_pixel([i % 10, i / 10], [0.5; 2], [10; 2]);
            let ray = camera.ray(point);
            let exact = depth(eye, ball, &ray);
            let found = sphere.intersect(&ray);
            // Half an angle of 10° is well within the ball's 17°.
            let error = found.map_or(f64::INFINITY, |t| (f64::from(t) - exact).abs());
            sum += error * error;
        }
        let error = (sum / PIXELS as f64).sqrt() / ulp(1e6);
        trial.within(error, 4.0, || format!("{sphere:?}, {record:?}"));
    }
}

/// The t at which a ray from `eye` along that of `ray` meets the ball, in double precision, with the
/// first product instead of the difference of squares.
fn depth(eye: DVec3, ball: DVec3, ray: &Ray) -> f64 {
    let (f, d) = (eye - ball, ray.direction.as_dvec3());
    let b = -f.dot(d) / d.length_squared();
    let nearest = f + b * d;
    b - ((9.0 - nearest.length_squared()) / d.length_squared()).sqrt()
}

/// Any eye, any view, an `up` from anywhere but along the view.
fn the_frame_of_any_camera_is_right_angled(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let record = some_record(&mut trial.random);
        if knows_up(&record) {
            check_frame(trial, &record);
        }
    }
}
