//! What this stage is called, and what it adds to the command line.

use clap::Args;
use workbench::Stage;

use crate::radiance::Show;

/// The name of this stage, and what it does when the command line says nothing.
pub const STAGE: Stage = Stage {
    name: "ray-casting",
    about: "Draws the nearest surface along each ray, and the shadows of the first light",
    scene: "whitted",
    samples: 16,
    depth: None,
    estimates: false,
};

/// The option of this chapter.
#[derive(Args, Clone, Copy, Debug)]
pub struct Extra {
    /// What to draw of the visible surface
    #[arg(long, value_enum, default_value_t)]
    pub show: Show,
}
