//! Coordinates with seven decimals, the precision of the OBJ files.

/// A coordinate as the OBJ file states it: a whole number of 10⁻⁷ scene units.
///
/// Text and [`crate::Mesh`] are both made from this number, so a mesh in memory and the same mesh
/// read back from its file agree in every bit.
#[derive(Clone, Copy)]
pub(crate) struct Decimal {
    /// The magnitude, in 10⁻⁷ scene units.
    units: u64,
    /// Kept apart from the magnitude: a tiny negative number is written as −0, as C's `printf`
    /// does.
    negative: bool,
}

/// 10⁷: exact in f64, as is every whole number below 2⁵³.
const UNITS: f64 = 1e7;

impl From<f64> for Decimal {
    /// Rounds to the nearest; `x` is finite and smaller than 10⁸ scene units.
    fn from(x: f64) -> Self {
        debug_assert!(x.abs() < 1e8, "coordinate {x} does not fit seven decimals");
        Self { units: (x.abs() * UNITS).round() as u64, negative: x.is_sign_negative() }
    }
}

impl Decimal {
    /// The f32 next to this number.
    ///
    /// The division is correctly rounded, so it yields what parsing the text yields.
    pub(crate) fn to_f32(self) -> f32 {
        let magnitude = (self.units as f64 / UNITS) as f32;
        if self.negative { -magnitude } else { magnitude }
    }

    /// Appends the number with all its seven decimals.
    pub(crate) fn push(self, line: &mut Vec<u8>) {
        self.push_whole(line);
        line.push(b'.');
        let mut decimals = *b"0000000";
        write_digits(&mut decimals, self.units % UNITS as u64);
        line.extend(decimals);
    }

    /// Appends the number without decimals.
    pub(crate) fn push_whole(self, line: &mut Vec<u8>) {
        if self.negative {
            line.push(b'-');
        }
        push_integer(line, self.units / UNITS as u64);
    }
}

/// Appends a whole number. Formatting is most of the work of writing 10⁷ triangles; this is about
/// three times as fast as `write!`.
pub(crate) fn push_integer(line: &mut Vec<u8>, number: u64) {
    let mut digits = *b"00000000000000000000"; // u64::MAX has 20 digits
    let used = write_digits(&mut digits, number).max(1);
    line.extend(&digits[digits.len() - used..]);
}

/// Writes `number` at the right end of `digits`, and returns how many digits it has (0 has none).
fn write_digits(digits: &mut [u8], mut number: u64) -> usize {
    let mut used = 0;
    for digit in digits.iter_mut().rev() {
        if number == 0 {
            break;
        }
        *digit = b'0' + (number % 10) as u8;
        number /= 10;
        used += 1;
    }
    used
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(x: f64) -> String {
        let mut line = Vec::new();
        Decimal::from(x).push(&mut line);
        String::from_utf8(line).expect("digits are ASCII")
    }

    #[test]
    fn the_text_is_what_the_standard_library_writes() {
        let numbers = [0.0, 1.0, 0.1, -1.0 / 3.0, 12.5, 0.000_000_06, -50.0, 99_999.123_456_78];
        for x in numbers {
            assert_eq!(text(x), format!("{x:.7}"), "for {x}");
        }
    }

    #[test]
    fn a_tiny_negative_number_keeps_its_sign() {
        assert_eq!(text(-1e-16), "-0.0000000", "−1e−16");
    }

    #[test]
    fn the_number_in_memory_is_the_number_that_the_text_parses_to() {
        for i in -20_000..20_000_i32 {
            let x = f64::from(i) * 0.000_123_456_789;
            let read: f32 = text(x).parse().expect("the text is a number");
            let kept = Decimal::from(x).to_f32();
            assert_eq!(read.to_bits(), kept.to_bits(), "{x} reads as {read}, is kept as {kept}");
        }
    }
}
