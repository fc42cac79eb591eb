//! Counts against expected counts.

use crate::gamma::{chi_squared_critical, chi_squared_upper_tail};
use crate::suite::{POWER_Z, TEST_ALPHA};

/// Cells of which fewer are expected are joined with their neighbours: below about 5, a count is
/// too far from normal for χ².
const SMALLEST: f64 = 5.0;

/// How far the expected counts may be from the number of samples, relative to it.
///
/// An error of this size adds at most n · 10⁻⁸ to χ². A density that is not normalised is found
/// here, not in the distribution.
const NORMALISED: f64 = 1e-4;

/// The outcome of a χ² test that passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChiSquared {
    /// Σ (observed − expected)² / expected.
    pub chi_squared: f64,
    /// Cells after joining, less one.
    pub degrees: u32,
    /// The probability of a larger χ² by chance.
    pub p: f64,
    /// The root mean square of the cells' relative errors, each cell weighed by its probability,
    /// that would have been noticed with a probability of about 99 %.
    pub visible_deviation: f64,
}

/// Asserts that counts follow their expectations.
///
/// ```
/// let counts = [170, 162, 163, 179, 155, 171];
/// let p = statistics::assert_chi_squared("die", &counts, &[1000.0 / 6.0; 6]).p;
/// assert!(p > 0.5, "the die is fair, p = {p}");
/// ```
///
/// # Panics
/// If [`check_chi_squared`] fails.
#[expect(clippy::must_use_candidate, reason = "that it passed may be all that matters")]
#[track_caller]
pub fn assert_chi_squared(name: &str, observed: &[u64], expected: &[f64]) -> ChiSquared {
    check_chi_squared(name, observed, expected).unwrap_or_else(|sentence| panic!("{sentence}"))
}

/// Whether `observed` follows `expected`: Pearson's χ² test with [`TEST_ALPHA`].
///
/// Neighbouring cells with an expectation below 5 are joined. A cell with expectation 0 takes part
/// in no sum: a single sample in it is a failure, whatever the others say.
///
/// # Errors
/// If the counts do not follow, if a sample lies where none can, if an expectation is negative or
/// not finite, if the sums differ by more than 10⁻⁴, or if fewer than two cells remain.
pub fn check_chi_squared(
    name: &str,
    observed: &[u64],
    expected: &[f64],
) -> Result<ChiSquared, String> {
    check_with_alpha(name, observed, expected, TEST_ALPHA)
}

/// [`check_chi_squared`] with a share of a test's α.
pub(crate) fn check_with_alpha(
    name: &str,
    observed: &[u64],
    expected: &[f64],
    alpha: f64,
) -> Result<ChiSquared, String> {
    if observed.len() != expected.len() {
        let [a, b] = [observed.len(), expected.len()];
        return Err(format!("{name}: {a} cells were observed, {b} expected"));
    }
    if let Some(i) = expected.iter().position(|e| !(e.is_finite() && *e >= 0.0)) {
        return Err(format!("{name}: cell {i} expects {}", expected[i]));
    }
    if let Some(i) = (0..observed.len()).find(|&i| expected[i] == 0.0 && observed[i] > 0) {
        return Err(format!("{name}: {} samples lie in cell {i}, where none can be", observed[i]));
    }
    let n = observed.iter().sum::<u64>() as f64;
    let sum: f64 = expected.iter().sum();
    if (sum - n).abs() > NORMALISED * n {
        return Err(format!("{name}: {n} samples, but {sum:.2} are expected (ratio {})", sum / n));
    }

    let cells = joined(observed, expected);
    if cells.len() < 2 {
        return Err(format!("{name}: {n} samples fill {} cells, too few to test", cells.len()));
    }
    let share = |&(observed, expected): &(f64, f64)| {
        (observed - expected) * (observed - expected) / expected
    };
    let chi_squared: f64 = cells.iter().map(share).sum();
    let degrees = (cells.len() - 1) as f64;
    let p = chi_squared_upper_tail(chi_squared, degrees);
    let visible_deviation = visible_deviation(alpha, degrees, n);
    if p >= alpha {
        let degrees = u32::try_from(cells.len() - 1).unwrap_or(u32::MAX);
        return Ok(ChiSquared { chi_squared, degrees, p, visible_deviation });
    }
    let worst = cells.iter().max_by(|a, b| share(a).total_cmp(&share(b))).copied();
    let (worst_observed, worst_expected) = worst.unwrap_or_default();
    Err(format!(
        "{name}: χ² = {chi_squared:.1} with {degrees} degrees of freedom, p = {p:.1e} is below \
         {alpha:.1e}; n = {n}; the worst cell holds {worst_observed} where {worst_expected:.1} are \
         expected; a deviation of {:.2} % would be seen",
        100.0 * visible_deviation
    ))
}

/// √(λ/n) for the smallest λ that exceeds the limit c with a probability of 99 %.
///
/// ```text
/// ν + λ − 2.33 √(2ν + 4λ) = c
/// ```
///
/// A relative error δᵢ in each cell adds λ = n Σ pᵢ δᵢ² to the mean ν of χ², and 4λ to its variance
/// 2ν (the non-central distribution, taken for normal). Iterated from below.
fn visible_deviation(alpha: f64, degrees: f64, n: f64) -> f64 {
    let excess = chi_squared_critical(alpha, degrees) - degrees;
    let mut lambda = excess;
    for _ in 0..50 {
        lambda = excess + POWER_Z * (2.0 * degrees + 4.0 * lambda).sqrt();
    }
    (lambda / n).sqrt()
}

