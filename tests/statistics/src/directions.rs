//! Samplers of directions against their densities.

use crate::chi_squared::{ChiSquared, check_with_alpha};
use crate::quadrature::integrate_rectangle;
use crate::suite::{TEST_ALPHA, per_test_alpha};
use std::f64::consts::{PI, TAU};

/// How far from 1 the square of a direction's length may be.
const UNIT_LENGTH: f64 = 1e-5;

/// The error that an expected count may have, in samples. It adds 10⁻⁵ to χ² where 100 are
/// expected.
const COUNT_ERROR: f64 = 0.03;

/// Rows and columns of the coarse grid that is tested beside the fine one.
const COARSE: [usize; 2] = [8, 16];

/// Cells on the sphere: rows of equal polar angle around an axis, columns of equal azimuth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Rows between the axis and `max_angle`.
    pub rows: usize,
    /// Columns around the axis.
    pub columns: usize,
    /// The axis, unit length. A narrow lobe deserves a grid around itself.
    pub axis: [f64; 3],
    /// Where the last row ends, in radians, at most π. All that lies beyond is one more cell.
    pub max_angle: f64,
}

impl Grid {
    /// 80 × 160 cells of 2.25° around z, over the whole sphere.
    pub const SPHERE: Self = Self { rows: 80, columns: 160, axis: [0.0, 0.0, 1.0], max_angle: PI };

    /// 101 × 101 cells: no cell ends at the equator or at a multiple of 90°, so errors on both
    /// sides of these do not cancel as in [`Grid::SPHERE`].
    pub const ODD: Self = Self { rows: 101, columns: 101, axis: [0.0, 0.0, 1.0], max_angle: PI };

    /// The same cells around another axis, which is made a unit vector.
    ///
    /// # Panics
    /// If the axis has no direction.
    #[must_use]
    pub fn around(self, axis: [f32; 3]) -> Self {
        let axis = axis.map(f64::from);
        let length = dot(axis, axis).sqrt();
        assert!(length > 0.0 && length.is_finite(), "{axis:?} is no axis");
        Self { axis: axis.map(|component| component / length), ..self }
    }

    /// The same number of cells within `max_angle` of the axis, in radians: for narrow lobes and
    /// cones.
    ///
    /// # Panics
    /// If the angle is not above 0 and at most π.
    #[must_use]
    pub fn within(self, max_angle: f64) -> Self {
        assert!(max_angle > 0.0 && max_angle <= PI, "no grid ends at {max_angle}");
        Self { max_angle, ..self }
    }

    /// Two unit vectors that make a right-handed basis with the axis as the third.
    fn basis(&self) -> [[f64; 3]; 3] {
        let [x, y, z] = self.axis;
        // The coordinate axis that is farthest from the grid's.
        let far = if x.abs() <= y.abs().min(z.abs()) {
            [1.0, 0.0, 0.0]
        } else if y.abs() <= z.abs() {
            [0.0, 1.0, 0.0]
        } else {
            [0.0, 0.0, 1.0]
        };
        let across = cross(far, self.axis);
        let length = dot(across, across).sqrt();
        let tangent = across.map(|component| component / length);
        [tangent, cross(self.axis, tangent), self.axis]
    }

    /// Row and column of a direction; `None` beyond `max_angle`.
    fn cell(&self, basis: &[[f64; 3]; 3], direction: [f64; 3]) -> Option<[usize; 2]> {
        let [x, y, z] = basis.map(|axis| dot(axis, direction));
        let theta = libm::atan2((x * x + y * y).sqrt(), z);
        let azimuth = libm::atan2(y, x);
        let phi = if azimuth < 0.0 { azimuth + TAU } else { azimuth };
        let row = theta / self.max_angle * self.rows as f64;
        let column = (phi / TAU * self.columns as f64) as usize;
        let beyond = theta > self.max_angle;
        (!beyond).then_some([(row as usize).min(self.rows - 1), column.min(self.columns - 1)])
    }

