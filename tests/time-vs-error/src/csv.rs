//! Lines of comma-separated values, after RFC 4180, without line breaks inside a cell.

use std::borrow::Cow;

/// Cells as a line, without its end.
#[must_use]
pub fn line(cells: &[String]) -> String {
    cells.iter().map(|cell| quoted(cell)).collect::<Vec<_>>().join(",")
}

fn quoted(cell: &str) -> Cow<'_, str> {
    if cell.contains([',', '"']) {
        Cow::Owned(format!("\"{}\"", cell.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(cell)
    }
}

/// The cells of a line; `None` if a quotation is not closed.
#[must_use]
pub fn cells(line: &str) -> Option<Vec<String>> {
    let mut cells = vec![String::new()];
    let mut is_quoted = false;
    let mut characters = line.trim_end_matches(['\r', '\n']).chars().peekable();
    while let Some(character) = characters.next() {
        let cell = cells.last_mut()?;
        match character {
            '"' if is_quoted && characters.next_if_eq(&'"').is_some() => cell.push('"'),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => cells.push(String::new()),
            other => cell.push(other),
        }
    }
    (!is_quoted).then_some(cells)
}

#[cfg(test)]
mod tests {
    use super::{cells, line};

    #[test]
    fn cells_survive_a_line() {
        for row in [vec!["a", "", "b c"], vec!["1,5", "say \"x\"", "\""], vec![""]] {
            let row: Vec<String> = row.into_iter().map(str::to_owned).collect();
            assert_eq!(cells(&line(&row)).as_ref(), Some(&row), "{}", line(&row));
        }
        assert_eq!(cells("a,\"b\r\n"), None, "an open quotation");
        assert_eq!(cells("a,b\r\n"), Some(vec!["a".into(), "b".into()]), "the end of a line");
    }
}
