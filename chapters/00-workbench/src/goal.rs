//! When a picture is good enough.

use crate::Film;
use crate::portion::Portion;

/// Under `--error`, the fewest samples of each pixel: eight in each half of its spread, so that the
/// variances of most pixels are known to a factor of two, and their mean much better.
const FEWEST_A_PIXEL: u32 = 16;

/// Under `--error`, the fewest samples of the whole picture. The error tells only of light that
/// some pixel has met; with 95 % confidence, these have met all that 1 of 1400 samples meets. And
/// a picture of few pixels cannot average out how badly each knows its variance.
const FEWEST_IN_ALL: u64 = 1 << 12;

/// How many samples of the whole picture must be black before it is believed that all are: each
/// sample then finds light with a probability below 0.005 %, with 95 % confidence.
const BLACK_IN_ALL: u64 = 1 << 16;

/// What a render works towards; whichever is reached first ends it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Goal {
    /// The most samples a pixel.
    pub(crate) samples: u32,
    /// The estimated relative error that is good enough, as a fraction of 1.
    pub(crate) error: Option<f64>,
}

impl Goal {
    // ANCHOR: pursue
    /// Calls `pass` with what it should add to the film, until the goal is reached or it returns
    /// false.
    ///
    /// From the first look at the error on, half of all samples go to every pixel alike, and the
    /// other half to where [`need`](crate::need) sends them. So whatever is sent where it does no
    /// good, no picture needs more than twice the samples that it would need if all pixels got alike.
    pub(crate) fn pursue(&self, film: &mut Film, mut pass: impl FnMut(&mut Film, Portion) -> bool) {
        let mut taken = 0; // on average
        let mut alike = 0; // of those, as many by every pixel
        loop {
            let total = self.next_total(film, taken);
            if total == taken {
                return;
            }
            let is_shared = film.shares() && total > fewest(film);
            let even = if is_shared { alike.max(total.div_ceil(2)) } else { total };
            if !pass(film, Portion::Even(even - alike)) {
                return;
            }
            if is_shared {
                let most = film.share_out(total, self.samples);
                if !pass(film, Portion::Wanted(most)) {
                    return;
                }
            }
            (taken, alike) = (total, even);
        }
    }
    // ANCHOR_END: pursue

    // ANCHOR: next-total
    /// How many samples a pixel should hold next, on average; `taken`, if those it holds are enough.
    ///
    /// Until there is an error to go by, 1, 2, 4, 8 …: after each pass the film holds a whole
    /// picture. From then on ε falls as 1/√n, which tells how many it should take. A twentieth
    /// more, because the estimate is as likely too small as too large; at least a quarter more than
    /// now, because every look at the error is a chance to stop on a lucky one; at most twice as
    /// many, because a poor estimate must not cost too much.
    ///
    /// The answer depends on samples alone, never on threads or time.
    pub(crate) fn next_total(&self, film: &Film, taken: u32) -> u32 {
        let doubled = taken.saturating_mul(2).max(1);
        let next = match self.error {
            Some(wanted) if taken >= fewest(film) => match film.estimated_error() {
                Some(_) if is_reached(film, wanted) => taken,
                Some(error) => {
                    let least = taken.saturating_add(taken.div_ceil(4));
                    predicted_total(taken, error, wanted).clamp(least, doubled)
                }
                // Not one finite sample in any pixel: more of them will not help.
                None => taken,
            },
            Some(_) => doubled.min(fewest(film)),
            None => doubled,
        };
        next.min(self.samples)
    }
    // ANCHOR_END: next-total
}

/// The fewest samples a pixel under `--error`.
fn fewest(film: &Film) -> u32 {
    let needed = FEWEST_IN_ALL.div_ceil(film.pixel_count().max(1));
    u32::try_from(needed).unwrap_or(u32::MAX).max(FEWEST_A_PIXEL)
}