/// Observed and expected counts after joining.
///
/// Neighbours in the given order are joined, not the smallest of all: what is wrong in one place
/// is then not averaged with what is right elsewhere. A remainder joins the last cell.
fn joined(observed: &[u64], expected: &[f64]) -> Vec<(f64, f64)> {
    let mut cells = Vec::with_capacity(observed.len());
    let mut open = (0.0, 0.0);
    for (&observed, &expected) in observed.iter().zip(expected) {
        if expected >= SMALLEST {
            cells.push((observed as f64, expected));
            continue;
        }
        open = (open.0 + observed as f64, open.1 + expected);
        if open.1 >= SMALLEST {
            cells.push(open);
            open = (0.0, 0.0);
        }
    }
    match cells.last_mut() {
        Some(last) => *last = (last.0 + open.0, last.1 + open.1),
        None if open.1 > 0.0 => cells.push(open),
        None => {}
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::seed;
    use crate::uniform::Uniform;

    /// Mendel's peas of 1866: 315 : 108 : 101 : 32 against 9 : 3 : 3 : 1 give χ² = 0.47, p = 0.925.
    #[test]
    fn mendels_peas_are_as_published() {
        let expected = [9.0, 3.0, 3.0, 1.0].map(|share| 556.0 * share / 16.0);
        let test = assert_chi_squared("peas", &[315, 108, 101, 32], &expected);
        assert!((test.chi_squared - 0.470).abs() < 1e-3, "χ² = {}", test.chi_squared);
        assert!((test.p - 0.925).abs() < 1e-3, "p = {}", test.p);
        assert_eq!(test.degrees, 3, "degrees of freedom");
    }

    /// Weldon's 26306 throws of 12 dice (Pearson 1900): 5 and 6 came 106602 times in 315672, which
    /// is 5.2 standard errors more than a third.
    #[test]
    fn weldons_dice_are_not_fair() {
        let expected = [315_672.0 * 2.0 / 3.0, 315_672.0 / 3.0];
        let found = check_chi_squared("dice", &[209_070, 106_602], &expected);
        let sentence = found.expect_err("the dice were hollowed");
        assert!(sentence.contains("χ² = 27.1"), "{sentence}");
    }

    #[test]
    fn a_sample_where_none_can_be_is_a_failure_by_itself() {
        let found = check_chi_squared("gap", &[5000, 1, 4999], &[5000.0, 0.0, 5000.0]);
        assert!(found.is_err_and(|sentence| sentence.contains("cell 1")), "one in a gap");
        assert_chi_squared("gap", &[5000, 0, 5000], &[5000.0, 0.0, 5000.0]);
    }

    #[test]
    fn small_cells_are_joined_with_their_neighbours() {
        let cells = joined(&[9, 1, 2, 3, 8, 1], &[10.0, 2.0, 2.0, 2.0, 7.0, 1.0]);
        assert_eq!(cells, [(9.0, 10.0), (6.0, 6.0), (9.0, 8.0)], "joined cells");
        assert_eq!(joined(&[1, 1], &[1.0, 1.0]), [(2.0, 2.0)], "all are small");
    }

    #[test]
    fn what_cannot_be_tested_fails() {
        assert!(check_chi_squared("empty", &[], &[]).is_err(), "no cells");
        assert!(check_chi_squared("no samples", &[0, 0], &[0.0, 0.0]).is_err(), "no samples");
        assert!(check_chi_squared("few", &[2, 2], &[2.0, 2.0]).is_err(), "4 samples");
        assert!(check_chi_squared("one", &[1000], &[1000.0]).is_err(), "one cell");
        assert!(check_chi_squared("lengths", &[50, 50], &[100.0]).is_err(), "two and one cells");
        for broken in [f64::NAN, f64::INFINITY, -1.0] {
            let found = check_chi_squared("broken", &[50, 50], &[broken, 50.0]);
            assert!(found.is_err(), "an expectation of {broken} passes");
        }
    }

    #[test]
    fn expectations_that_do_not_add_up_fail() {
        let found = check_chi_squared("sum", &[500, 500], &[500.0, 501.0]);
        assert!(found.is_err_and(|sentence| sentence.contains("ratio 1.001")), "one in a thousand");
    }

    /// The rate of alarms, and the power at the stated deviation, in one experiment.
    #[test]
    fn rate_and_power_are_as_stated() {
        let mut random = Uniform(seed(6));
        let (n, cells) = (20_000, 32);
        let expected = vec![f64::from(n) / f64::from(cells); 32];
        let mut run = |deviation: f64| {
            let mut observed = vec![0; 32];
            for _ in 0..n {
                // Even cells are more likely by the deviation, odd ones less.
                let (cell, even) = (2.0 * (16.0 * random.next()).floor(), random.next());
                let odd = if even < 0.5 * (1.0 + deviation) { 0.0 } else { 1.0 };
                observed[(cell + odd) as usize] += 1;
            }
            check_chi_squared("cells", &observed, &expected)
        };
        let visible = run(0.0).expect("a fair run").visible_deviation;
        let alarms = (0..100).filter(|_| run(0.0).is_err()).count();
        let found = (0..100).filter(|_| run(visible).is_err()).count();
        assert_eq!(alarms, 0, "alarms in 100 fair runs");
        assert!(found >= 95, "{found} of 100 runs with a deviation of {visible} are found");
    }
}
