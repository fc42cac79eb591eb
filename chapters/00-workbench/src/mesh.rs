//! Meshes: from an OBJ file to arrays.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use crate::corners::{area_vector, dot, is_degenerate};
use crate::obj_lines::{Group, Libraries, ObjLines};
use crate::text_lines::TextLines;
use crate::{MaterialRecord, SceneError, mtl, suggestion, texture::Textures};

/// How many corners of a polygon are tried as the one from which it is divided.
const FAN_CORNERS: usize = 64;

/// The arrays of a mesh, with what they mean as in [`MeshRecord`](crate::MeshRecord).
#[derive(Debug, Default)]
pub(crate) struct Mesh {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) texture_coordinates: Vec<[f32; 2]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) materials: Vec<u32>,
}

/// Where the materials of all meshes are collected.
pub(crate) struct Collection<'a> {
    pub(crate) materials: &'a mut Vec<MaterialRecord>,
    pub(crate) textures: &'a mut Textures,
    pub(crate) notices: &'a mut Vec<String>,
}

/// Reads an OBJ file. With a `material`, all triangles have that one and MTL files are not read.
pub(crate) fn load(
    path: &Path,
    material: Option<u32>,
    collection: &mut Collection<'_>,
) -> Result<Mesh, SceneError> {
    let file = File::open(path).map_err(|error| SceneError::read(path, error))?;
    let lines = TextLines::new(path, BufReader::with_capacity(1 << 16, file));
    let mut libraries = MaterialLibraries::new(path, material, collection);
    let mut reader = ObjLines::new(lines, &mut libraries);

    // Polygons are divided here: `tobj` would always divide them from their first corner.
    let options = tobj::LoadOptions { single_index: true, ..Default::default() };
    let no_library = |_: &Path| Ok(Default::default());
    let loaded = tobj::load_obj_buf(&mut reader, &options, no_library);
    if let Some(fault) = reader.fault {
        return Err(fault);
    }
    let (models, _) =
        loaded.map_err(|error| reader.error(format!("could not be read: {error}")))?;
    let (groups, lines_and_points) = (reader.groups, reader.lines_and_points);

    let mut assembly = Assembly::new(&groups);
    for (model, group) in models.into_iter().zip(&groups) {
        let material = match group.material {
            Some(material) => material,
            None => libraries.grey(),
        };
        assembly.add(model.mesh, *group, material);
    }
    let notices = &mut *libraries.collection.notices;
    let mut notice = |count: u64, what: &str| {
        if count > 0 {
            notices.push(format!("`{}`: {count} {what}", path.display()));
        }
    };
    notice(lines_and_points, "lines or points were left out");
    notice(assembly.degenerate, "triangles without area were dropped");
    notice(assembly.bent, "polygons are too far from convex to be divided correctly");
    if assembly.mesh.triangles.is_empty() {
        return Err(SceneError::file(
            path,
            "has no triangle with an area; there is nothing to show",
        ));
    }
    Ok(assembly.finish())
}

/// The parts of a mesh, put together.
struct Assembly {
    mesh: Mesh,
    normals: bool,
    texture_coordinates: bool,
    degenerate: u64,
    bent: u64,
}

impl Assembly {
    fn new(groups: &[Group]) -> Self {
        Self {
            mesh: Mesh::default(),
            normals: groups.iter().any(|group| group.normals),
            texture_coordinates: groups.iter().any(|group| group.texture_coordinates),
            degenerate: 0,
            bent: 0,
        }
    }

    /// Adds the part that `tobj` has read.
    fn add(&mut self, part: tobj::Mesh, group: Group, material: u32) {
        let first = self.mesh.positions.len();
        self.mesh.positions.extend_from_slice(part.positions.as_chunks().0);
        let count = self.mesh.positions.len();
        // Each vertex of a group has the same parts, so these have one a vertex, or none.
        if group.normals {
            self.mesh.normals.extend_from_slice(part.normals.as_chunks().0);
        } else if self.normals {
            self.mesh.normals.resize(count, [0.0; 3]);
        }
        if group.texture_coordinates {
            self.mesh.texture_coordinates.extend_from_slice(part.texcoords.as_chunks().0);
        } else if self.texture_coordinates {
            self.mesh.texture_coordinates.resize(count, [0.0; 2]);
        }
        self.add_faces(&part, first as u32);
        self.mesh.materials.resize(self.mesh.triangles.len(), material);
    }

    fn add_faces(&mut self, part: &tobj::Mesh, first: u32) {
        if part.face_arities.is_empty() {
            self.mesh.triangles.reserve(part.indices.len() / 3);
            for &triangle in part.indices.as_chunks().0 {
                self.add_triangle(triangle.map(|index: u32| index + first));
            }
            return;
        }
        let mut start = 0;
        for &arity in &part.face_arities {
            let end = start + arity as usize;
            let corners: Vec<u32> = part.indices[start..end].iter().map(|i| i + first).collect();
            self.add_polygon(&corners);
            start = end;
        }
    }

