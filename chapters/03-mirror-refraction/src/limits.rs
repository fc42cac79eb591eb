//! Where the recursion stops.

use clap::Args;

/// The option that this chapter adds to the command line.
#[derive(Args, Clone, Copy, Debug)]
pub struct Cutoff {
    /// Follow no branch whose weight is at most W, 0 to 1; 0 switches this off [default: half the
    /// smallest step of an 8-bit picture]
    #[arg(
        long,
        value_name = "W",
        default_value_t = Limits::CUTOFF,
        hide_default_value = true,
        value_parser = parse_weight
    )]
    pub cutoff: f32,
}

/// Where the recursion stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Most scattering events, that is reflections and refractions, between the eye and what it
    /// sees. What lies beyond them is black.
    depth: u32,
    /// A branch is not followed if its weight does not exceed this.
    cutoff: f32,
}

impl Limits {
    // ANCHOR: cutoff
    /// Half the smallest step between two codes of an 8-bit sRGB picture, in linear light.
    ///
    /// Near black the sRGB curve is the line 12.92 x, so code 1 stands for 1/(255 · 12.92). A
    /// branch of weight w adds at most w times the radiance it finds: where that is at most 1, the
    /// white of the picture, a smaller weight cannot move a pixel by more than a rounding. Many
    /// branches together can, and so can a reflected highlight that is brighter than white.
    pub const CUTOFF: f32 = 0.5 / (255.0 * 12.92);
    // ANCHOR_END: cutoff

    /// The deepest recursion; its frames fit on the stack of any thread.
    pub const DEEPEST: u32 = 1000;

    /// At most `depth` scattering events, [`Limits::DEEPEST`] if none or more are given, and no
    /// branch whose weight is `cutoff` or less.
    #[must_use]
    pub fn new(depth: Option<u32>, cutoff: f32) -> Self {
        let depth = depth.map_or(Self::DEEPEST, |depth| depth.min(Self::DEEPEST));
        Self { depth, cutoff }
    }

    /// Whether a path may have this many scattering events.
    #[inline]
    #[must_use]
    pub const fn allow_events(&self, events: u32) -> bool {
        events <= self.depth
    }

    /// Whether a branch of this weight can change a pixel. A branch without weight cannot.
    #[inline]
    #[must_use]
    pub fn allow_weight(&self, weight: f32) -> bool {
        weight > self.cutoff
    }
}

fn parse_weight(text: &str) -> Result<f32, String> {
    text.parse()
        .ok()
        .filter(|weight| (0.0..=1.0).contains(weight))
        .ok_or_else(|| "the weight must be a number from 0 to 1".to_owned())
}

#[cfg(test)]
mod tests {
    use super::{Limits, parse_weight};

    #[test]
    fn the_default_cutoff_is_half_the_smallest_step_of_the_picture() {
        let codes = [0.999, 1.001].map(|share| workbench::srgb::encode(share * Limits::CUTOFF));
        assert_eq!(codes, [0, 1], "the codes just below and above {}", Limits::CUTOFF);
    }

    #[test]
    fn a_weight_is_a_number_from_0_to_1() {
        assert_eq!(parse_weight("0"), Ok(0.0), "off");
        assert_eq!(parse_weight("1e-3"), Ok(0.001), "a thousandth");
        for wrong in ["-1", "nan", "inf", "1.5", "a", ""] {
            assert!(parse_weight(wrong).is_err(), "`{wrong}` was accepted as a weight");
        }
    }
}
