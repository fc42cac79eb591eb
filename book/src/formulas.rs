//! Formulas: the TeX between `$…$` and `$$…$$` becomes MathML, at build time.
//!
//! The page is parsed with the same Markdown rules as mdBook's, plus math, and only the byte ranges
//! of formulas are replaced: code blocks, code spans and everything else stay untouched. A formula
//! with an error in it fails the build, and the message shows page, formula and reason.

use std::fmt::Write;
use std::ops::Range;

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::{Error, Result};

/// The preprocessor named `formulas`; it must run after `links`, so that included text has its
/// formulas set as well.
pub struct Formulas;

impl Preprocessor for Formulas {
    fn name(&self) -> &str {
        "formulas"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let mut errors = String::new();
        book.for_each_chapter_mut(|chapter| match typeset(&chapter.content) {
            Ok(content) => chapter.content = content,
            Err(page_errors) => {
                let path = chapter.path.as_deref().unwrap_or("?".as_ref()).display();
                for error in page_errors {
                    // Writing to a String cannot fail.
                    let _ = write!(errors, "\n  {path}: {error}");
                }
            }
        });
        if errors.is_empty() {
            Ok(book)
        } else {
            Err(Error::msg(format!("formulas that cannot be set:{errors}")))
        }
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(renderer == "html")
    }
}

/// The page with every formula as MathML.
///
/// # Errors
///
/// One sentence for each formula that is not valid TeX math, for each that cites an equation which
/// the page lacks, and for each dollar sign that belongs to no formula.
pub fn typeset(markdown: &str) -> std::result::Result<String, Vec<String>> {
    let lonely = lonely_dollars(markdown);
    if !lonely.is_empty() {
        return Err(lonely);
    }
    let formulas = find(markdown);
    let snippets: Vec<_> = formulas.iter().map(|f| (f.tex.as_str(), f.display)).collect();
    // Default settings hold no macros, and only a macro can be wrong here.
    let converter = LatexToMathML::new(MathCoreConfig::default())
        .map_err(|(error, ..)| vec![error.error_message()])?;

    let mut page = String::with_capacity(markdown.len());
    let mut errors = Vec::new();
    let mut copied = 0;
    for (formula, result) in formulas.iter().zip(converter.convert_all(&snippets)) {
        page.push_str(&markdown[copied..formula.range.start]);
        copied = formula.range.end;
        match result {
            Ok(math) if math.warnings.has_any() => {
                errors.push(format!("{}: unknown equation or command", formula.source(markdown)));
            }
            Ok(math) => {
                let follower = formula.follower(markdown);
                page.push_str(&formula.html(&math.mathml, follower));
                copied += follower.len();
            }
            Err(error) => {
                let mut reason = String::new();
                error.to_message(&mut reason, &formula.tex);
                errors.push(format!("{}: at character {reason}", formula.source(markdown)));
            }
        }
    }
    page.push_str(&markdown[copied..]);
    if errors.is_empty() { Ok(page) } else { Err(errors) }
}

/// The Markdown that mdBook 0.5 reads, with its default settings.
#[must_use]
pub fn markdown_options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
}

struct Formula {
    /// Where it stands in the page, dollar signs included, in bytes.
    range: Range<usize>,
    tex: String,
    display: MathDisplay,
}

impl Formula {
    fn source<'a>(&self, markdown: &'a str) -> &'a str {
        &markdown[self.range.clone()]
    }

    /// The punctuation mark right behind an inline formula, which must not begin the next line.
    fn follower<'a>(&self, markdown: &'a str) -> &'a str {
        let rest = &markdown[self.range.end..];
        let is_mark = rest.starts_with(['.', ',', ';', ':', '?', ')']);
        if is_mark && self.display == MathDisplay::Inline { &rest[..1] } else { "" }
    }

    fn html(&self, mathml: &str, follower: &str) -> String {
        let math = shield(mathml);
        match self.display {
            MathDisplay::Inline if follower.is_empty() => math,
            MathDisplay::Inline => format!("<span class=\"tied\">{math}{follower}</span>"),
            // A wide formula scrolls inside its own line instead of widening the page.
            MathDisplay::Block => format!("<span class=\"formula\">{math}</span>"),
        }
    }
}

fn find(markdown: &str) -> Vec<Formula> {
    Parser::new_ext(markdown, markdown_options() | Options::ENABLE_MATH)
        .into_offset_iter()
        .filter_map(|(event, range)| {
            let (tex, display) = match event {
                Event::InlineMath(tex) => (tex, MathDisplay::Inline),
                Event::DisplayMath(tex) => (tex, MathDisplay::Block),
                _ => return None,
            };
            Some(Formula { range, tex: tex.into_string(), display })
        })
        .collect()
}

