//! What can stand between a surface and a light.

use bv_tree::Plane;
use ray_casting::Scene;

use crate::light::Light;
use crate::lights::Lights;

/// The most primitives among which some are looked for that cannot. Every corner is held against
/// every triangle, and among many primitives a few that are left out save little.
const MOST: u32 = 1024;

// ANCHOR: between
/// The primitives that can throw a shadow, if they are not all of them: a shadow ray that ends at a
/// light has to look for nothing else. In ascending order.
///
/// Left out are
///
/// - **walls**, triangles that have everything on one side of their plane, all surfaces and all
///   lights:
///
///   ```text
///   n·(p − a) ≥ 0 for every p of the scene,   or ≤ 0 for every p
///   ```
///
///   The points on one side of a plane are a convex set: with two points, all of the straight way
///   between them belongs to it. The way can begin or end at a wall, but not pass through it. (From
///   outside the walls no lamp is above the horizon, and there is no shadow ray.)
/// - the **only lamp**, if it is flat: every shadow ray ends at its plane.
///
/// One difference to a search among all remains. In a corner, rounding may put the start of a ray
/// into the other wall. Who looks for that wall finds the point in its shadow, which it is not.
#[must_use]
pub fn between(scene: &Scene, lights: &Lights) -> Option<Vec<u32>> {
    let geometry = &scene.geometry;
    if geometry.primitives() > MOST {
        return None;
    }
    let corners = geometry.vertices.iter().map(|&vertex| (vertex, 0.0));
    let points = scene.point_lights().map(|light| (light.position, 0.0));
    let spheres = geometry.spheres.iter().map(|sphere| (sphere.center, sphere.radius));
    let balls: Vec<_> = corners.chain(points).chain(spheres).collect();
    let is_wall = |triangle: u32| {
        let plane = Plane::through(geometry.corners(triangle));
        let sides = balls.iter().map(|&(center, radius)| plane.sides_of(center, radius));
        let is_beyond = |side: usize| sides.clone().any(|sides| sides[side]);
        !is_beyond(0) || !is_beyond(1)
    };
    let is_only_lamp =
        |triangle: u32| matches!(lights.all(), [Light::Flat(_)]) && lights.is_lamp(triangle);
    let is_left_out = |primitive: &u32| {
        geometry.sphere(*primitive).is_none() && (is_wall(*primitive) || is_only_lamp(*primitive))
    };
    let rest: Vec<u32> = (0..geometry.primitives()).filter(|i| !is_left_out(i)).collect();
    (rest.len() < geometry.primitives() as usize).then_some(rest)
}
// ANCHOR_END: between