    fn add_triangle(&mut self, triangle: [u32; 3]) {
        if is_degenerate(triangle.map(|index| self.mesh.positions[index as usize])) {
            self.degenerate += 1;
        } else {
            self.mesh.triangles.push(triangle);
        }
    }

    /// Divides a polygon from the first corner from which it can be divided.
    fn add_polygon(&mut self, corners: &[u32]) {
        let starts = || 0..corners.len().min(FAN_CORNERS);
        let smallest = |start| self.smallest_part(corners, start);
        let start = starts()
            .find(|&start| smallest(start) > 0.0)
            .or_else(|| starts().find(|&start| smallest(start) >= 0.0));
        if start.is_none() {
            self.bent += 1;
        }
        for triangle in fan(corners, start.unwrap_or(0)) {
            self.add_triangle(triangle);
        }
    }

    /// The least area of the triangles around corner `start`, scaled; negative if one is turned
    /// over.
    fn smallest_part(&self, corners: &[u32], start: usize) -> f64 {
        let areas = || {
            fan(corners, start).map(|triangle| {
                let [a, b, c] = triangle.map(|index| self.mesh.positions[index as usize]);
                area_vector(a, b, c)
            })
        };
        let whole = areas().fold([0.0; 3], |sum, area| std::array::from_fn(|i| sum[i] + area[i]));
        areas().map(|area| dot(area, whole)).fold(f64::INFINITY, f64::min)
    }

    fn finish(mut self) -> Mesh {
        let materials = &mut self.mesh.materials;
        if materials.iter().all(|material| *material == materials[0]) {
            materials.truncate(1);
        }
        materials.shrink_to_fit();
        self.mesh
    }
}

/// The triangles that join corner number `start` with the sides it does not belong to.
fn fan(corners: &[u32], start: usize) -> impl Iterator<Item = [u32; 3]> {
    let corner = move |i: usize| corners[(start + i) % corners.len()];
    (1..corners.len() - 1).map(move |i| [corner(0), corner(i), corner(i + 1)])
}

/// The materials that one OBJ file names.
struct MaterialLibraries<'a, 'c> {
    path: &'a Path,
    /// The material that the scene file gives to all of the mesh.
    forced: Option<u32>,
    by_name: BTreeMap<String, u32>,
    loaded: bool,
    grey: Option<u32>,
    collection: &'a mut Collection<'c>,
}

impl<'a, 'c> MaterialLibraries<'a, 'c> {
    fn new(path: &'a Path, forced: Option<u32>, collection: &'a mut Collection<'c>) -> Self {
        Self { path, forced, by_name: BTreeMap::new(), loaded: false, grey: None, collection }
    }

    /// The material of faces that have none: the one the scene file gives, else grey.
    fn grey(&mut self) -> u32 {
        if let Some(material) = self.forced.or(self.grey) {
            return material;
        }
        let material = self.collection.materials.len() as u32;
        self.collection
            .materials
            .push(MaterialRecord { kd: [0.5; 3], ..MaterialRecord::new("grey") });
        self.collection.notices.push(format!(
            "`{}`: faces without a material are shown grey; give the mesh a `material`",
            self.path.display()
        ));
        self.grey = Some(material);
        material
    }

    fn load_file(&mut self, path: PathBuf) -> Result<(), String> {
        let materials = mtl::load(&path, self.collection.textures, self.collection.notices)
            .map_err(|error| error.to_string())?;
        for material in materials {
            let index = self.collection.materials.len() as u32;
            self.by_name.insert(material.name.clone(), index);
            self.collection.materials.push(material);
        }
        Ok(())
    }
}

impl Libraries for MaterialLibraries<'_, '_> {
    fn load(&mut self, name: &str) -> Result<(), String> {
        if self.forced.is_some() {
            return Ok(());
        }
        self.loaded = true;
        let beside = |name: &str| self.path.with_file_name(name.replace('\\', "/"));
        // The name may contain spaces, or be several names.
        let whole = beside(name);
        let paths: Vec<PathBuf> = if whole.exists() || name.is_empty() {
            vec![whole]
        } else {
            name.split_whitespace().map(beside).collect()
        };
        for path in paths {
            self.load_file(path).map_err(|error| {
                format!("`mtllib {name}`: {error}; mend it, or give the mesh a `material`")
            })?;
        }
        Ok(())
    }

    fn find(&mut self, name: &str) -> Result<Option<u32>, String> {
        if self.forced.is_some() || !self.loaded {
            return Ok(self.forced);
        }
        self.by_name.get(name).copied().map(Some).ok_or_else(|| {
            let remark = suggestion::remark(name, self.by_name.keys().map(String::as_str));
            format!("`usemtl {name}` names a material that does not exist; {remark}")
        })
    }
}
