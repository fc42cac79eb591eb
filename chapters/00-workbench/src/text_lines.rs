//! The lines of OBJ and MTL files, whatever program wrote them.

use std::io::{self, BufRead};
use std::path::Path;

use crate::SceneError;
use crate::toml_table::shortened;

/// The longest line in bytes; longer ones are no scene but an accident, or an attack.
pub(crate) const LONGEST_LINE: usize = 1 << 20;

/// Reads lines that end with LF, CRLF or CR, joins those that end with a backslash, and skips a
/// byte order mark. What is not UTF-8 becomes U+FFFD.
pub(crate) struct TextLines<'a, R> {
    path: &'a Path,
    source: R,
    /// How many lines have been read.
    number: usize,
    /// Whether the last line ended with CR: an LF that follows belongs to it.
    after_cr: bool,
    buffer: Vec<u8>,
}

impl<'a, R: BufRead> TextLines<'a, R> {
    pub(crate) fn new(path: &'a Path, source: R) -> Self {
        Self { path, source, number: 0, after_cr: false, buffer: Vec::new() }
    }

    /// The error that the line read last deserves.
    pub(crate) fn error(&self, reason: impl Into<String>) -> SceneError {
        SceneError::line(self.path, self.number, reason)
    }

    /// Puts the next line into `line`; false at the end of the file.
    pub(crate) fn read(&mut self, line: &mut String) -> Result<bool, SceneError> {
        self.buffer.clear();
        line.clear();
        let mut found = false;
        while self.read_physical().map_err(|error| SceneError::read(self.path, error))? {
            found = true;
            self.number += 1;
            if self.buffer.len() > LONGEST_LINE {
                return Err(self.error(format!("is longer than {LONGEST_LINE} bytes")));
            }
            if self.buffer.pop_if(|last| *last == b'\\').is_none() {
                break;
            }
            self.buffer.push(b' ');
        }
        let text = self.buffer.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&self.buffer);
        match std::str::from_utf8(text) {
            Ok(text) => line.push_str(text),
            Err(_) => line.push_str(&String::from_utf8_lossy(text)),
        }
        Ok(found)
    }

    /// Appends the bytes up to the next end of line to the buffer; false at the end of the file.
    fn read_physical(&mut self) -> io::Result<bool> {
        let mut found = false;
        loop {
            let mut bytes = match self.source.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                other => other?,
            };
            if bytes.is_empty() {
                return Ok(found);
            }
            if std::mem::take(&mut self.after_cr) && bytes[0] == b'\n' {
                self.source.consume(1);
                continue;
            }
            found = true;
            let end = bytes.iter().position(|&byte| byte == b'\n' || byte == b'\r');
            self.after_cr = end.is_some_and(|end| bytes[end] == b'\r');
            let used = end.map_or(bytes.len(), |end| end + 1);
            bytes = &bytes[..end.unwrap_or(bytes.len())];
            self.buffer.extend_from_slice(bytes);
            self.source.consume(used);
            // A line without end must not fill the memory; the caller finds it too long.
            if end.is_some() || self.buffer.len() > LONGEST_LINE {
                return Ok(true);
            }
        }
    }
}

/// The first word of a line and the rest of it, both without the space around them.
pub(crate) fn keyword(line: &str) -> (&str, &str) {
    let line = line.trim();
    let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    (keyword, rest.trim_start())
}

/// A finite number, or why the word is none.
pub(crate) fn finite(word: &str) -> Result<f32, String> {
    match word.parse::<f32>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => {
            Err(format!("has the value {}, which is not a finite 32-bit number", shortened(word)))
        }
        Err(_) => Err(format!("has `{}` where a number should be", shortened(word))),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{LONGEST_LINE, TextLines};

    fn lines(text: &[u8]) -> Vec<(usize, String)> {
        let mut reader = TextLines::new(Path::new("a.obj"), text);
        let (mut lines, mut line) = (Vec::new(), String::new());
        while reader.read(&mut line).expect("the lines are short") {
            lines.push((reader.number, line.clone()));
        }
        lines
    }

    #[test]
    fn every_line_ending_counts_as_one() {
        let expected = ["a", "", "b"].map(str::to_owned);
        for text in ["a\n\nb", "a\r\n\r\nb\r\n", "a\r\rb\r", "\u{feff}a\n\r\nb"] {
            let (numbers, found): (Vec<_>, Vec<_>) = lines(text.as_bytes()).into_iter().unzip();
            assert_eq!(found, expected, "{text:?}");
            assert_eq!(numbers, [1, 2, 3], "{text:?}");
        }
    }

    #[test]
    fn a_backslash_joins_lines_and_bad_bytes_are_replaced() {
        assert_eq!(lines(b"f 1 2\\\r\n 3\nx"), [(2, "f 1 2  3".into()), (3, "x".into())], "joined");
        assert_eq!(lines(b"o \xff"), [(1, "o \u{fffd}".into())], "replaced");
    }

    #[test]
    fn a_line_without_end_is_an_error() {
        let text = vec![b'v'; 3 * LONGEST_LINE];
        let mut reader = TextLines::new(Path::new("a.obj"), text.as_slice());
        let error = reader.read(&mut String::new()).expect_err("it is too long").to_string();
        assert!(error.contains("a.obj") && error.contains("line 1: is longer"), "{error}");
    }
}
