//! What a ray is inside of.

/// The glasses that a ray has entered and not left, the last one at the end.
///
/// The medium around the ray is the last one entered; outside of all of them the index of
/// refraction is 1. So a bubble of air is a body of index 1 within another, and a core of heavier
/// glass is one of a higher index. Where two bodies overlap without one containing the other, the
/// one that was entered last rules until it is left; leaving the other one changes nothing then.
///
/// Bodies are told apart by their material. Two of the same material have the same index, so which
/// of the two is left does not matter, as long as as many are left as were entered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Media {
    entered: [Medium; Self::CAPACITY],
    len: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Medium {
    material: u32,
    ior: f32,
}

impl Media {
    /// Outside of all bodies.
    pub const OUTSIDE: Self =
        Self { entered: [Medium { material: u32::MAX, ior: 1.0 }; Self::CAPACITY], len: 0 };

    /// How many bodies within one another are told apart. Beyond them the outermost is forgotten,
    /// and leaving it is then like leaving a body that was never entered.
    const CAPACITY: usize = 8;

    // ANCHOR: media
    /// The index of refraction around the ray.
    #[inline]
    #[must_use]
    pub fn ior(&self) -> f32 {
        self.entered[..self.len].last().map_or(1.0, |medium| medium.ior)
    }

    /// Goes into a body of this material and index.
    pub fn enter(&mut self, material: u32, ior: f32) {
        if self.len == Self::CAPACITY {
            self.remove(0);
        }
        self.entered[self.len] = Medium { material, ior };
        self.len += 1;
    }

    /// Goes out of a body of this material, and returns whether it had been entered.
    pub fn leave(&mut self, material: u32) -> bool {
        let place = self.entered[..self.len].iter().rposition(|medium| medium.material == material);
        if let Some(place) = place {
            self.remove(place);
        }
        place.is_some()
    }
    // ANCHOR_END: media

    /// What no longer counts is overwritten, so that equal lists are equal values.
    fn remove(&mut self, place: usize) {
        self.entered.copy_within(place + 1..self.len, place);
        self.len -= 1;
        self.entered[self.len] = Self::OUTSIDE.entered[self.len];
    }
}

#[cfg(test)]
mod tests {
    use super::Media;

    #[test]
    fn the_medium_is_the_last_one_entered_that_has_not_been_left() {
        let mut media = Media::OUTSIDE;
        assert_eq!(media.ior(), 1.0, "outside");
        media.enter(0, 1.5);
        media.enter(1, 1.0);
        assert_eq!(media.ior(), 1.0, "in a bubble within glass");
        assert!(media.leave(1), "the bubble had been entered");
        assert_eq!(media.ior(), 1.5, "back in the glass");
        assert!(media.leave(0), "the glass had been entered");
        assert_eq!(media, Media::OUTSIDE, "outside again");
    }

    #[test]
    fn leaving_a_body_that_is_not_the_last_entered_changes_nothing_yet() {
        let mut media = Media::OUTSIDE;
        media.enter(0, 1.5);
        media.enter(1, 2.4);
        assert!(media.leave(0) && media.ior() == 2.4, "{media:?}");
        assert!(media.leave(1) && media == Media::OUTSIDE, "{media:?}");
    }

    #[test]
    fn leaving_what_was_never_entered_is_noticed() {
        let mut media = Media::OUTSIDE;
        media.enter(0, 1.5);
        assert!(!media.leave(7) && media.ior() == 1.5, "{media:?}");
    }

    /// One more than there is room for: the inner ones are still left in the right order.
    #[test]
    fn too_many_bodies_within_one_another_lose_the_outermost() {
        let ior = |material: u32| 1.0 + material as f32 / 8.0;
        let mut media = Media::OUTSIDE;
        for material in 0..=8 {
            media.enter(material, ior(material));
        }
        for material in (1..=8).rev() {
            assert_eq!(media.ior(), ior(material), "in body {material}");
            assert!(media.leave(material), "body {material} had been entered");
        }
        assert!(!media.leave(0) && media == Media::OUTSIDE, "{media:?}");
    }
}
