//! The sphereflake: nine spheres on every sphere, of a third its radius.
//!
//! The "balls" of E. Haines, "A Proposal for Standard Graphics Environments", IEEE Computer
//! Graphics and Applications 7(11), 1987, known since as the Standard Procedural Databases. The
//! arrangement, the camera, the colours and the places of the lights are Haines'; the code is not.

use libm::{cos, sin, sqrt};
use std::io::{self, Write};

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre, in scene units.
    pub center: [f32; 3],
    /// Radius, in scene units, positive.
    pub radius: f32,
}

/// Radius of the first sphere. The whole flake then fits into the unit sphere.
const RADIUS: f64 = 0.5;

/// What a child's radius is to its parent's.
const SHRINK: f64 = 1.0 / 3.0;

/// The spheres of a flake of the given depth around the origin: (9^(depth+1) − 1) / 8 of them.
///
/// Six children sit on their parent's equator and three above it, where "above" points away from
/// the grandparent; each touches its parent in one point. Depth 0 is a single sphere, 4 is Haines'
/// size (7381 spheres). A parent comes before its children. +z is up.
#[must_use]
pub fn sphereflake(depth: u32) -> Vec<Sphere> {
    let mut spheres = Vec::new();
    grow(&mut spheres, &arrangement(), [0.0; 3], RADIUS, [0.0, 0.0, 1.0], depth);
    spheres
}

/// Adds a sphere, and then everything that grows on it.
fn grow(
    spheres: &mut Vec<Sphere>,
    arrangement: &[[f64; 3]; 9],
    center: [f64; 3],
    radius: f64,
    up: [f64; 3],
    depth: u32,
) {
    spheres.push(Sphere { center: center.map(tidy), radius: radius as f32 });
    if depth == 0 {
        return;
    }
    for &place in arrangement {
        let direction = turn(place, up);
        let distance = radius * (1.0 + SHRINK);
        let child = [0, 1, 2].map(|k| center[k] + distance * direction[k]);
        grow(spheres, arrangement, child, radius * SHRINK, direction, depth - 1);
    }
}

/// The directions of the nine children, as seen from a parent whose "above" is +z.
///
/// Every 60° of azimuth from 15° on, one on the equator; every 120° from 45° on, one at the
/// elevation whose sine is √⅔ (54.7°).
fn arrangement() -> [[f64; 3]; 9] {
    std::array::from_fn(|child| {
        let (azimuth, sin_elevation_squared) = match child {
            0..6 => (15.0 + 60.0 * child as f64, 0.0),
            _ => (45.0 + 120.0 * (child - 6) as f64, 2.0 / 3.0),
        };
        let across = sqrt(1.0 - sin_elevation_squared);
        let azimuth = f64::to_radians(azimuth);
        [across * cos(azimuth), across * sin(azimuth), sqrt(sin_elevation_squared)]
    })
}

/// Turns `v` by the smallest rotation that takes +z to the unit vector `up`.
///
/// ```text
/// R v = v + w × v + w × (w × v) / (1 + up_z),   w = z × up
/// ```
///
/// It has no value where `up` is −z, which does occur: a child on the equator has a child that
/// points straight down. There it is half a turn about y, as in Haines' program; near −z rounding
/// decides the azimuth, so the test has some room.
fn turn(v: [f64; 3], up: [f64; 3]) -> [f64; 3] {
    if up[2] < -1.0 + 1e-9 {
        return [-v[0], v[1], -v[2]];
    }
    let w = [-up[1], up[0], 0.0];
    let once = cross(w, v);
    let twice = cross(w, once);
    [0, 1, 2].map(|k| v[k] + once[k] + twice[k] / (1.0 + up[2]))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Rounds away the 10⁻¹⁷s that sines leave where an exact answer would be 0.
fn tidy(x: f64) -> f32 {
    ((x * 1e9).round() / 1e9 + 0.0) as f32 // + 0.0 makes a plain 0 of −0
}

/// Writes the scene file of a flake of the given depth: spheres, ground, camera and lights.
///
/// # Errors
/// Those of `out`.
pub fn write_sphereflake(out: &mut impl Write, depth: u32) -> io::Result<()> {
    let spheres = sphereflake(depth);
    let (count, s) = (spheres.len(), if depth == 0 { "" } else { "s" });
    writeln!(out, "# The sphereflake of depth {depth}: {count} sphere{s} on a square of ground.")?;
    writeln!(out, "#\n# Written by: generator sphereflake --depth {depth} -o FILE.toml")?;
    out.write_all(SETTING.as_bytes())?;
    for Sphere { center: [x, y, z], radius } in spheres {
        writeln!(out, "\n[[sphere]]\ncenter = [{x:?}, {y:?}, {z:?}]")?;
        writeln!(out, "radius = {radius:?}\nmaterial = \"gold\"")?;
    }
    Ok(())
}

/// Everything but the spheres. See the module for whose numbers these are.
const SETTING: &str = include_str!("sphereflake.toml");
