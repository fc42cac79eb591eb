//! From the records of a scene file to flat arrays.

use std::ops::Range;

use glam::{DMat3, DVec3, Vec2, Vec3};
use workbench::{Exposure, MeshRecord, QuadRecord, SceneError, SceneFile, SphereRecord};

use crate::attributes::Attributes;
use crate::camera::Camera;
use crate::geometry::Geometry;
use crate::light::PointLight;
use crate::math;
use crate::rgb::Rgb;
use crate::scene::Scene;
use crate::sphere::Sphere;

/// Texture coordinates of a quad's four vertices.
const QUAD_COORDINATES: [Vec2; 4] = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];

/// Collects primitives, attributes and lights in the order in which rays number them.
#[derive(Default)]
pub(crate) struct SceneBuilder {
    geometry: Geometry,
    attributes: Attributes,
    /// Radiance of each material, black if it does not shine.
    emitted: Vec<Rgb>,
    lights: Vec<PointLight>,
    notices: Vec<String>,
}

impl SceneBuilder {
    /// Turns a whole file into a scene.
    pub(crate) fn from_file(file: SceneFile) -> Result<Scene, SceneError> {
        let mut builder = Self {
            emitted: file.materials.iter().map(|m| Rgb::from_array(m.ke)).collect(),
            notices: file.notices,
            ..Self::default()
        };
        for light in &file.point_lights {
            let position = Vec3::from_array(light.position);
            builder.lights.push(PointLight::new(position, Rgb::from_array(light.intensity)));
        }
        // Quads before meshes: a large mesh without normals and coordinates then needs no padding.
        for quad in &file.quads {
            builder.add_quad(quad);
        }
        for mesh in file.meshes {
            builder.add_mesh(mesh)?;
        }
        for sphere in &file.spheres {
            builder.add_sphere(sphere);
        }
        Ok(Scene {
            camera: Camera::from(&file.camera),
            focus: Vec3::from_array(file.camera.eye).distance(Vec3::from_array(file.camera.target)),
            exposure: Exposure { size: file.camera.size, samples: file.samples },
            geometry: builder.geometry,
            attributes: builder.attributes,
            materials: file.materials,
            textures: file.textures,
            lights: builder.lights,
            ambient: Rgb::from_array(file.ambient),
            background: Rgb::from_array(file.background),
            notices: builder.notices,
        })
    }

