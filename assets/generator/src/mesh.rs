//! Triangle meshes, and surfaces that can list their triangles one after another.

use crate::decimal::Decimal;

/// A triangle mesh as plain arrays.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices, in scene units.
    pub positions: Vec<[f32; 3]>,
    /// Three indices into `positions` each, counter-clockwise as seen from the front.
    pub triangles: Vec<[u32; 3]>,
}

/// A surface whose mesh is a formula.
///
/// Vertices and triangles are listed rather than stored, so that a file of 10⁷ triangles is
/// written without ever being held in memory.
pub trait Surface {
    /// The vertices, in scene units.
    fn positions(&self) -> impl Iterator<Item = [f64; 3]>;

    /// The triangles, as indices into [`Surface::positions`].
    fn triangles(&self) -> impl Iterator<Item = [u32; 3]>;

    /// The mesh that a reader of this surface's OBJ file gets, number for number.
    fn mesh(&self) -> Mesh {
        Mesh {
            positions: self.positions().map(|p| p.map(|x| Decimal::from(x).to_f32())).collect(),
            triangles: self.triangles().collect(),
        }
    }
}
