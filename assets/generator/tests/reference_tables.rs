//! The scenes that the reference pictures show, number by number against the tables from which these
//! were made (`assets/reference/*.json`).

use generator::{Blob, write_obj, write_whole};
use serde_json::Value;
use std::fs;
use std::path::Path;
use workbench::{Image, MaterialRecord, SceneFile, SurfaceKind};

fn assets() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the generator lies in assets/")
}

fn table(name: &str) -> Value {
    let path = assets().join(format!("reference/{name}.json"));
    let text = fs::read_to_string(&path).expect("the table is readable");
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn scene(name: &str) -> SceneFile {
    let path = assets().join("scenes").join(name).with_extension("toml");
    SceneFile::load(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn number(value: &Value) -> f32 {
    value.as_f64().map_or(f32::NAN, |number| number as f32)
}

fn numbers<const N: usize>(value: &Value) -> [f32; N] {
    std::array::from_fn(|i| number(&value[i]))
}

/// What a shape of the table is made of. Lamps are black: they emit, and reflect nothing.
fn material(table: &Value, shape: &Value) -> MaterialRecord {
    let black = MaterialRecord::new("");
    if !shape["emit"].is_null() {
        return MaterialRecord { ke: numbers(&shape["emit"]), ..black };
    }
    let record = &table["materials"][shape["material"].as_str().unwrap_or_default()];
    match record["type"].as_str() {
        Some("diffuse") => MaterialRecord { kd: numbers(&record["rgb"]), ..black },
        Some("mirror") => {
            MaterialRecord { surface: SurfaceKind::Mirror, kr: numbers(&record["rgb"]), ..black }
        }
        Some("glass") => {
            MaterialRecord { surface: SurfaceKind::Glass, ni: number(&record["ior"]), ..black }
        }
        other => panic!("no material of the course is {other:?}"),
    }
}

/// A record of one shape, as text: what it is, and what it is made of. The name of a material is
/// free.
fn text(shape: impl std::fmt::Debug, material: &MaterialRecord) -> String {
    format!("{shape:?} of {:?}", MaterialRecord { name: String::new(), ..material.clone() })
}

/// The shapes of a kind in the table, in its order.
fn expected(table: &Value, kind: &str, shape: impl Fn(&Value) -> String) -> Vec<String> {
    let shapes = table["shapes"].as_array().expect("shapes");
    let of_kind = shapes.iter().filter(|record| record["type"] == kind);
    of_kind.map(|record| text(shape(record), &material(table, record))).collect()
}

/// Everything that differs between the scene and the table.
fn differences(scene: &SceneFile, table: &Value) -> Vec<String> {
    let of = |index: u32| &scene.materials[index as usize];
    let quads =
        scene.quads.iter().map(|quad| text(format!("{:?}", quad.vertices), of(quad.material)));
    let spheres = scene.spheres.iter();
    let spheres =
        spheres.map(|ball| text(format!("{:?} {:?}", ball.center, ball.radius), of(ball.material)));
    let meshes = scene.meshes.iter().map(|mesh| {
        let place = (mesh.scale, mesh.rotate, mesh.translate);
        assert_eq!(
            place,
            (1.0, [0.0; 3], [0.0; 3]),
            "a mesh of a table stands where its file says"
        );
        assert_eq!(mesh.materials.len(), 1, "a mesh of a table has one material");
        let name = mesh.path.file_name().expect("a file").to_string_lossy();
        text(name, of(mesh.materials[0]))
    });
    let camera = &scene.camera;
    let view = [camera.eye, camera.target, camera.up, [camera.fov, 0.0, 0.0], scene.background];
    let their = &table["camera"];
    let their_view = [
        numbers(&their["eye"]),
        numbers(&their["look_at"]),
        numbers(&their["up"]),
        [number(&their["vfov_deg"]), 0.0, 0.0],
        numbers(&table["environment"]),
    ];
    let corners = |record: &Value| {
        let corners: [[f32; 3]; 4] = std::array::from_fn(|i| numbers(&record["p"][i]));
        format!("{corners:?}")
    };
    let ball = |record: &Value| {
        format!("{:?} {:?}", numbers::<3>(&record["center"]), number(&record["radius"]))
    };
    let file = |record: &Value| record["file"].as_str().unwrap_or_default().to_owned();

    let mut differences = Vec::new();
    for (what, ours, theirs) in [
        ("views", vec![format!("{view:?}")], vec![format!("{their_view:?}")]),
        ("quads", quads.collect(), expected(table, "quad", corners)),
        ("spheres", spheres.collect(), expected(table, "sphere", ball)),
        ("meshes", meshes.collect(), expected(table, "obj", file)),
        ("point lights", scene.point_lights.iter().map(|l| format!("{l:?}")).collect(), vec![]),
    ] {
        if ours.len() != theirs.len() {
            differences.push(format!("{what}: {} here, {} there", ours.len(), theirs.len()));
        }
        let pairs = ours.iter().zip(&theirs).filter(|(ours, theirs)| ours != theirs);
        differences.extend(pairs.map(|(ours, theirs)| format!("{what}: {ours}\nfor   {theirs}")));
    }
    differences
}

/// The numbers of a table, by their places; all that one of them might be forgotten of.
fn places(value: &Value, place: &str, places: &mut Vec<String>) {
    match value {
        Value::Number(_) => places.push(place.to_owned()),
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                self::places(item, &format!("{place}/{i}"), places);
            }
        }
        Value::Object(items) => {
            for (key, item) in items {
                self::places(item, &format!("{place}/{key}"), places);
            }
        }
        _ => (),
    }
}

/// The scene is that of the table, and no number of the table could be another one.
fn check(scene: &SceneFile, name: &str) {
    let table = table(name);
    let found = differences(scene, &table);
    assert!(found.is_empty(), "{name}: {} differences:\n{}", found.len(), found.join("\n"));

    let mut all = Vec::new();
    places(&table, "", &mut all);
    // Not of the scene: the size of the reference picture, and how long its paths are.
    let others = ["/camera/width", "/camera/height", "/max_scatter"];
    let (others, all): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|place| others.contains(&place.as_str()));
    assert_eq!(others.len(), 3, "{name}: {others:?}");
    for place in all {
        let mut changed = table.clone();
        let value = changed.pointer_mut(&place).expect("a place of this table");
        let number = value.as_f64().expect("a number");
        *value = Value::from(number + 0.001 * (1.0 + number.abs()));
        assert!(!differences(scene, &changed).is_empty(), "{name}: {place} is not compared");
    }
}

