//! Citations: a key in brackets, like `[Whitted80]`, becomes a link into the page of references.
//!
//! The keys are the `id`s of `references.md`. A key that stands in a page but not in that list
//! fails the build, so a reader never looks for a source in vain. That holds for the comments in
//! listings, too. There a key is written `\[Whitted80]`, because a documentation comment takes
//! brackets for a link to code; the listing shows it without the backslash.

use std::collections::BTreeSet;
use std::fs;

use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::errors::Error;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use pulldown_cmark::{BrokenLink, CowStr, Event, LinkType, Parser, Tag, TagEnd};

use crate::formulas::markdown_options;
use crate::html::Page;
use crate::{Result, includes};

/// The page, beside the others, that lists the sources.
pub const REFERENCES: &str = "references.md";

/// The preprocessor named `citations`; it must run after `links`.
///
/// It also checks the includes of all pages, because mdBook itself lets a missing anchor pass.
pub struct Citations;

impl Preprocessor for Citations {
    fn name(&self) -> &str {
        "citations"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let source = context.root.join(&context.config.book.src);
        includes::check(&source)?;
        let keys = keys(&fs::read_to_string(source.join(REFERENCES)).unwrap_or_default());

        let mut errors = Vec::new();
        book.for_each_chapter_mut(|chapter| {
            let path = chapter.path.clone().unwrap_or_default();
            if path.as_os_str() == REFERENCES {
                return;
            }
            let up = "../".repeat(path.components().count().saturating_sub(1));
            match link(&chapter.content, &keys, &up) {
                Ok(content) => chapter.content = content,
                Err(unknown) => errors
                    .extend(unknown.iter().map(|key| format!("\n  {}: [{key}]", path.display()))),
            }
        });
        if errors.is_empty() {
            Ok(book)
        } else {
            let list = errors.concat();
            Err(Error::msg(format!("sources that {REFERENCES} does not list:{list}")))
        }
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(renderer == "html")
    }
}

/// The keys that `references.md` defines: the `id` of every element in it.
#[must_use]
pub fn keys(references: &str) -> BTreeSet<String> {
    Page::parse(references).ids.into_iter().collect()
}

/// The page with its keys as links; `up` leads from the page's folder to that of the references.
///
/// # Errors
///
/// The keys that are not in `keys`.
pub fn link(
    markdown: &str,
    keys: &BTreeSet<String>,
    up: &str,
) -> std::result::Result<String, Vec<String>> {
    let mut accept = |link: BrokenLink<'_>| {
        looks_like_key(&link.reference).then(|| (CowStr::from(""), CowStr::from("")))
    };
    let options = markdown_options();
    let parser = Parser::new_with_broken_link_callback(markdown, options, Some(&mut accept));

    let mut page = String::with_capacity(markdown.len());
    let mut copied = 0;
    let mut unknown = Vec::new();
    let mut is_listing = false;
    for (event, range) in parser.into_offset_iter() {
        let replacement = match event {
            Event::Start(Tag::CodeBlock(_)) => {
                is_listing = true;
                continue;
            }
            Event::End(TagEnd::CodeBlock) => {
                is_listing = false;
                continue;
            }
            Event::Text(_) if is_listing => plain(&markdown[range.clone()], keys, &mut unknown),
            Event::Start(Tag::Link { link_type: LinkType::ShortcutUnknown, id, .. }) => {
                if !keys.contains(id.as_ref()) {
                    unknown.push(id.into_string());
                    continue;
                }
                format!("\\[[{id}]({up}{REFERENCES}#{id})\\]")
            }
            _ => continue,
        };
        page.push_str(&markdown[copied..range.start]);
        page.push_str(&replacement);
        copied = range.end;
    }
    page.push_str(&markdown[copied..]);
    if unknown.is_empty() { Ok(page) } else { Err(unknown) }
}

/// The lines of a listing with keys as a reader expects them, without the backslash.
fn plain(listing: &str, keys: &BTreeSet<String>, unknown: &mut Vec<String>) -> String {
    let mut parts = listing.split("\\[");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(']').map(|(key, _)| key).filter(|key| looks_like_key(key)) {
            Some(key) => {
                if !keys.contains(key) {
                    unknown.push(key.to_owned());
                }
                text.push('[');
            }
            None => text.push_str("\\["),
        }
        text.push_str(part);
    }
    text
}

/// A name and a year or an edition: a capital letter first, a digit last, letters and digits only.
fn looks_like_key(label: &str) -> bool {
    label.starts_with(|c: char| c.is_ascii_uppercase())
        && label.ends_with(|c: char| c.is_ascii_digit())
        && label.len() > 3
        && label.chars().all(|c| c.is_ascii_alphanumeric())
}

#[cfg(test)]
mod tests {
    use super::{keys, link};

    #[test]
    fn a_known_key_becomes_a_link() {
        let keys = keys("- <b id=\"PBR4\">[PBR4]</b> A book.\n");
        let page = link("See [PBR4] §3.9.", &keys, "").expect("the key is known");
        assert_eq!(page, "See \\[[PBR4](references.md#PBR4)\\] §3.9.", "linked");
    }

    #[test]
    fn an_unknown_key_is_an_error() {
        let unknown = link("See [Nobody99].", &keys(""), "").expect_err("the key is unknown");
        assert_eq!(unknown, ["Nobody99"], "named");
    }

    #[test]
    fn code_links_and_other_brackets_stay_as_they_are() {
        let page = "`[PBR4]`, [PBR4](x.md), [0, 1), [x], [W]\n\n```text\n[PBR4]\n```\n";
        assert_eq!(link(page, &keys(""), "").as_deref(), Ok(page), "untouched");
    }
    #[test]
    fn a_key_in_a_listing_loses_its_backslash_and_must_be_known() {
        let keys = keys("<b id=\"PBR4\">[PBR4]</b>");
        let page = "```rust\n/// \\[PBR4] §3.9\nlet a = \"\\[x]\";\n```\n";
        let shown = page.replace("\\[PBR4]", "[PBR4]");
        assert_eq!(link(page, &keys, "").as_deref(), Ok(&*shown), "the listing");
        let unknown = link("```rust\n/// \\[Nobody99]\n```\n", &keys, "");
        assert_eq!(unknown, Err(vec!["Nobody99".to_owned()]), "a key without a source");
    }
}
