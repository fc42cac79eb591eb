//! Arithmetic on four numbers at a time.
//!
//! Written out component by component: the compiler makes one instruction of each function, on every
//! processor that has instructions on four numbers, and the results are those of four single ones.

use crate::slab::{larger, smaller};

/// One number of each of four things.
pub(crate) type Four = [f32; 4];

/// a − b
#[inline(always)]
pub(crate) fn sub(a: Four, b: Four) -> Four {
    zip(a, b, |a, b| a - b)
}

/// a · b
#[inline(always)]
pub(crate) fn mul(a: Four, b: Four) -> Four {
    zip(a, b, |a, b| a * b)
}

/// The larger of each two, `b` where `a` is NaN.
#[inline(always)]
pub(crate) fn larger_of(a: Four, b: Four) -> Four {
    zip(a, b, larger)
}

/// The smaller of each two, `b` where `a` is NaN.
#[inline(always)]
pub(crate) fn smaller_of(a: Four, b: Four) -> Four {
    zip(a, b, smaller)
}

#[inline(always)]
fn zip(a: Four, b: Four, f: impl Fn(f32, f32) -> f32) -> Four {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])]
}

/// Bit i is set where answer i is yes.
#[inline(always)]
pub(crate) fn mask(answers: [bool; 4]) -> u32 {
    let bits = answers.map(|yes| if yes { u32::MAX } else { 0 } >> 31);
    bits[0] | (bits[1] << 1) | (bits[2] << 2) | (bits[3] << 3)
}

/// Takes the lowest bit out of a mask of four.
#[inline(always)]
pub(crate) const fn pop_bit(mask: &mut u32) -> Option<usize> {
    if *mask == 0 {
        return None;
    }
    let bit = mask.trailing_zeros() as usize;
    *mask &= *mask - 1;
    Some(bit % 4)
}
