//! Tests of random quantities: one harness for the whole workspace.
//!
//! A renderer that draws random numbers cannot be held against a right answer with `==`. What can
//! be said is that a result would be *this* far off by chance once in a hundred thousand runs, and
//! that a fault of *that* size would not have escaped. Every test of this crate says both:
//!
//! | question | test |
//! |---|---|
//! | Is the mean of these numbers what a closed form says? | [`assert_mean`] |
//! | Do two estimators have the same mean? | [`assert_same_mean`] |
//! | Do these counts follow these expectations? | [`assert_chi_squared`] |
//! | Does a sampler of directions follow its density? | [`assert_directions`] |
//! | Does something happen as often as it should? | [`assert_proportion`] |
//! | Is the spread of a mean what its samples say? | [`assert_variance`] |
//! | Do two noisy pictures show the same? | [`compare_images`] |
//! | How fast does an error fall? | [`PowerLaw::fit`] |
//!
//! Each `assert_` has a twin `check_` that returns a `Result`, so that a test can plant a fault and
//! show that it is found. The rate of false alarms is decided once, in [`suite`], for all tests of
//! the workspace together; each has [`TEST_ALPHA`] of it, which is [`CRITICAL_Z`] standard errors.
//!
//! What is not finite always fails, and so does the absence of anything to test.
//!
//! This is a tool beside the chapters: it knows neither rays nor pictures, only numbers.

mod beta;
mod chi_squared;
mod directions;
mod gamma;
mod grouped;
mod images;
mod mean;
mod moments;
mod noisy;
mod normal;
mod power_law;
mod proportion;
mod quadrature;
mod relative_error;
pub mod suite;
#[cfg(test)]
mod uniform;

pub use beta::{
    beta_lower, binomial_at_least, binomial_at_most, student_critical_t, student_two_sided,
};
pub use chi_squared::{ChiSquared, assert_chi_squared, check_chi_squared};
pub use directions::{Grid, Rejected, assert_directions, check_directions};
pub use gamma::{chi_squared_critical, chi_squared_upper_tail, gamma_upper_tail};
pub use grouped::grouped;
pub use images::{Agreement, Block, Criterion, assert_images, compare_images};
pub use mean::{
    ROUNDING, assert_mean, assert_same_mean, assert_variance, check_mean, check_same_mean,
    check_variance,
};
pub use moments::Moments;
pub use noisy::Noisy;
pub use normal::{normal_cdf, normal_quantile, normal_upper_tail, two_sided_critical_z};
pub use power_law::PowerLaw;
pub use proportion::{assert_proportion, check_proportion};
pub use quadrature::integrate_rectangle;
pub use relative_error::relative_mean_squared_error;
pub use suite::{CRITICAL_Z, POWER_Z, SUITE_ALPHA, TEST_ALPHA, TESTS, per_test_alpha, seed};
