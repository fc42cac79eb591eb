//! The scene file: TOML in, plain records out.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

use toml::de::DeTable;

use crate::exposure::{LARGEST_PICTURE, check_size};
use crate::mesh::{self, Collection};
use crate::text_lines::LONGEST_LINE;
use crate::texture::Textures;
use crate::toml_table::{Item, Source, Table, shortened};
use crate::{
    CameraRecord, Exposure, MaterialRecord, MeshRecord, PointLightRecord, QuadRecord, SceneError,
    SphereRecord, SurfaceKind, TextureRecord, corners, suggestion,
};

/// The largest scene file in bytes; parsing may take 75 times as much memory.
const LARGEST_FILE: usize = 48 << 20;

/// A scene file as plain records, with the meshes it names.
///
/// One file describes one scene for all stages: a stage reads the records that its chapter knows.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    /// The file.
    pub path: PathBuf,
    /// Iₐ of eq. 3; at least 0.
    pub ambient: [f32; 3],
    /// Radiance of a ray that leaves the scene; at least 0.
    pub background: [f32; 3],
    /// Camera rays or paths a pixel, at least 1, when the file says so.
    pub samples: Option<u32>,
    /// Who looks.
    pub camera: CameraRecord,
    /// Those of the scene file in the order of their names, then those of the meshes.
    pub materials: Vec<MaterialRecord>,
    /// The pictures that the materials name, each once.
    pub textures: Vec<TextureRecord>,
    /// In the order of the file.
    pub point_lights: Vec<PointLightRecord>,
    /// In the order of the file.
    pub spheres: Vec<SphereRecord>,
    /// In the order of the file.
    pub quads: Vec<QuadRecord>,
    /// In the order of the file.
    pub meshes: Vec<MeshRecord>,
    /// What the user should know and what is no error, as sentences: say them with
    /// [`Run::note`](crate::Run::note).
    pub notices: Vec<String>,
}

impl SceneFile {
    /// Reads and checks a scene file and the meshes it names; of textures, only the headers.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let failed = |error| SceneError::read(path, error);
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(failed)?;
        file.take(LARGEST_FILE as u64 + 1).read_to_end(&mut bytes).map_err(failed)?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = 1 + valid.iter().filter(|&&byte| byte == b'\n').count();
            SceneError::line(path, line, "is not UTF-8 text; a scene file is TOML")
        })?;
        Self::parse(path, &text)
    }

    /// The same for a text at hand; `path` says beside which file meshes and textures lie.
    pub fn parse(path: &Path, text: &str) -> Result<Self, SceneError> {
        check_length(path, text)?;
        let source = Source { path, text };
        let document = DeTable::parse(text).map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            source.error(offset, format!("is not TOML: {}", error.message().trim()))
        })?;
        SceneReader::read(&Table::root(source, document.get_ref()), path)
    }

    /// Size and samples, as the file wishes.
    #[must_use]
    pub fn exposure(&self) -> Exposure {
        Exposure { size: self.camera.size, samples: self.samples }
    }
}

/// Keeps the memory that parsing takes within bounds.
fn check_length(path: &Path, text: &str) -> Result<(), SceneError> {
    if text.len() > LARGEST_FILE {
        let reason =
            format!("is larger than {LARGEST_FILE} bytes; large meshes belong in OBJ files");
        return Err(SceneError::file(path, reason));
    }
    match text.lines().position(|line| line.len() > LONGEST_LINE) {
        Some(i) => {
            Err(SceneError::line(path, i + 1, format!("is longer than {LONGEST_LINE} bytes")))
        }
        None => Ok(()),
    }
}

/// Reads the tables of a scene file, materials first.
struct SceneReader<'a> {
    path: &'a Path,
    materials: Vec<MaterialRecord>,
    by_name: BTreeMap<String, u32>,
    textures: Textures,
    notices: Vec<String>,
}

