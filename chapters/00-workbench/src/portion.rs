//! What one pass over the picture adds to it.

/// How many samples a pass adds to each pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Portion {
    /// So many to every pixel.
    Even(u32),
    /// What it lacks of what it should hold by [`Film::share_out`](crate::Film), and at most so many.
    Wanted(u32),
}

impl Portion {
    /// The most that a pixel gets.
    pub(crate) const fn most(self) -> u32 {
        match self {
            Self::Even(samples) | Self::Wanted(samples) => samples,
        }
    }

    /// A part of it: at most `samples` to a pixel.
    pub(crate) fn part(self, samples: u32) -> Self {
        match self {
            Self::Even(all) => Self::Even(samples.min(all)),
            Self::Wanted(most) => Self::Wanted(samples.min(most)),
        }
    }

    /// The rest, after that part.
    pub(crate) const fn without(self, part: Self) -> Self {
        match self {
            Self::Even(all) => Self::Even(all - part.most()),
            Self::Wanted(most) => Self::Wanted(most - part.most()),
        }
    }
}
