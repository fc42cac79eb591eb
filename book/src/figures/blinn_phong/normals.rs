//! Interpolated normals: what they hide, and what they must not decide.

use blinn_phong::Material;
use blinn_phong::reflection::{Arriving, diffuse, specular};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, PointLight, Rgb, Scene, SurfacePoint, math};
use workbench::FilmSettings;

use super::still_life::{PANEL, draw, draw_otherwise, light, still_life, tree};
use crate::figures::Drawing;
use crate::picture::Picture;

const SLICES: u32 = 12;
const STACKS: u32 = 7;

/// A unit ball of few triangles, with the normals of the sphere.
fn coarse_ball() -> Scene {
    let mut geometry = Geometry::default();
    for stack in 0..=STACKS {
        for slice in 0..SLICES {
            let angle = |i: u32, n: u32, turn: f32| (turn * i as f32 / n as f32).to_radians();
            let (sin, cos) = math::sin_cos(angle(stack, STACKS, 180.0));
            let (z, x) = math::sin_cos(angle(slice, SLICES, 360.0));
            geometry.vertices.push(vec3(sin * x, cos, sin * z));
            if stack < STACKS {
                let [a, b] = [stack, stack + 1].map(|s| s * SLICES + slice);
                let next = (slice + 1) % SLICES;
                let [c, d] = [stack, stack + 1].map(|s| s * SLICES + next);
                // At the poles one side of the square has no length.
                if stack > 0 {
                    geometry.triangles.push([a, c, b]);
                }
                if stack < STACKS - 1 {
                    geometry.triangles.push([c, d, b]);
                }
            }
        }
    }
    let normals = geometry.vertices.clone();
    let mut scene = still_life(vec3(0.0, 0.8, 8.0), Vec3::ZERO, 17.0, geometry);
    scene.attributes.normals = normals;
    scene.lights.push(light(vec3(-50.0, 30.0, 20.0), 1.0));
    scene
}

/// Equations 1 and 2 with a normal of any origin, and visibility.
fn reflected(
    surface: &SurfacePoint,
    material: &Material,
    light: &PointLight,
    normal: Vec3,
    geometry: &impl Intersect,
) -> Rgb {
    if !light.is_visible_from(surface, geometry) {
        return Rgb::ZERO;
    }
    let arriving = Arriving::new(light, surface.position);
    diffuse(material.kd, &arriving, normal)
        + specular(material.ks, material.ns, &arriving, normal, surface.wo)
}

/// The normal that the mesh states, on whatever side it points to.
fn stated_normal(scene: &Scene, surface: &SurfacePoint) -> Vec3 {
    let corners = scene.geometry.triangles[surface.hit.primitive as usize];
    scene.attributes.normal(corners, surface.hit.barycentric).normalize()
}

const LARGE: FilmSettings = FilmSettings { size: [240, 240], ..PANEL };

/// A coarse ball, flat and smooth.
pub(super) fn normals() -> Drawing {
    let smooth = coarse_ball();
    let mut flat = coarse_ball();
    flat.attributes.normals.clear();
    let panels = [draw(&flat, &LARGE), draw(&smooth, &LARGE)];
    Picture::side_by_side(&panels.each_ref().map(Picture::from), 16).into()
}

/// The lit rim of the smooth ball, enlarged: with the side that is seen decided by the smooth
/// normal, and as the stage draws it.
pub(super) fn rim() -> Drawing {
    let scene = coarse_ball();
    let geometry = tree(&scene);
    let misled = draw_otherwise(&scene, &geometry, &LARGE, |surface, material, light| {
        let stated = stated_normal(&scene, surface);
        let facing = if stated.dot(surface.wo) > 0.0 { stated } else { -stated };
        reflected(surface, material, light, facing, &geometry)
    });
    let panels = [misled, draw(&scene, &LARGE)];
    let enlarged = |image| Picture::from(image).crop([14, 80], [60, 60]).enlarged(5);
    Picture::side_by_side(&panels.each_ref().map(enlarged), 16).into()
}

/// A flat card whose normals pretend that it bulges, under a light behind it: with the question
/// whether light arrives at all decided by the smooth normal, and by the geometric one.
pub(super) fn card() -> Drawing {
    let corner = |x: f32, y: f32| vec3(1.4 * x, y, 0.0);
    let geometry = Geometry {
        vertices: vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        spheres: Vec::new(),
    };
    let mut scene = still_life(vec3(-2.0, 1.0, 7.0), Vec3::ZERO, 20.0, geometry);
    let bulging = |v: &Vec3| vec3(v.x, 0.5 * v.y, 0.8).normalize();
    scene.attributes.normals = scene.geometry.vertices.iter().map(bulging).collect();
    // From behind on the right, where the bulge would face it; and a weak one in front.
    scene.lights.push(light(vec3(40.0, 10.0, -12.0), 1.0));
    scene.lights.push(light(vec3(-30.0, 30.0, 40.0), 0.15));
    let geometry = tree(&scene);
    let panels = [
        draw_otherwise(&scene, &geometry, &PANEL, |surface, material, light| {
            reflected(surface, material, light, scene.shading_normal(surface), &geometry)
        }),
        draw(&scene, &PANEL),
    ];
    Picture::side_by_side(&panels.each_ref().map(Picture::from), 16).into()
}