/// How many samples a pixel will have the wanted error, if `taken` have this one.
pub(crate) fn predicted_total(taken: u32, error: f64, wanted: f64) -> u32 {
    let ratio = error / wanted;
    (f64::from(taken) * ratio * ratio * 1.05).ceil() as u32
}

/// Whether the film can state an error that small.
pub(crate) fn is_reached(film: &Film, wanted: f64) -> bool {
    // Black it may be because, for all one knows, the light was not yet found.
    let is_doubtful = || film.total_samples() < BLACK_IN_ALL && film.is_black();
    film.estimated_error().is_some_and(|error| error <= wanted) && !is_doubtful()
}

#[cfg(test)]
mod tests {
    use super::{Goal, is_reached, predicted_total};
    use crate::portion::Portion;
    use crate::{Film, Sampler};

    /// A film of 16 × 16 pixels with `count` samples of a uniform number times `brightness`.
    fn film(count: u32, brightness: f32) -> Film {
        let mut film = Film::estimating([16, 16]).expect("a small film");
        let radiance = |_, sampler: &mut Sampler| [sampler.next_1d() * brightness; 3];
        film.expose(0, Portion::Even(count), &radiance, &|| false, &|_| ());
        film
    }

    #[test]
    fn without_an_error_the_passes_double_up_to_the_samples() {
        let mut film = Film::new([3, 2]).expect("a small film");
        let mut passes = Vec::new();
        Goal { samples: 21, error: None }.pursue(&mut film, |_, portion| {
            passes.push(portion.most());
            true
        });
        assert_eq!(passes, [1, 1, 2, 4, 8, 5], "the passes");
    }

    #[test]
    fn there_is_a_fewest_number_of_samples_in_all() {
        for (size, fewest) in [([1, 1], 4096), ([5, 3], 274), ([16, 16], 16), ([100, 100], 16)] {
            let mut film = Film::estimating(size).expect("a small film");
            let goal = Goal { samples: u32::MAX, error: Some(0.01) };
            goal.pursue(&mut film, |film, portion| {
                film.expose(0, portion, &|_, _: &mut Sampler| [0.3; 3], &|| false, &|_| ());
                true
            });
            assert_eq!(film.samples(), [fewest; 2], "samples of {size:?} equal pixels");
        }
    }

    #[test]
    fn passes_grow_by_what_the_error_tells_within_limits() {
        let film = film(16, 1.0);
        let error = film.estimated_error().expect("16 samples");
        let next = |ratio| Goal { samples: 1000, error: Some(error / ratio) }.next_total(&film, 16);
        let found = [1.0, 1.01, 1.2, 10.0].map(next);
        assert_eq!(found, [16, 20, 25, 32], "enough, a quarter, 1.05 · 1.44 times, twice");
        let limited = Goal { samples: 22, error: Some(error / 10.0) }.next_total(&film, 16);
        assert_eq!(limited, 22, "the samples come first");
        assert_eq!(predicted_total(100, 0.2, 0.1), 420, "half of the error");
        assert_eq!(predicted_total(100, 1.0, 1e-300), u32::MAX, "no error at all");
    }

    #[test]
    fn black_is_believed_later() {
        assert!(!is_reached(&film(255, 0.0), 0.1), "65 280 black samples were believed");
        assert!(is_reached(&film(256, 0.0), 0.1), "65 536 black samples were not believed");
        assert!(is_reached(&film(256, 1.0), 0.1), "the error is {:?}", film(256, 1.0));
    }

    #[test]
    fn a_picture_without_a_finite_sample_ends() {
        let mut film = Film::estimating([16, 16]).expect("a small film");
        let goal = Goal { samples: u32::MAX, error: Some(0.01) };
        goal.pursue(&mut film, |film, portion| {
            film.expose(0, portion, &|_, _: &mut Sampler| [f32::NAN; 3], &|| false, &|_| ());
            true
        });
        assert_eq!(film.samples(), [16, 16], "samples");
        assert_eq!(film.estimated_error(), None, "the error");
    }
}
