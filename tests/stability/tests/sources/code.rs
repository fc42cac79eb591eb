//! The code in a Rust file: without comments, without what is in strings, without tests.

/// The code of a file. What is not code has become blanks.
pub(crate) fn code(text: &str) -> String {
    without_tests(&without_words(text))
}

/// The lines on which there is anything, with their numbers, from 1.
pub(crate) fn lines(code: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = code.lines().enumerate().map(|(i, line)| (i + 1, line));
    lines.filter(|(_, line)| !line.trim().is_empty())
}

/// Replaces comments and the contents of strings by blanks, so that lines keep their numbers.
fn without_words(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut code = String::with_capacity(text.len());
    let mut i = 0;
    while i < chars.len() {
        let end = word_end(&chars, i);
        for &c in &chars[i..end] {
            code.push(if c == '\n' { '\n' } else { ' ' });
        }
        if end == i {
            code.push(chars[i]);
            i += 1;
        } else {
            i = end;
        }
    }
    code
}

/// Where the comment, the string or the character that begins at `i` ends; `i` if none does.
fn word_end(chars: &[char], i: usize) -> usize {
    let at = |k: usize| chars.get(k).copied().unwrap_or('\0');
    let is_in_name = i > 0 && (at(i - 1).is_alphanumeric() || at(i - 1) == '_');
    match (at(i), at(i + 1)) {
        ('/', '/') => until(chars, i, |k| at(k) == '\n'),
        ('/', '*') => {
            let (mut depth, mut k) = (1, i + 2);
            while depth > 0 && k < chars.len() {
                match (at(k), at(k + 1)) {
                    ('/', '*') => (depth, k) = (depth + 1, k + 2),
                    ('*', '/') => (depth, k) = (depth - 1, k + 2),
                    _ => k += 1,
                }
            }
            k.min(chars.len())
        }
        ('"', _) => quoted_end(chars, i, '"'),
        ('r', '"' | '#') if !is_in_name => raw_end(chars, i),
        // A lifetime has no second quote behind its first letter.
        ('\'', '\\') => quoted_end(chars, i, '\''),
        ('\'', _) if at(i + 2) == '\'' => i + 3,
        _ => i,
    }
}

/// The first place from `i` on at which `is_end` holds, or the end of the file.
fn until(chars: &[char], i: usize, is_end: impl Fn(usize) -> bool) -> usize {
    (i..chars.len()).find(|&k| is_end(k)).unwrap_or(chars.len())
}

/// Behind the quote that closes the one at `i`; a backslash hides the next character.
fn quoted_end(chars: &[char], i: usize, quote: char) -> usize {
    let mut k = i + 1;
    while k < chars.len() && chars[k] != quote {
        k += if chars[k] == '\\' { 2 } else { 1 };
    }
    (k + 1).min(chars.len())
}

/// Behind a raw string that begins with the `r` at `i`; `i` if it is a name such as `r#type`.
fn raw_end(chars: &[char], i: usize) -> usize {
    let start = until(chars, i + 1, |k| chars[k] != '#');
    if chars.get(start) != Some(&'"') {
        return i;
    }
    let hashes = start - i - 1;
    let closes = |k: usize| {
        chars[k] == '"' && chars[k + 1..].iter().take_while(|&&c| c == '#').count() >= hashes
    };
    (until(chars, start + 1, closes) + 1 + hashes).min(chars.len())
}

/// Blanks what stands behind `#[cfg(test)]`: up to the brace that closes the first one, or up to a
/// semicolon before any.
fn without_tests(code: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let mut rest = code;
    let mut kept = String::with_capacity(code.len());
    while let Some(start) = rest.find(MARK) {
        kept.push_str(&rest[..start]);
        let mut depth = 0_u32;
        let closes = |(_, c): &(usize, char)| match c {
            '{' => {
                depth += 1;
                false
            }
            '}' => {
                depth = depth.saturating_sub(1);
                depth == 0
            }
            ';' => depth == 0,
            _ => false,
        };
        let end = rest[start..].char_indices().find(closes);
        let end = end.map_or(rest.len(), |(i, _)| start + i + 1);
        kept.extend(rest[start..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
        rest = &rest[end..];
    }
    kept + rest
}

/// Whether `c` can stand in a name.
pub(crate) fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

#[cfg(test)]
mod tests {
    use super::{code, lines};

    /// The code of a text, its words joined.
    fn joined(text: &str) -> String {
        code(text).split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn comments_are_no_code() {
        assert_eq!(joined("a // b\n/// c\n//! d\ne"), "a e", "line comments");
        assert_eq!(joined("a /* b /* c */ d\n */ e"), "a e", "nested comments");
        assert_eq!(joined("a / b * c"), "a / b * c", "a quotient");
    }

    #[test]
    fn strings_are_no_code() {
        assert_eq!(joined(r#"f("1e-4 \" // ", 2)"#), "f( , 2)", "an escaped quote");
        assert_eq!(joined(r###"f(r#"a " b"#, 2)"###), "f( , 2)", "a raw string");
        assert_eq!(joined(r"f('\'', 'a', '/')"), "f( , , )", "characters");
        assert_eq!(joined("fn f<'a>(x: &'a str) {}"), "fn f<'a>(x: &'a str) {}", "lifetimes");
        assert_eq!(joined("for \"a\"; bar \"b\""), "for ; bar", "names that end in r");
    }

    #[test]
    fn tests_are_no_code() {
        let text = "a\n#[cfg(test)]\nmod tests {\n fn f() { b }\n}\nc\n#[cfg(test)]\nmod d;\ne";
        assert_eq!(joined(text), "a c e", "a module of tests, and one in a file of its own");
    }

    #[test]
    fn lines_keep_their_numbers() {
        let code = code("a\n\n// b\n\"\n\n\" c\n");
        let numbers: Vec<usize> = lines(&code).map(|(i, _)| i).collect();
        assert_eq!(numbers, [1, 6], "lines with code");
    }
}
