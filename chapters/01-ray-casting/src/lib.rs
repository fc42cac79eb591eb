//! Chapter 1: cast a ray through every pixel and draw what it meets first.
//!
//! Brings the vocabulary of the course: [`Ray`], [`Hit`], [`Sphere`], watertight [`triangle`]s,
//! [`Camera`], [`Scene`], and the [`Intersect`] trait with its plainest implementation,
//! [`LinearSearch`]. Relies on the workbench alone.

pub mod conformance;
pub mod math;
pub mod moller_trumbore;
pub mod sphere;
pub mod surface_point;
pub mod triangle;

mod attributes;
mod camera;
mod exact_point;
mod geometry;
mod hit;
mod intersect;
mod interval;
mod light;
mod radiance;
mod ray;
mod rgb;
mod scene;
mod scene_builder;
mod stage;
mod surfaces;

pub use attributes::Attributes;
pub use camera::Camera;
pub use exact_point::ExactPoint;
pub use geometry::{Geometry, intersect_sphere};
pub use hit::Hit;
pub use intersect::{Intersect, LinearSearch};
pub use interval::Interval;
pub use light::PointLight;
pub use radiance::{RayCaster, Show, simplifications};
pub use ray::Ray;
pub use rgb::Rgb;
pub use scene::Scene;
pub use sphere::Sphere;
pub use stage::{Extra, STAGE};
pub use surface_point::{EndPoint, SurfacePoint};
pub use surfaces::Surfaces;
pub use triangle::ShearedRay;