    fn add_quad(&mut self, quad: &QuadRecord) {
        let first = self.geometry.vertices.len() as u32;
        self.geometry.vertices.extend(quad.vertices.map(Vec3::from_array));
        self.attributes.texture_coordinates.resize(first as usize, Vec2::ZERO);
        self.attributes.texture_coordinates.extend(QUAD_COORDINATES);

        let start = self.geometry.primitives();
        self.geometry.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| first + i)));
        self.attributes.materials.extend([quad.material; 2]);
        self.add_flat_lamp(start..start + 2, quad.material);
    }

    fn add_mesh(&mut self, mut mesh: MeshRecord) -> Result<(), SceneError> {
        let first = self.geometry.vertices.len();
        let placement = Placement::of(&mesh);
        let positions = std::mem::take(&mut mesh.positions);
        self.geometry.vertices.extend(positions.into_iter().map(|p| placement.point(p)));
        if let Some(lost) = self.geometry.vertices[first..].iter().position(|v| !v.is_finite()) {
            return Err(SceneError::Content {
                path: mesh.path,
                line: None,
                reason: format!(
                    "scaled and moved, vertex {} lies beyond the largest number; scale it less",
                    lost + 1
                ),
            });
        }
        if !mesh.normals.is_empty() {
            self.attributes.normals.resize(first, Vec3::ZERO);
            self.attributes.normals.extend(mesh.normals.iter().map(|&n| placement.direction(n)));
        }
        if !mesh.texture_coordinates.is_empty() {
            self.attributes.texture_coordinates.resize(first, Vec2::ZERO);
            let coordinates = mesh.texture_coordinates.iter().map(|&c| Vec2::from_array(c));
            self.attributes.texture_coordinates.extend(coordinates);
        }
        self.add_triangles(&mesh, first as u32);
        Ok(())
    }

    /// Adds the mesh's triangles; those that shine are put together by material, each group a lamp.
    ///
    /// Where coordinates are coarse, rounding may have put three corners on a line. Such a triangle
    /// has no normal, and is dropped.
    fn add_triangles(&mut self, mesh: &MeshRecord, first_vertex: u32) {
        let material = |i: usize| match mesh.materials[..] {
            [only] => only,
            _ => mesh.materials[i],
        };
        let has_area = |i: &u32| {
            let corners = mesh.triangles[*i as usize].map(|vertex| first_vertex + vertex);
            let [a, b, c] = corners.map(|v| self.geometry.vertices[v as usize].as_dvec3());
            (b - a).cross(c - a) != DVec3::ZERO
        };
        let mut order: Vec<u32> = (0..mesh.triangles.len() as u32).filter(has_area).collect();
        let lost = mesh.triangles.len() - order.len();
        if lost > 0 {
            let path = mesh.path.display();
            let notice = "triangles lost their area where they were moved to, and were dropped";
            self.notices.push(format!("`{path}`: {lost} {notice}"));
        }
        order.sort_by_key(|&i| {
            let material = material(i as usize);
            if self.emitted[material as usize] == Rgb::ZERO { None } else { Some(material) }
        });
        let mut group = self.geometry.primitives();
        for (position, &i) in order.iter().enumerate() {
            let (triangle, this) = (mesh.triangles[i as usize], material(i as usize));
            self.geometry.triangles.push(triangle.map(|vertex| first_vertex + vertex));
            self.attributes.materials.push(this);

            let next = order.get(position + 1).map(|&j| material(j as usize));
            if next != Some(this) {
                let end = self.geometry.primitives();
                self.add_flat_lamp(group..end, this);
                group = end;
            }
        }
    }

    fn add_sphere(&mut self, sphere: &SphereRecord) {
        let start = self.geometry.primitives();
        let center = Vec3::from_array(sphere.center);
        self.geometry.spheres.push(Sphere { center, radius: sphere.radius });
        self.attributes.materials.push(sphere.material);

        let radiance = self.emitted[sphere.material as usize];
        if radiance != Rgb::ZERO {
            let lamp = start..start + 1;
            self.lights.push(PointLight::sphere_lamp(center, sphere.radius, radiance, lamp));
        }
    }

    /// The light that stands in for these triangles, if their material shines.
    ///
    /// It stands at their centre of area and shines along their mean normal. A closed mesh has
    /// none: a convex body shows a quarter of its area to every side on average (Cauchy), and so it
    /// shines.
    fn add_flat_lamp(&mut self, lamp: Range<u32>, material: u32) {
        let radiance = self.emitted[material as usize];
        if radiance == Rgb::ZERO {
            return;
        }
        let (mut area, mut weighted, mut normal) = (0.0, DVec3::ZERO, DVec3::ZERO);
        for triangle in lamp.clone() {
            let [v0, v1, v2] = self.geometry.corners(triangle).map(|v| v.as_dvec3());
            let vector_area = (v1 - v0).cross(v2 - v0) / 2.0;
            area += vector_area.length();
            weighted += vector_area.length() * (v0 + v1 + v2) / 3.0;
            normal += vector_area;
        }
        let (position, closed) = ((weighted / area).as_vec3(), normal.length() < area / 1024.0);
        self.lights.push(if closed {
            let radius = (area / 4.0 / std::f64::consts::PI).sqrt() as f32;
            PointLight::sphere_lamp(position, radius, radiance, lamp)
        } else {
            let normal = normal.normalize().as_vec3();
            PointLight::flat_lamp(position, normal, area as f32, radiance, lamp)
        });
    }
}

/// Scale, then rotation about x, y and z in that order, then translation.
struct Placement {
    linear: DMat3,
    rotation: DMat3,
    translation: DVec3,
    /// Whether nothing moves: positions are then kept to the bit.
    is_identity: bool,
}

impl Placement {
    fn of(mesh: &MeshRecord) -> Self {
        let [x, y, z] =
            mesh.rotate.map(|degrees| math::sin_cos_f64(f64::from(degrees).to_radians()));
        let about_x =
            DMat3::from_cols(DVec3::X, DVec3::new(0.0, x.1, x.0), DVec3::new(0.0, -x.0, x.1));
        let about_y =
            DMat3::from_cols(DVec3::new(y.1, 0.0, -y.0), DVec3::Y, DVec3::new(y.0, 0.0, y.1));
        let about_z =
            DMat3::from_cols(DVec3::new(z.1, z.0, 0.0), DVec3::new(-z.0, z.1, 0.0), DVec3::Z);
        let rotation = about_z * about_y * about_x;
        Self {
            linear: f64::from(mesh.scale) * rotation,
            rotation,
            translation: DVec3::from_array(mesh.translate.map(f64::from)),
            is_identity: mesh.scale == 1.0 && mesh.rotate == [0.0; 3] && mesh.translate == [0.0; 3],
        }
    }

    fn point(&self, p: [f32; 3]) -> Vec3 {
        if self.is_identity {
            return Vec3::from_array(p);
        }
        (self.linear * DVec3::from_array(p.map(f64::from)) + self.translation).as_vec3()
    }

    fn direction(&self, n: [f32; 3]) -> Vec3 {
        (self.rotation * DVec3::from_array(n.map(f64::from))).normalize_or_zero().as_vec3()
    }
}
