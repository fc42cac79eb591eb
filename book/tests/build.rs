//! Whole books, built and checked: a good one, and one for each mistake that must not pass.

use std::fs;
use std::path::Path;

use book::{Result, folder, pages};

const SETTINGS: &str = "[book]\nsrc = \"pages\"\n\
    [build]\nbuild-dir = \"site\"\ncreate-missing = false\n\
    [preprocessor.formulas]\ncommand = \"never-started\"\nafter = [\"links\"]\n\
    [preprocessor.citations]\ncommand = \"never-started\"\nafter = [\"links\"]\n\
    [output.html]\ninput-404 = \"\"\n";

const CODE: &str = "// ANCHOR: price\nlet price = \"$1\";\n// ANCHOR_END: price\n";

/// Builds a book with this one page, and returns its HTML.
fn build(page: &str) -> Result<String> {
    let root = tempfile::tempdir()?;
    let files = [
        ("book.toml", SETTINGS),
        ("code.rs", CODE),
        ("pages/SUMMARY.md", "- [Page](page.md)\n- [References](references.md)\n"),
        ("pages/page.md", page),
        ("pages/references.md", "- <b id=\"Whitted80\">[Whitted80]</b> A paper.\n"),
    ];
    for (name, text) in files {
        folder::write(&root.path().join(name), text)?;
    }
    pages::build(root.path())?;
    folder::read(&root.path().join("site/page.html"))
}

/// The message with which a book with this page fails.
fn failure(page: &str) -> String {
    match build(page) {
        Ok(_) => panic!("this page was built: {page}"),
        Err(error) => format!("{error:#}"),
    }
}

#[test]
fn formulas_listings_and_citations_reach_the_page() {
    let html = build(
        "# P\n\n$a * b * c$ and $x_1$ of [Whitted80].\n\n```rust\n{{#include ../code.rs:price}}\n```\n",
    )
    .expect("nothing is wrong with this page");
    assert_eq!(html.matches("<math>").count(), 2, "two formulas: {html}");
    assert!(!html.contains("<em>"), "a product is no emphasis: {html}");
    assert!(html.contains("<a href=\"references.html#Whitted80\">"), "{html}");
    assert!(html.contains("let price"), "the listing: {html}");
    assert!(html.contains("$1"), "a dollar in code is untouched: {html}");
    assert!(!html.contains("ANCHOR"), "the marks are not shown: {html}");
}

#[test]
fn a_wrong_formula_fails_with_page_and_formula() {
    let message = failure("# P\n\n$\\wrong{x}$\n");
    assert!(message.contains("page.md") && message.contains("$\\wrong{x}$"), "{message}");
}

#[test]
fn a_missing_anchor_fails() {
    let message = failure("# P\n\n```rust\n{{#include ../code.rs:cost}}\n```\n");
    assert!(message.contains("page.md") && message.contains("cost"), "{message}");
}

#[test]
fn an_unknown_source_fails() {
    let message = failure("# P\n\nSee [Nobody99].\n");
    assert!(message.contains("page.md") && message.contains("Nobody99"), "{message}");
}

#[test]
fn a_link_that_leads_nowhere_fails() {
    for page in ["[x](gone.md)", "[x](references.md#Gone00)", "![x](gone.png)"] {
        let message = failure(&format!("# P\n\n{page}\n"));
        assert!(message.contains("page.html") && message.contains("one"), "{page}: {message}");
    }
}

#[test]
fn a_picture_from_another_site_fails() {
    let message = failure("# P\n\n![x](https://example.org/x.png)\n");
    assert!(message.contains("outside"), "{message}");
}

#[test]
fn an_unclosed_tag_fails() {
    let message = failure("# P\n\n<figure>\n\nText.\n");
    assert!(message.contains("figure"), "{message}");
}

#[test]
fn the_real_book_has_a_page_for_every_line_of_its_summary() {
    let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("pages");
    let summary = fs::read_to_string(pages.join("SUMMARY.md")).expect("the book has a summary");
    let named = summary.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    for page in named {
        assert!(pages.join(page).is_file(), "{page} is in the summary only");
    }
}
