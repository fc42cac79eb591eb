//! Large counts, as they are to be read.

/// A count with its digits in groups of three: 1 234 567.
#[must_use]
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let groups = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy);
    // A narrow space at which no line breaks.
    groups.collect::<Vec<_>>().join("\u{202f}")
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn digits_are_grouped_by_thousands() {
        assert_eq!(grouped(0), "0", "zero");
        assert_eq!(grouped(999), "999", "three digits");
        assert_eq!(grouped(1_234_567), "1\u{202f}234\u{202f}567", "seven digits");
    }
}
