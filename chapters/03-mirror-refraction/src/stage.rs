//! What this stage is called, and what it adds to the command line.

use workbench::Stage;

/// The name of this stage, and what it does when the command line says nothing.
pub const STAGE: Stage = Stage {
    name: "mirror-refraction",
    about: "Follows light into mirrors and through glass, by recursion",
    scene: "whitted",
    samples: 16,
    depth: Some(8),
    estimates: false,
};