#[test]
fn the_cornell_boxes_are_those_of_the_references() {
    check(&scene("cornell-box"), "cornell");
    check(&scene("cornell-spheres"), "cornell-spheres");
}

#[test]
fn the_many_lights_are_those_of_the_reference() {
    check(&scene("many-lights"), "many-lights");
}

#[test]
fn the_furnace_is_that_of_the_table() {
    check(&scene("furnace"), "furnace-0.5");
}

/// Its blob is made, not kept; a test of `meshes.rs` holds its checksum against the one of the
/// references.
#[test]
fn the_mesh_is_that_of_the_reference() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for name in ["scenes", "meshes"] {
        fs::create_dir(folder.path().join(name)).expect("a folder");
    }
    let blob = folder.path().join("meshes/blob.obj");
    write_whole(&blob, |out| write_obj(out, &Blob { n: 20 }).map(drop)).expect("a small blob");
    let copy = folder.path().join("scenes/mesh.toml");
    fs::copy(assets().join("scenes/mesh.toml"), &copy).expect("the scene is copied");
    check(&SceneFile::load(&copy).unwrap_or_else(|error| panic!("{error}")), "mesh");
}

/// The pictures have the size of their table, and paths of the length that the stages' tests use.
#[test]
fn the_reference_pictures_have_the_size_of_their_tables() {
    for name in ["cornell", "cornell-spheres", "many-lights", "mesh"] {
        let path = assets().join("reference").join(name).with_extension("exr");
        let image = Image::load_exr(&path).unwrap_or_else(|error| panic!("{error}"));
        let table = table(name);
        let size = ["width", "height"].map(|key| table["camera"][key].as_u64());
        assert_eq!([image.width, image.height].map(|n| Some(n.into())), size, "{name}: the size");
        assert_eq!(table["max_scatter"], 16, "{name}: scattering events");
    }
}

/// The numbers of a cell of the README's row about a picture.
fn readme(name: &str, cell: usize) -> Vec<f64> {
    let text = fs::read_to_string(assets().join("reference/README.md")).expect("the README");
    let start = format!("| `{name}` |");
    let row = text.lines().find(|line| line.starts_with(&start)).expect("a row for the picture");
    let cell = row.split('|').nth(cell).expect("a cell").trim().trim_end_matches(" %");
    cell.split(", ").map(|number| number.parse().expect("a number")).collect()
}

/// The README's means, and how well they are known: variances of pixels that share no samples add
/// up. (The mean of the standard errors over √N would be up to five times less.)
#[test]
fn the_readme_states_the_means_and_their_errors() {
    for name in ["cornell", "cornell-spheres", "many-lights", "mesh"] {
        let [image, errors] = ["exr", "stderr.exr"].map(|extension| {
            let path = assets().join(format!("reference/{name}.{extension}"));
            Image::load_exr(&path).unwrap_or_else(|error| panic!("{error}"))
        });
        let (means, percents) = (readme(name, 6), readme(name, 10));
        let pixels = image.pixels.len() as f64;
        for channel in 0..3 {
            let of = |image: &Image| -> Vec<f64> {
                image.pixels.iter().map(|pixel| f64::from(pixel[channel])).collect()
            };
            let mean = of(&image).iter().sum::<f64>() / pixels;
            let squares: f64 = of(&errors).iter().map(|error| error * error).sum();
            let percent = 100.0 * squares.sqrt() / pixels / mean;
            let said = (means[channel], percents[channel]);
            let agrees = (mean - said.0).abs() < 6e-6 && (percent - said.1).abs() < 6e-5;
            assert!(agrees, "{name}, channel {channel}: {mean}, {percent} %; the README: {said:?}");
        }
    }
}