impl<'a> SceneReader<'a> {
    fn read(root: &Table<'a>, path: &'a Path) -> Result<SceneFile, SceneError> {
        root.check_keys(&[
            "ambient",
            "background",
            "samples",
            "camera",
            "materials",
            "point_light",
            "sphere",
            "quad",
            "mesh",
        ])?;
        let mut reader = Self {
            path,
            materials: Vec::new(),
            by_name: BTreeMap::new(),
            textures: Textures::default(),
            notices: Vec::new(),
        };
        let ambient = optional(root, "ambient", Item::color)?.unwrap_or_default();
        let background = optional(root, "background", Item::color)?.unwrap_or_default();
        let samples = optional(root, "samples", |item| item.whole(1))?;
        let camera = camera(&root.require("camera")?.table("[camera]")?)?;
        if let Some(materials) = root.get("materials") {
            reader.read_materials(&materials.table("[materials]")?)?;
        }
        let each = |key, name| root.tables(key, name);
        let point_lights = each("point_light", "[[point_light]]")?
            .iter()
            .map(point_light)
            .collect::<Result<_, _>>()?;
        let spheres = each("sphere", "[[sphere]]")?
            .iter()
            .map(|t| reader.sphere(t))
            .collect::<Result<_, _>>()?;
        let quads =
            each("quad", "[[quad]]")?.iter().map(|t| reader.quad(t)).collect::<Result<_, _>>()?;
        let meshes =
            each("mesh", "[[mesh]]")?.iter().map(|t| reader.mesh(t)).collect::<Result<_, _>>()?;
        Ok(SceneFile {
            path: path.to_owned(),
            ambient,
            background,
            samples,
            camera,
            materials: reader.materials,
            textures: reader.textures.records,
            point_lights,
            spheres,
            quads,
            meshes,
            notices: reader.notices,
        })
    }

    fn read_materials(&mut self, table: &Table<'a>) -> Result<(), SceneError> {
        for item in table.items() {
            let record = self.material(item.key, &item.table("the material")?)?;
            self.by_name.insert(record.name.clone(), self.materials.len() as u32);
            self.materials.push(record);
        }
        Ok(())
    }

    fn material(&mut self, name: &str, table: &Table<'a>) -> Result<MaterialRecord, SceneError> {
        table.check_keys(&["surface", "kd", "ks", "ns", "kr", "ni", "kt", "ke", "map_kd"])?;
        let default = MaterialRecord::new(name);
        let color = |key, default| Ok(optional(table, key, Item::color)?.unwrap_or(default));
        let at_least_zero =
            |item: &Item<'_>| item.number_that(|n| n >= 0.0, "it must be at least 0");
        let above_zero = |item: &Item<'_>| item.number_that(|n| n > 0.0, "it must be above 0");
        Ok(MaterialRecord {
            surface: optional(table, "surface", surface_kind)?.unwrap_or_default(),
            kd: color("kd", default.kd)?,
            ks: color("ks", default.ks)?,
            ns: optional(table, "ns", at_least_zero)?.unwrap_or(default.ns),
            kr: color("kr", default.kr)?,
            ni: optional(table, "ni", above_zero)?.unwrap_or(default.ni),
            kt: color("kt", default.kt)?,
            ke: color("ke", default.ke)?,
            map_kd: optional(table, "map_kd", |item| self.texture(item))?,
            ..default
        })
    }

    fn texture(&mut self, item: &Item<'_>) -> Result<u32, SceneError> {
        let path = self.beside(item.text()?);
        self.textures.index_of(&path).map_err(|reason| item.error(reason))
    }

    /// The path of a file that the scene file names.
    fn beside(&self, name: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    fn material_index(&self, item: &Item<'_>) -> Result<u32, SceneError> {
        let name = item.text()?;
        self.by_name.get(name).copied().ok_or_else(|| {
            let remark = suggestion::remark(name, self.by_name.keys().map(String::as_str));
            item.error(format!(
                "names `{}`, which [materials] does not have; {remark}",
                shortened(name)
            ))
        })
    }

    fn sphere(&self, table: &Table<'a>) -> Result<SphereRecord, SceneError> {
        table.check_keys(&["center", "radius", "material"])?;
        let center: [f32; 3] = table.require("center")?.vector()?;
        let item = table.require("radius")?;
        let radius = item.number_that(|r| r > 0.0, "it must be above 0")?;
        // A box around it must have corners.
        if center.iter().any(|c| c.abs() + radius >= f32::MAX) {
            return Err(item.error("makes the sphere reach beyond 32-bit numbers"));
        }
        let material = self.material_index(&table.require("material")?)?;
        Ok(SphereRecord { center, radius, material })
    }

    fn quad(&self, table: &Table<'a>) -> Result<QuadRecord, SceneError> {
        table.check_keys(&["vertices", "material"])?;
        let item = table.require("vertices")?;
        let vertices = item.vectors()?;
        if let Some(fault) = corners::quad_fault(vertices) {
            return Err(item.error(fault));
        }
        Ok(QuadRecord { vertices, material: self.material_index(&table.require("material")?)? })
    }

    fn mesh(&mut self, table: &Table<'a>) -> Result<MeshRecord, SceneError> {
        table.check_keys(&["file", "material", "scale", "rotate", "translate"])?;
        let file = table.require("file")?;
        let path = self.beside(file.text()?);
        if !path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj")) {
            return Err(file.error("must name an `.obj` file"));
        }
        let material = optional(table, "material", |item| self.material_index(item))?;
        let above_zero = |item: &Item<'_>| item.number_that(|n| n > 0.0, "it must be above 0");
        let scale = optional(table, "scale", above_zero)?.unwrap_or(1.0);
        let rotate = optional(table, "rotate", Item::vector)?.unwrap_or_default();
        let translate = optional(table, "translate", Item::vector)?.unwrap_or_default();
        let mut collection = Collection {
            materials: &mut self.materials,
            textures: &mut self.textures,
            notices: &mut self.notices,
        };
        let mesh = mesh::load(&path, material, &mut collection).map_err(|error| match error {
            // The line that names the file helps more than the name alone.
            SceneError::Read { path, source } => {
                let path = path.display();
                let remedy = match source.kind() {
                    ErrorKind::NotFound => {
                        "; a name is relative to the scene file, whose comments may say how to make it"
                    }
                    _ => "",
                };
                file.error(format!("names `{path}`, which could not be read: {source}{remedy}"))
            }
            other => other,
        })?;
        if !stays_finite(&mesh.positions, scale, translate) {
            let reason = "is too large: its `scale` and `translate` move it beyond 32-bit numbers";
            return Err(file.error(reason));
        }
        Ok(MeshRecord {
            path,
            positions: mesh.positions,
            normals: mesh.normals,
            texture_coordinates: mesh.texture_coordinates,
            triangles: mesh.triangles,
            materials: mesh.materials,
            scale,
            rotate,
            translate,
        })
    }
}

