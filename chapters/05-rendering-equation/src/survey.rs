//! What a scene has, found out once a render, so that code for anything else is not even there.

use clap::Args;
use ray_casting::{Rgb, Scene};
use workbench::SurfaceKind;

/// What a scene has beside matte surfaces that shine. Materials that nothing is made of do not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Survey {
    /// A boundary of glass.
    pub glass: bool,
    /// A mirror.
    pub mirrors: bool,
    /// A highlight.
    pub highlights: bool,
    /// A picture on a surface.
    pub textures: bool,
    /// Light from outside.
    pub sky: bool,
}

impl Survey {
    /// Looks at every primitive.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let used: Vec<_> = scene.used_materials().collect();
        let kind = |kind| used.iter().any(|material| material.surface == kind);
        Self {
            glass: kind(SurfaceKind::Glass),
            mirrors: kind(SurfaceKind::Mirror),
            highlights: used.iter().any(|material| material.ks != [0.0; 3]),
            textures: used.iter().any(|material| material.map_kd.is_some()),
            sky: scene.background != Rgb::ZERO,
        }
    }

    /// Whether code for `H` can draw the scene.
    #[must_use]
    pub const fn is_within<H: Has>(&self) -> bool {
        (H::GLASS || !self.glass)
            && (H::MIRRORS || !self.mirrors)
            && (H::HIGHLIGHTS || !self.highlights)
            && (H::TEXTURES || !self.textures)
            && (H::SKY || !self.sky)
    }
}

/// Which code runs, as far as the command line says.
#[derive(Args, Clone, Copy, Debug)]
pub struct Code {
    /// Run the code for any scene, also where the scene has no glass or nothing but matte surfaces.
    /// The picture is the same
    #[arg(long)]
    pub for_any_scene: bool,
}

// ANCHOR: has
/// What a tracer is compiled for. Whatever a scene has none of is a constant, and the compiler drops
/// all that depends on it.
///
/// Five things that a scene may have or not would make 32 programs. Three are enough: for scenes with
/// nothing special, for those without glass, and for all.
///
/// On `cornell-box` the code for matte surfaces executes 14.2 % fewer instructions than that for any
/// scene in this chapter, 10.2 % in chapter 6 and 9.3 % in chapter 7 (`--for-any-scene`, with 32 × 32
/// pixels, 16 samples, depth 8 and one thread, under `valgrind --tool=callgrind`). It is as fast as if
/// there were no other: with `Materials::at` that knows nothing but k_d, the counts differ by 0.1 %,
/// 0.2 % and 0.0 % (depth 4; in chapter 6 they are larger).
pub trait Has: Sync + 'static {
    /// Boundaries of glass.
    const GLASS: bool;
    /// Mirrors.
    const MIRRORS: bool;
    /// Highlights.
    const HIGHLIGHTS: bool;
    /// Pictures on surfaces.
    const TEXTURES: bool;
    /// Light from outside.
    const SKY: bool;
    /// What is left out, for the summary.
    const LEFT_OUT: Option<&'static str>;
}

/// Matte surfaces and lamps, nothing else.
#[derive(Clone, Copy, Debug)]
pub struct MatteOnly;

/// Everything but glass.
#[derive(Clone, Copy, Debug)]
pub struct Opaque;

/// Whatever a scene may have.
#[derive(Clone, Copy, Debug)]
pub struct Anything;
// ANCHOR_END: has

impl Has for MatteOnly {
    const GLASS: bool = false;
    const MIRRORS: bool = false;
    const HIGHLIGHTS: bool = false;
    const TEXTURES: bool = false;
    const SKY: bool = false;
    const LEFT_OUT: Option<&'static str> =
        Some("glass, mirrors, highlights, textures and sky are left out: the scene has none");
}

impl Has for Opaque {
    const GLASS: bool = false;
    const MIRRORS: bool = true;
    const HIGHLIGHTS: bool = true;
    const TEXTURES: bool = true;
    const SKY: bool = true;
    const LEFT_OUT: Option<&'static str> = Some("glass is left out: the scene has none");
}

impl Has for Anything {
    const GLASS: bool = true;
    const MIRRORS: bool = true;
    const HIGHLIGHTS: bool = true;
    const TEXTURES: bool = true;
    const SKY: bool = true;
    const LEFT_OUT: Option<&'static str> = None;
}
