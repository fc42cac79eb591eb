//! How much to do before the next look at the clock.

use std::time::{Duration, Instant};

/// How long a render may run before Ctrl-C and the progress bar are looked after.
const LONGEST: Duration = Duration::from_secs(1);

/// The shortest worth handing out tiles for.
const SHORTEST: Duration = Duration::from_millis(20);

/// With a deadline, how many looks at the clock there are.
const LOOKS: u32 = 50;

/// Divides passes over the picture, so that they end soon after the time is over or Ctrl-C is
/// pressed.
///
/// A pass that doubles the samples takes as long as everything before it. Only whole tiles can be
/// stopped, and all of one tile's samples are taken at once: undivided, a picture of few tiles
/// would miss its deadline by far, answer Ctrl-C after minutes, and hold twice as many samples in
/// some tiles as in others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    start: Instant,
    deadline: Option<Instant>,
    longest: Duration,
}

impl Pace {
    /// The pace of a render that starts now and may take as long as `time`, or as long as it needs.
    pub(crate) fn new(time: Option<Duration>) -> Self {
        let start = Instant::now();
        let deadline = time.and_then(|time| start.checked_add(time));
        let longest = time.map_or(LONGEST, |time| (time / LOOKS).clamp(SHORTEST, LONGEST));
        Self { start, deadline, longest }
    }

    /// Whether the time is over.
    pub(crate) fn is_over(&self) -> bool {
        self.deadline.is_some_and(|end| Instant::now() >= end)
    }

    /// How many samples a pixel to take before the next look at the clock, at least 1, `taken`
    /// having been taken since the start.
    pub(crate) fn samples(&self, taken: u32) -> u32 {
        let now = Instant::now();
        let left = self.deadline.map_or(self.longest, |end| end.saturating_duration_since(now));
        fitting(taken, now.duration_since(self.start), left.min(self.longest))
    }

    /// The samples a pixel that there is time for at most, `taken` having been taken since the
    /// start; `None` without a deadline.
    pub(crate) fn total(&self, taken: u32) -> Option<u32> {
        let left = self.deadline?.saturating_duration_since(Instant::now());
        Some(taken.saturating_add(fitting(taken, self.start.elapsed(), left)))
    }
}

/// How many samples fit into `left` if `taken` took as long as `elapsed`; at least 1.
fn fitting(taken: u32, elapsed: Duration, left: Duration) -> u32 {
    let seconds_each = elapsed.as_secs_f64() / f64::from(taken);
    // Of 0/0 the cast makes 0: before the first sample nothing is known, and 1 is taken.
    ((left.as_secs_f64() / seconds_each) as u32).max(1)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{LONGEST, Pace, SHORTEST, fitting};

    #[test]
    fn as_many_samples_fit_as_the_first_ones_tell() {
        let [second, minute] = [1, 60].map(Duration::from_secs);
        assert_eq!(fitting(10, second, minute), 600, "ten a second");
        assert_eq!(fitting(10, minute, second), 1, "one in six seconds");
        assert_eq!(fitting(0, Duration::ZERO, minute), 1, "before the first");
        assert_eq!(fitting(5, Duration::ZERO, minute), u32::MAX, "faster than the clock");
    }

    #[test]
    fn a_look_at_the_clock_is_never_far() {
        let longest = |time| Pace::new(time).longest;
        assert_eq!(longest(None), LONGEST, "without a deadline");
        assert_eq!(longest(Some(Duration::from_millis(100))), SHORTEST, "of a tenth of a second");
        assert_eq!(longest(Some(Duration::from_secs(10))), LONGEST / 5, "of ten seconds");
        assert!(Pace::new(Some(Duration::ZERO)).is_over(), "no time at all");
        let unhurried = Pace::new(None);
        assert!(!unhurried.is_over(), "time without end");
        assert_eq!(unhurried.total(1), None, "what there is time for");
        let slow = Pace { start: unhurried.start - 10 * LONGEST, ..unhurried };
        let next = slow.samples(50);
        assert!((1..=5).contains(&next), "{next} samples in a second at five a second");
    }
}
