//! What paths must get right, scene by scene.
//!
//! Names of tests that begin with `erratum_` belong to the row of that number on the book's page of
//! errata: they show the mistake at work.

mod agreement;
mod as_printed;
mod convergence;
mod errata;
mod furnace;
mod glass;
mod mistakes;
mod reference;
mod roulette;
mod scenes;
mod specular;
mod stopping;
mod transport;
