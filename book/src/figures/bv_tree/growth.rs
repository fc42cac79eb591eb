//! How the cost of a ray grows with the scene.

use std::sync::OnceLock;

use ray_casting::Scene;

use super::workload::{Cost, Workload, blob, terrain};
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::plot::{Plot, Series, Style};
use crate::table::{Table, count};

/// Blobs and terrains of about 10³, 3·10³, 10⁴ … 10⁶ triangles.
const BLOBS: [u32; 7] = [23, 40, 71, 123, 224, 388, 708];
const TERRAINS: [u32; 7] = [22, 39, 71, 122, 224, 387, 707];

struct Size {
    triangles: u32,
    cost: Cost,
}

struct Growth {
    name: &'static str,
    sizes: Vec<Size>,
}

fn growths() -> &'static [Growth; 2] {
    static GROWTHS: OnceLock<[Growth; 2]> = OnceLock::new();
    GROWTHS.get_or_init(|| [growth("blob", blob, &BLOBS), growth("terrain", terrain, &TERRAINS)])
}

fn growth(name: &'static str, make: fn(u32) -> Scene, parameters: &[u32]) -> Growth {
    let size = |&parameter: &u32| {
        let scene = make(parameter);
        let cost = Workload::box_cost(&scene, 90);
        Size { triangles: scene.geometry.primitives(), cost }
    };
    Growth { name, sizes: parameters.iter().map(size).collect() }
}

/// One row for each power of ten; nodes, leaves and bytes for each triangle.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&[
        "mesh",
        "triangles",
        "boxes a ray",
        "triangles a ray",
        "depth",
        "nodes",
        "leaves",
        "bytes",
    ]);
    for growth in growths() {
        for Size { triangles, cost } in growth.sizes.iter().step_by(2) {
            let shape = &cost.shape;
            let n = f64::from(*triangles);
            table.row([
                growth.name.to_owned(),
                count(u64::from(*triangles)),
                format!("{:.1}", cost.volume),
                format!("{:.2}", cost.primitive),
                shape.depth.to_string(),
                format!("{:.2}", shape.inner_nodes as f64 / n),
                format!("{:.2}", shape.leaves as f64 / n),
                format!("{:.0}", shape.bytes as f64 / n),
            ]);
        }
    }
    table.into()
}

fn series(name: String, sizes: &[Size], y: impl Fn(&Cost) -> f64) -> Series {
    let points = sizes.iter().map(|size| [f64::from(size.triangles), y(&size.cost)]).collect();
    Series { name, points, style: Style::LineAndMarks }
}

/// All tests a ray beside those of a linear search, both axes logarithmic.
pub(super) fn plot() -> Drawing {
    let [blob, terrain] = growths();
    let linear = |size: &Size| [f64::from(size.triangles); 2];
    let all = |cost: &Cost| cost.volume + cost.primitive;
    Plot {
        description: "Tests a ray against the number of triangles. Linear search is a straight \
                      line from a thousand to a million; both trees stay below a hundred."
            .to_owned(),
        x: Axis::log("triangles"),
        y: Axis::log("tests a ray"),
        series: vec![
            Series {
                name: "linear search".to_owned(),
                points: blob.sizes.iter().map(linear).collect(),
                style: Style::Line,
            },
            series("tree, terrain".to_owned(), &terrain.sizes, all),
            series("tree, blob".to_owned(), &blob.sizes, all),
        ],
    }
    .into()
}

/// The tree's tests alone, over a logarithmic axis: a logarithm is a straight line.
pub(super) fn search_plot() -> Drawing {
    let [blob, terrain] = growths();
    let of = |growth: &Growth, what: &str| format!("{what}, {}", growth.name);
    Plot {
        description: "Box tests and triangle tests a ray against the number of triangles. The \
                      box tests grow slowly, the triangle tests hardly at all."
            .to_owned(),
        x: Axis::log("triangles"),
        y: Axis::linear("tests a ray"),
        series: vec![
            series(of(terrain, "boxes"), &terrain.sizes, |cost| cost.volume),
            series(of(blob, "boxes"), &blob.sizes, |cost| cost.volume),
            series(of(terrain, "triangles"), &terrain.sizes, |cost| cost.primitive),
            series(of(blob, "triangles"), &blob.sizes, |cost| cost.primitive),
        ],
    }
    .into()
}
