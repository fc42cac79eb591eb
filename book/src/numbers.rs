//! Numbers in running text: the page includes them by name instead of repeating them.

use std::fmt::{Display, Write};

/// Named values, each of which a page can include: `{{#include figures/….md:name}}`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Numbers(Vec<(&'static str, String)>);

impl Numbers {
    /// No values.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a value, as it is to be read.
    ///
    /// # Panics
    ///
    /// If the name is taken, or has other characters than letters, digits, `-` and `_`.
    pub fn add(&mut self, name: &'static str, value: impl Display) {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        assert!(!name.is_empty() && name.chars().all(plain), "`{name}` cannot name an anchor");
        assert!(self.0.iter().all(|(other, _)| *other != name), "`{name}` is there already");
        self.0.push((name, value.to_string()));
    }

    /// The file that pages include from: each value between the two marks of an anchor.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        for (name, value) in &self.0 {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "ANCHOR: {name}\n{value}\nANCHOR_END: {name}");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::Numbers;

    #[test]
    fn each_number_has_an_anchor() {
        let mut numbers = Numbers::new();
        numbers.add("primitive-tests", 1234);
        let expected = "ANCHOR: primitive-tests\n1234\nANCHOR_END: primitive-tests\n";
        assert_eq!(numbers.text(), expected, "the value between its marks");
    }

    #[test]
    #[should_panic(expected = "`n` is there already")]
    fn a_name_is_given_once() {
        let mut numbers = Numbers::new();
        numbers.add("n", 1);
        numbers.add("n", 2);
    }
}
