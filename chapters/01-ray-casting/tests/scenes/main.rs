//! What becomes of a scene file: camera, meshes, lights, texture coordinates.

mod camera;
mod coordinates;
mod lights;
mod placement;
mod surfaces;
mod tools;
