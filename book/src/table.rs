//! Tables, as Markdown to be included into a page.

/// A table: the first column names things, the others hold numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new(header: &[&str]) -> Self {
        Self { header: header.iter().map(|&cell| cell.to_owned()).collect(), rows: Vec::new() }
    }

    /// Adds a row.
    ///
    /// # Panics
    ///
    /// If it has more or fewer cells than the header.
    pub fn row<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) {
        let cells: Vec<String> = cells.into_iter().map(Into::into).collect();
        let (n, columns) = (cells.len(), self.header.len());
        assert_eq!(n, columns, "a row of {n} cells in a table of {columns} columns: {cells:?}");
        self.rows.push(cells);
    }

    /// The table as Markdown, the first column to the left, the others to the right.
    #[must_use]
    pub fn markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells = cells.iter().map(|cell| format!(" {} |", cell.replace('|', "\\|")));
            format!("|{}\n", cells.collect::<String>())
        };
        let border = format!("|---|{}\n", "---:|".repeat(self.header.len().saturating_sub(1)));
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        format!("{}{border}{rows}", line(&self.header))
    }
}

/// A count with its digits in groups of three: 1 234 567.
#[must_use]
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let mut grouped = String::with_capacity(2 * digits.len());
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            // A narrow space at which no line breaks.
            grouped.push('\u{202f}');
        }
        grouped.push(digit);
    }
    grouped
}

#[cfg(test)]
mod tests {
    use super::{Table, count};

    #[test]
    fn a_table_is_markdown() {
        let mut table = Table::new(&["volume", "tests"]);
        table.row(["a|b", "12"]);
        let expected = "| volume | tests |\n|---|---:|\n| a\\|b | 12 |\n";
        assert_eq!(table.markdown(), expected, "rows and alignment");
    }

    #[test]
    fn digits_are_grouped_by_thousands() {
        assert_eq!(count(0), "0", "zero");
        assert_eq!(count(999), "999", "three digits");
        assert_eq!(count(1_234_567), "1\u{202f}234\u{202f}567", "seven digits");
    }
}
