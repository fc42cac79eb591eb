//! What this stage is called, and what it adds to the command line.

use clap::Args;
use workbench::Stage;

use crate::radiance::Terms;

/// The name of this stage, and what it does when the command line says nothing.
pub const STAGE: Stage = Stage {
    name: "blinn-phong",
    about: "Lights the nearest surface along each ray: ambient, diffuse and specular, with shadows",
    scene: "whitted",
    samples: 16,
    depth: None,
    estimates: false,
};

/// The option of this chapter.
#[derive(Args, Clone, Copy, Debug)]
pub struct Extra {
    /// Which terms of I = Ia + Id + Is to draw
    #[arg(long, value_enum, default_value_t)]
    pub terms: Terms,
}