/// What `read` makes of the value at `key`, if there is one.
fn optional<'a, T>(
    table: &Table<'a>,
    key: &'a str,
    read: impl FnOnce(&Item<'a>) -> Result<T, SceneError>,
) -> Result<Option<T>, SceneError> {
    table.get(key).map(|item| read(&item)).transpose()
}

fn camera(table: &Table<'_>) -> Result<CameraRecord, SceneError> {
    table.check_keys(&["eye", "target", "up", "fov", "size"])?;
    let eye = table.require("eye")?.vector()?;
    let target_item = table.require("target")?;
    let target = target_item.vector()?;
    let up = optional(table, "up", Item::vector)?.unwrap_or([0.0, 1.0, 0.0]);
    if eye == target {
        return Err(target_item.error("is the same point as `eye`; the camera looks nowhere"));
    }
    if corners::are_parallel(corners::difference(target, eye), up.map(f64::from)) {
        return Err(match table.get("up") {
            Some(up) => up.error("is zero or parallel to the view direction; choose another"),
            None => {
                target_item.error("lies straight above or below `eye`; give the camera an `up`")
            }
        });
    }
    let fov_rule = "it must be above 0 and below 180 degrees";
    let fov = table.require("fov")?.number_that(|fov| fov > 0.0 && fov < 180.0, fov_rule)?;
    let size_item = table.require("size")?;
    let size = size_item.whole_vector(1)?;
    check_size(size, LARGEST_PICTURE)
        .map_err(|reason| size_item.error(format!("is too large: {reason}")))?;
    Ok(CameraRecord { eye, target, up, fov, size })
}

fn point_light(table: &Table<'_>) -> Result<PointLightRecord, SceneError> {
    table.check_keys(&["position", "intensity"])?;
    Ok(PointLightRecord {
        position: table.require("position")?.vector()?,
        intensity: table.require("intensity")?.color()?,
    })
}

fn surface_kind(item: &Item<'_>) -> Result<SurfaceKind, SceneError> {
    match item.text()? {
        "diffuse" => Ok(SurfaceKind::Diffuse),
        "mirror" => Ok(SurfaceKind::Mirror),
        "glass" => Ok(SurfaceKind::Glass),
        other => {
            let remark = suggestion::remark(other, ["diffuse", "mirror", "glass"]);
            Err(item
                .error(format!("is `{}`, which is no kind of surface; {remark}", shortened(other))))
        }
    }
}

/// Whether scaling, rotating and moving keep the positions finite: |p| scale + |t| < the largest
/// f32.
fn stays_finite(positions: &[[f32; 3]], scale: f32, translate: [f32; 3]) -> bool {
    let largest = |values: &[f32]| values.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
    let reach = f64::from(largest(positions.as_flattened())) * 3.0_f64.sqrt() * f64::from(scale);
    reach + f64::from(largest(&translate)) < f64::from(f32::MAX)
}