    /// ∫ pdf dω over each cell, row by row, and over the rest of the sphere as the last.
    fn integrals(
        &self,
        basis: &[[f64; 3]; 3],
        tolerance: f64,
        pdf: &impl Fn([f32; 3]) -> f64,
    ) -> Vec<f64> {
        let strip = |angles: [f64; 2], rows: usize, columns: usize| {
            integrals(basis, angles, [rows, columns], tolerance, pdf)
        };
        let mut integrals = strip([0.0, self.max_angle], self.rows, self.columns);
        let beyond = if self.max_angle < PI { strip([self.max_angle, PI], 64, 64) } else { vec![] };
        integrals.push(beyond.iter().sum());
        integrals
    }
}

/// ∫ pdf dω over cells between two polar angles, row by row.
fn integrals(
    basis: &[[f64; 3]; 3],
    [start, end]: [f64; 2],
    [rows, columns]: [usize; 2],
    tolerance: f64,
    pdf: &impl Fn([f32; 3]) -> f64,
) -> Vec<f64> {
    // dω = ds dφ for s = 1 − cos θ, which unlike cos θ is exact for small angles.
    let mut density = |s: f64, phi: f64| {
        let sin_theta = (s * (2.0 - s)).max(0.0).sqrt();
        let (sin_phi, cos_phi) = libm::sincos(phi);
        let local = [sin_theta * cos_phi, sin_theta * sin_phi, 1.0 - s];
        pdf([0, 1, 2].map(|i| (0..3).map(|k| local[k] * basis[k][i]).sum::<f64>() as f32))
    };
    let angle = |row: usize| start + (end - start) * row as f64 / rows as f64;
    let azimuth = |column: usize| TAU * column as f64 / columns as f64;
    let mut integrals = Vec::with_capacity(rows * columns + 1);
    for row in 0..rows {
        let s = [versine(angle(row)), versine(angle(row + 1))];
        for column in 0..columns {
            let phi = [azimuth(column), azimuth(column + 1)];
            integrals.push(integrate_rectangle(&mut density, s, phi, tolerance));
        }
    }
    integrals
}

/// What a sample that is `None` means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rejected {
    /// The sampler always gives a direction: a `None` is a failure, and ∫ pdf dω must be 1.
    Never,
    /// The sampler may give none, with the probability 1 − ∫ pdf dω that the density leaves (such
    /// as directions below the surface): it is tested as one more cell.
    Remainder,
}

/// Asserts that a sampler of directions follows its density.
///
/// ```
/// # use statistics::{Grid, Rejected, assert_directions, seed};
/// # let mut state = seed(11);
/// # let mut uniform = move || {
/// #     state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
/// #     (state >> 40) as f32 / 16777216.0
/// # };
/// let sample = || {
///     let (z, phi) = (2.0 * uniform() - 1.0, std::f32::consts::TAU * uniform());
///     let r = (1.0 - z * z).max(0.0).sqrt();
///     Some([r * libm::cosf(phi), r * libm::sinf(phi), z])
/// };
/// let pdf = |_| 0.25 / std::f64::consts::PI;
/// assert_directions("sphere", &Grid::ODD, 100_000, Rejected::Never, sample, pdf);
/// ```
///
/// `pdf` is a density with respect to solid angle, in 1/sr.
///
/// # Panics
/// If [`check_directions`] fails.
#[track_caller]
pub fn assert_directions(
    name: &str,
    grid: &Grid,
    samples: u32,
    rejected: Rejected,
    sample: impl FnMut() -> Option<[f32; 3]>,
    pdf: impl Fn([f32; 3]) -> f64,
) -> [ChiSquared; 2] {
    check_directions(name, grid, samples, rejected, sample, pdf)
        .unwrap_or_else(|sentence| panic!("{sentence}"))
}