/// One sentence for each dollar sign that is neither escaped nor in code nor around a formula.
///
/// A formula with unbalanced braces, or with a space after its first dollar, is none to the parser.
fn lonely_dollars(markdown: &str) -> Vec<String> {
    let parser = Parser::new_ext(markdown, markdown_options() | Options::ENABLE_MATH);
    let mut in_code = false;
    let mut lonely = Vec::new();
    for (event, range) in parser.into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::Text(text) if text.contains('$') && !in_code => {
                let is_escaped = markdown[..range.start].ends_with('\\');
                if !is_escaped || text.matches('$').count() > 1 {
                    lonely.push(format!("`{text}`: a dollar sign around no formula; money is \\$"));
                }
            }
            _ => {}
        }
    }
    lonely
}

/// Writes the punctuation between the tags as character references.
///
/// The page will be read as Markdown once more, by mdBook, which must not take a `*` for emphasis,
/// a `|` for the border of a table's cell, or a `[` for a link.
fn shield(mathml: &str) -> String {
    let mut html = String::with_capacity(2 * mathml.len());
    let mut rest = mathml;
    while let Some(c) = rest.chars().next() {
        let copied = match c {
            '<' => rest.find('>').map_or(rest.len(), |end| end + 1),
            '&' => rest.find(';').map_or(1, |end| end + 1),
            _ => c.len_utf8(),
        };
        if c == '\n' {
            html.push(' ');
        } else if copied == 1 && c.is_ascii_punctuation() {
            // Writing to a String cannot fail.
            let _ = write!(html, "&#{};", u32::from(c));
        } else {
            html.push_str(&rest[..copied]);
        }
        rest = &rest[copied..];
    }
    html
}

#[cfg(test)]
mod tests {
    use super::{shield, typeset};

    fn set(markdown: &str) -> String {
        typeset(markdown).expect("the page has only good formulas")
    }

    #[test]
    fn inline_and_display_formulas_become_mathml() {
        let page = set("Snell: $\\eta_i \\sin\\theta_i$ and\n\n$$\\frac{I}{r^2}$$\n");
        assert!(page.starts_with("Snell: <math><"), "{page}");
        assert!(page.contains("<math display=\"block\"><mfrac>"), "{page}");
        assert!(!page.contains('$'), "{page}");
    }

    #[test]
    fn a_full_stop_stays_with_its_formula() {
        let page = set("In $x$, or $y$ and (in $z$).");
        assert_eq!(page.matches("</math>,</span> or").count(), 1, "{page}");
        assert_eq!(page.matches("</math>)</span>.").count(), 1, "{page}");
        assert_eq!(page.matches("class=\"tied\"").count(), 2, "{page}");
    }

    #[test]
    fn dollars_in_code_stay_as_they_are() {
        let page = "A span `$x$`, a block\n\n```sh\necho $HOME $PATH\n```\n\n    $a$ indented\n";
        assert_eq!(set(page), page, "code is not math");
    }

    #[test]
    fn escaped_dollars_stay_as_they_are() {
        let page = "It costs \\$5, not \\$6.\n";
        assert_eq!(set(page), page, "money is not math");
    }

    #[test]
    fn a_dollar_that_belongs_to_no_formula_is_an_error() {
        for page in ["It costs $5.", "$ x $", "$$\\frac{1}{2$$", "| $a|b$ |\n|---|\n| $ |"] {
            let errors = typeset(page).expect_err("the dollars have no partner");
            assert!(errors[0].contains("\\$"), "{errors:?}");
        }
    }

    #[test]
    fn a_formula_in_a_table_leaves_the_other_cells_alone() {
        let page = set("| a | b |\n|---|---|\n| $\\lvert x \\rvert$ | `$` |\n");
        assert!(page.ends_with(" | `$` |\n"), "{page}");
        assert_eq!(page.lines().last().map(|l| l.matches('|').count()), Some(3), "{page}");
    }

    #[test]
    fn an_unknown_command_is_an_error_that_shows_the_formula() {
        let errors = typeset("Good $x$, bad $\\nonsense{x}$.").expect_err("\\nonsense is unknown");
        assert_eq!(errors.len(), 1, "{errors:?}");
        assert!(errors[0].contains("$\\nonsense{x}$"), "{errors:?}");
    }

    #[test]
    fn an_unclosed_group_is_an_error() {
        let errors = typeset("$\\left( x$").expect_err("a parenthesis is missing");
        assert_eq!(errors.len(), 1, "{errors:?}");
    }

    #[test]
    fn numbered_equations_of_one_page_can_be_cited() {
        let page = set(
            "$$\\begin{equation}a = b \\label{one}\\tag{7}\\end{equation}$$\n\nBy $\\eqref{one}$.\n",
        );
        assert_eq!(page.matches('7').count(), 2, "{page}");
        let errors = typeset("By $\\eqref{none}$.").expect_err("no such equation");
        assert!(errors[0].contains("none"), "{errors:?}");
    }

    #[test]
    fn markdown_cannot_see_the_punctuation_of_a_formula() {
        assert_eq!(shield("<mo a=\"*\">*</mo>&lt;"), "<mo a=\"*\">&#42;</mo>&lt;", "shielded");
    }
}
