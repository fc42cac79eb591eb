//! Includes: every `{{#include FILE:ANCHOR}}` of the pages must find its file and its anchor.
//!
//! mdBook logs a missing file and silently shows nothing for a missing anchor, so a listing could
//! vanish from the book when code is renamed. Line numbers in an include are refused for the same
//! reason: they keep "working" after the code above them grew, and show the wrong lines.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{Error, Result, folder};

/// Checks the includes of every Markdown file under `source`, and lists all that are broken.
///
/// # Errors
///
/// One line for each include whose file or anchor does not exist, whose text is empty, or that
/// names line numbers; or a page that cannot be read.
pub fn check(source: &Path) -> Result<()> {
    let mut broken = Vec::new();
    let is_page = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "md");
    for page in folder::files(source)?.into_iter().filter(is_page) {
        let from = page.parent().unwrap_or(source);
        for target in targets(&folder::read(&page)?) {
            if let Err(reason) = resolve(from, &target) {
                let page = page.strip_prefix(source).unwrap_or(&page).display();
                broken.push(format!("\n  {page}: {{{{#include {target}}}}}: {reason}"));
            }
        }
    }
    if broken.is_empty() {
        Ok(())
    } else {
        Err(Error::msg(format!("includes that show nothing:{}", broken.concat())))
    }
}

/// What stands after `#include` in each include of a page; `\{{#include …}}` is text, not one.
fn targets(markdown: &str) -> Vec<String> {
    let mut targets = Vec::new();
    for (start, _) in markdown.match_indices("{{#") {
        let inside = &markdown[start + 3..];
        let Some(end) = inside.find("}}") else {
            continue;
        };
        let mut words = inside[..end].split_whitespace();
        let is_include = matches!(words.next(), Some("include" | "rustdoc_include" | "playground"));
        if let (true, false, Some(target)) =
            (is_include, markdown[..start].ends_with('\\'), words.next())
        {
            targets.push(target.to_owned());
        }
    }
    targets
}

/// Whether `FILE` or `FILE:ANCHOR` shows any text; if not, why.
fn resolve(folder: &Path, target: &str) -> std::result::Result<(), String> {
    let (file, anchor) = match target.split_once(':') {
        Some((file, anchor)) => (file, Some(anchor)),
        None => (target, None),
    };
    let text = fs::read_to_string(folder.join(file)).map_err(|error| error.to_string())?;
    let shown = match anchor {
        None => text.trim().is_empty().then_some("the file is empty"),
        Some(a) if a.starts_with(|c: char| c.is_ascii_digit() || c == ':') => {
            Some("line numbers go stale, use an anchor")
        }
        Some(a) => region(&text, a).err(),
    };
    shown.map_or(Ok(()), |reason| Err(reason.to_owned()))
}

/// Whether `text` has a non-empty region between `ANCHOR: name` and `ANCHOR_END: name`.
fn region(text: &str, name: &str) -> std::result::Result<(), &'static str> {
    let marks = |line: &str, mark: &str| {
        line.split_once(mark).is_some_and(|(_, rest)| {
            let found = rest.trim_start();
            let end = found.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '-'));
            &found[..end.unwrap_or(found.len())] == name
        })
    };
    let mut lines = text.lines();
    if !lines.any(|line| marks(line, "ANCHOR:")) {
        return Err("no such anchor");
    }
    let mut empty = true;
    for line in lines {
        if marks(line, "ANCHOR_END:") {
            return if empty { Err("the anchor's region is empty") } else { Ok(()) };
        }
        empty &= line.trim().is_empty() || line.contains("ANCHOR");
    }
    Err("the anchor has no ANCHOR_END")
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{check, region, targets};

    const CODE: &str = "\
// ANCHOR: full
fn f() {}
// ANCHOR_END: full
// ANCHOR: empty

// ANCHOR_END: empty
// ANCHOR: full-open
fn g() {}
";

    #[test]
    fn a_region_needs_both_marks_and_some_text() {
        assert_eq!(region(CODE, "full"), Ok(()), "a good anchor");
        assert!(region(CODE, "empty").is_err(), "nothing between the marks");
        assert!(region(CODE, "full-open").is_err(), "no end mark");
        assert!(region(CODE, "ful").is_err(), "a prefix of a name is another name");
        assert!(region(CODE, "absent").is_err(), "no such name");
    }

    #[test]
    fn includes_are_found_unless_escaped() {
        let page = "{{#include a.rs:x}} \\{{#include b.rs}} {{ #include c }} {{#title T}}";
        assert_eq!(targets(page), ["a.rs:x"], "one include");
    }

    #[test]
    fn the_check_names_every_broken_include() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let write = |name: &str, text: &str| {
            fs::write(folder.path().join(name), text).expect("a temporary file");
        };
        write("code.rs", CODE);
        write("good.md", "{{#include code.rs:full}} {{#include code.rs}}");
        check(folder.path()).expect("both includes are good");

        write("bad.md", "{{#include code.rs:gone}} {{#include no.rs}} {{#include code.rs:2:3}}");
        let message = check(folder.path()).expect_err("three are broken").to_string();
        assert_eq!(message.lines().count(), 4, "{message}");
        assert!(message.contains("bad.md: {{#include code.rs:gone}}: no such anchor"), "{message}");
    }
}
