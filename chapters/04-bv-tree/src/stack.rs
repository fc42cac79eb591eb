//! What a search has put off.

use crate::builder::MAX_DEPTH;
use crate::node::Link;

/// A node that waits.
#[derive(Clone, Copy)]
pub(crate) struct Waiting {
    /// Where to go on.
    pub(crate) link: Link,
    /// The t at which the ray enters it.
    pub(crate) entry: f32,
}

/// The nodes that wait; those that wait longest lie at the bottom.
pub(crate) struct Stack {
    /// The first ones. Hardly ever do more wait in a small scene.
    some: [Waiting; Self::SOME],
    /// The others. Clearing the memory for all that could ever wait would cost a ray in a small scene
    /// more than its search, so it is left to those rays that need it.
    more: Option<[Waiting; Self::MOST - Self::SOME]>,
    len: usize,
}

impl Stack {
    const SOME: usize = 6;
    /// Three on each level.
    const MOST: usize = 3 * MAX_DEPTH;
    const NOTHING: Waiting = Waiting { link: Link::NOTHING, entry: 0.0 };

    /// Nothing waits.
    #[inline(always)]
    pub(crate) const fn new() -> Self {
        Self { some: [Self::NOTHING; Self::SOME], more: None, len: 0 }
    }

    /// Whether no node waits.
    #[inline(always)]
    pub(crate) const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Puts a node on top.
    #[inline(always)]
    pub(crate) fn push(&mut self, waiting: Waiting) {
        match self.len.checked_sub(Self::SOME) {
            None => self.some[self.len] = waiting,
            Some(i) => {
                self.more.get_or_insert([Self::NOTHING; Self::MOST - Self::SOME])[i] = waiting;
            }
        }
        self.len += 1;
    }

    /// What waits on top, leaving out what the ray enters only behind `max`.
    #[inline(always)]
    pub(crate) fn pop(&mut self, max: f32) -> Option<Link> {
        while self.len > 0 {
            self.len -= 1;
            let waiting = match (self.len.checked_sub(Self::SOME), &self.more) {
                (Some(i), Some(more)) => more[i],
                _ => self.some[self.len],
            };
            if waiting.entry <= max {
                return Some(waiting.link);
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Stack, Waiting};
    use crate::node::Link;

    fn waiting(place: u32, entry: f32) -> Waiting {
        Waiting { link: Link::node(place), entry }
    }

    #[test]
    fn nodes_come_back_in_reverse_order_however_many_wait() {
        let mut stack = Stack::new();
        for place in 0..Stack::MOST as u32 {
            stack.push(waiting(place, 1.0));
        }
        for place in (0..Stack::MOST as u32).rev() {
            let popped = stack.pop(1.0).map(|link| link.first);
            assert_eq!(popped, Some(place), "place {place}");
        }
        assert!(stack.pop(1.0).is_none(), "nothing waits any more");
    }

    #[test]
    fn what_the_ray_no_longer_reaches_is_left_out() {
        let mut stack = Stack::new();
        for (place, entry) in [(0, 1.0), (1, 3.0), (2, 2.0), (3, 4.0)] {
            stack.push(waiting(place, entry));
        }
        assert_eq!(stack.pop(2.5).map(|link| link.first), Some(2), "the nearest within 2.5");
        assert_eq!(stack.pop(2.5).map(|link| link.first), Some(0), "the next one");
        assert!(stack.pop(2.5).is_none(), "nothing else is within 2.5");
    }
}
