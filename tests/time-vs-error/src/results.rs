//! The file of all renders: appended to line by line, and read again by the next run.

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};
use crate::row::{Key, Row, header};

/// The rows of a CSV file, and the file, open for more.
#[derive(Debug)]
pub struct Results {
    path: PathBuf,
    file: File,
    rows: HashMap<Key, Row>,
}

impl Results {
    /// The results in the file at `path`, which is begun if it is not there.
    ///
    /// A last line without its end is what an interrupted run leaves behind: it is cut off.
    ///
    /// # Errors
    /// If the file cannot be read or written, or has other columns or a line that is no row.
    pub fn open(path: &Path) -> Result<Self> {
        let failed = |error| Error::file(path, error);
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(|error| Error::file(folder, error))?;
        }
        let text =
            if path.exists() { fs::read_to_string(path).map_err(failed)? } else { String::new() };
        let whole = text.rfind('\n').map_or(0, |end| end + 1);
        let rows = parse(path, &text[..whole])?;
        let mut options = OpenOptions::new();
        let mut file = options.create(true).append(true).open(path).map_err(failed)?;
        file.set_len(whole as u64).map_err(failed)?;
        if whole == 0 {
            write_line(&mut file, &header()).map_err(failed)?;
        }
        Ok(Self { path: path.to_owned(), file, rows })
    }

    /// The row of a render that was made already.
    #[must_use]
    pub fn get(&self, key: &Key) -> Option<&Row> {
        self.rows.get(key)
    }

    /// Adds a row, and hands it to the system before it returns.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn add(&mut self, row: Row) -> Result<()> {
        write_line(&mut self.file, &row.line()).map_err(|error| Error::file(&self.path, error))?;
        self.rows.insert(row.key.clone(), row);
        Ok(())
    }
}

/// The line and its end in one piece, so that an interruption falls between lines as a rule.
fn write_line(file: &mut File, line: &str) -> std::io::Result<()> {
    file.write_all(format!("{line}\n").as_bytes())?;
    file.flush()
}

fn parse(path: &Path, text: &str) -> Result<HashMap<Key, Row>> {
    let mut lines = text.lines();
    if lines.next().is_some_and(|first| first != header()) {
        return Err(Error::file(path, "it has other columns; move it away to measure anew"));
    }
    let row = |(i, line)| {
        let row = Row::parse(line);
        row.ok_or_else(|| Error::file(path, format!("line {} is no row", i + 2)))
    };
    lines.enumerate().map(|line| row(line).map(|row| (row.key.clone(), row))).collect()
}

#[cfg(test)]
mod tests {
    use super::Results;
    use crate::row::header;
    use crate::row::tests::example;
    use std::fs;

    #[test]
    fn an_interrupted_run_goes_on_where_it_was() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("new/results.csv");
        let rows = [example("cosine", 1, 0), example("uniform", 1, 0), example("cosine", 4, 0)];
        let mut results = Results::open(&path).expect("a new file");
        for row in &rows[..2] {
            results.add(row.clone()).expect("the row is written");
        }
        drop(results);

        // The process dies in the middle of the third line.
        let whole = fs::read_to_string(&path).expect("the file is read");
        let line = rows[2].line();
        fs::write(&path, format!("{whole}{}", &line[..line.len() / 2])).expect("half a line");

        let mut results = Results::open(&path).expect("a half-written line is no fault");
        let found = rows.each_ref().map(|row| results.get(&row.key));
        assert_eq!(found, [Some(&rows[0]), Some(&rows[1]), None], "what needs no second render");
        results.add(rows[2].clone()).expect("the row is written");
        let text = fs::read_to_string(&path).expect("the file is read");
        let expected: String = [header()]
            .into_iter()
            .chain(rows.iter().map(|row| row.line()))
            .map(|l| l + "\n")
            .collect();
        assert_eq!(text, expected, "as if nothing had happened");
    }

    #[test]
    fn a_file_that_is_not_ours_is_left_alone() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("other.csv");
        for text in ["a,b\n1,2\n".to_owned(), format!("{}\nnonsense\n", header())] {
            fs::write(&path, &text).expect("a file");
            let message = Results::open(&path).expect_err("it is not ours").to_string();
            assert!(message.contains("other columns") || message.contains("line 2"), "{message}");
            assert_eq!(fs::read_to_string(&path).expect("it is read"), text, "the file");
        }
    }
}