/// Whether a sampler of directions follows its density: χ² tests on two grids.
///
/// The samples are counted in the cells of `grid`, and the density is integrated over each cell to
/// about 0.03 samples (Gauss, adaptive; where a step of the density cuts through a cell, to a few
/// thousandths of it). The counts are tested twice, and α is shared: in the
/// cells of `grid`, which show narrow faults, and joined to 8 × 16 cells, which show smooth ones: a
/// million samples see a deviation of about 3 % in the first and of 1 % in the second. The outcomes
/// come back in this order.
///
/// # Errors
/// If a test fails; if a direction is not finite or not of unit length, or lies where the density
/// is not a positive number; if `None` comes where it must not; if ∫ pdf dω is not 1, or above 1
/// where `None` may come, to 10⁻⁴; if a cell's integral is negative or NaN.
pub fn check_directions(
    name: &str,
    grid: &Grid,
    samples: u32,
    rejected: Rejected,
    mut sample: impl FnMut() -> Option<[f32; 3]>,
    pdf: impl Fn([f32; 3]) -> f64,
) -> Result<[ChiSquared; 2], String> {
    let basis = grid.basis();
    let n = f64::from(samples);
    let integrals = grid.integrals(&basis, COUNT_ERROR / n, &pdf);
    let mass: f64 = integrals.iter().sum();
    let normalised = match rejected {
        Rejected::Never => (mass - 1.0).abs() <= 1e-4,
        Rejected::Remainder => mass <= 1.0 + 1e-4,
    };
    if !normalised {
        return Err(format!("{name}: ∫ pdf dω = {mass:.6}"));
    }

    // One cell for what lies beyond the grid, and one for what was rejected.
    let cells = grid.rows * grid.columns;
    let mut observed = vec![0_u64; cells + 2];
    for _ in 0..samples {
        let Some(direction) = sample() else {
            if rejected == Rejected::Never {
                return Err(format!("{name}: a sample has no direction"));
            }
            observed[cells + 1] += 1;
            continue;
        };
        let density = pdf(direction);
        if !(density > 0.0 && density.is_finite()) {
            return Err(format!("{name}: {direction:?} was sampled, with density {density}"));
        }
        let exact = direction.map(f64::from);
        let length = dot(exact, exact).sqrt();
        if (length - 1.0).abs() > UNIT_LENGTH || length.is_nan() {
            return Err(format!("{name}: {direction:?} was sampled, of length {length}"));
        }
        let cell =
            grid.cell(&basis, exact).map_or(cells, |[row, column]| row * grid.columns + column);
        observed[cell] += 1;
    }
    let mut expected: Vec<f64> = integrals.iter().map(|integral| n * integral).collect();
    expected.push(if rejected == Rejected::Never { 0.0 } else { n * (1.0 - mass).max(0.0) });

    // Each sample had a positive density: its cell is not empty, whatever the quadrature
    // overlooked. The smallest of numbers lets it be joined with its neighbours.
    for (expected, _) in expected[..=cells].iter_mut().zip(&observed).filter(|(_, n)| **n > 0) {
        *expected = expected.max(f64::MIN_POSITIVE);
    }

    let alpha = per_test_alpha(TEST_ALPHA, 2);
    let fine = check_with_alpha(&format!("{name}, fine grid"), &observed, &expected, alpha)?;
    let (observed, expected) = (grid.coarse(&observed), grid.coarse(&expected));
    let coarse = check_with_alpha(&format!("{name}, coarse grid"), &observed, &expected, alpha)?;
    Ok([fine, coarse])
}

impl Grid {
    /// The cells joined to 8 × 16, and what follows them as it is.
    fn coarse<T: Copy + Default + std::ops::AddAssign>(&self, cells: &[T]) -> Vec<T> {
        let [rows, columns] = [COARSE[0].min(self.rows), COARSE[1].min(self.columns)];
        let mut coarse = vec![T::default(); rows * columns];
        let (grid, rest) = cells.split_at(self.rows * self.columns);
        for (i, &value) in grid.iter().enumerate() {
            let [row, column] = [i / self.columns, i % self.columns];
            coarse[row * rows / self.rows * columns + column * columns / self.columns] += value;
        }
        coarse.extend_from_slice(rest);
        coarse
    }
}

/// 1 − cos θ.
fn versine(theta: f64) -> f64 {
    let sine = libm::sin(0.5 * theta);
    2.0 * sine * sine
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
