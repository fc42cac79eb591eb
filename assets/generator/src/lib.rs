//! Makes the meshes, scenes and textures of the course that nobody needs to download.
//!
//! Everything here is a function of its arguments alone: the same arguments give the same bytes
//! on every machine. Sines come from the pinned `libm`, noise from whole-number hashes.
//!
//! - [`blob`]: a bumpy ball, closed, of any number of triangles.
//! - [`terrain`]: a fractal landscape of any number of triangles.
//! - [`sphereflake`]: Haines' recursive spheres, analytic or tessellated.
//! - [`checker`]: the checkered floor of Whitted's picture.

mod blob;
mod checker;
mod decimal;
mod file;
mod globe;
mod mesh;
mod obj;
mod options;
mod sphereflake;
mod terrain;

pub use blob::{Blob, blob};
pub use checker::checker;
pub use file::{FileError, write_whole};
pub use globe::{TessellatedSpheres, rings_for};
pub use mesh::{Mesh, Surface};
pub use obj::{ObjSize, write_obj};
pub use options::{Options, run};
pub use sphereflake::{Sphere, sphereflake, write_sphereflake};
pub use terrain::{Terrain, side_for, terrain};
