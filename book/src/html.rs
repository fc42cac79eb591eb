//! HTML, read just well enough to find what a page names and what it refers to.

/// The parts of an HTML page that links are about.
#[derive(Debug, Default, PartialEq)]
pub struct Page {
    /// The `id` of every element, in order.
    pub ids: Vec<String>,
    /// Every address in the page, in order.
    pub references: Vec<Reference>,
    /// The `src` of every picture without a text for those who cannot see it.
    pub undescribed: Vec<String>,
}

/// An address in a page.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The address as written, with character references such as `&amp;` resolved.
    pub address: String,
    /// Whether the reader follows it (`<a href>`), or the browser fetches it to show the page.
    pub is_hyperlink: bool,
}

impl Page {
    /// Reads a page. Broken HTML is read as far as it makes sense.
    #[must_use]
    pub fn parse(html: &str) -> Self {
        let mut page = Self::default();
        let mut rest = html;
        while let Some(start) = rest.find('<') {
            rest = &rest[start..];
            if rest.starts_with("<!--") {
                rest = after(rest, "-->");
                continue;
            }
            let (tag, length) = Tag::parse(rest);
            rest = &rest[length..];
            match tag.name.as_str() {
                "script" => rest = after(rest, "</script>"),
                "style" => {
                    let end = rest.find("</style>").unwrap_or(rest.len());
                    page.references.extend(fetched(css_addresses(&rest[..end])));
                    rest = &rest[end..];
                }
                _ => {}
            }
            page.add(&tag);
        }
        page
    }

    fn add(&mut self, tag: &Tag) {
        for (name, value) in &tag.attributes {
            match name.as_str() {
                "id" => self.ids.push(value.clone()),
                "style" => self.references.extend(fetched(css_addresses(value))),
                "href" | "src" | "poster" | "data" | "xlink:href" => {
                    let is_hyperlink = tag.name == "a" && name == "href";
                    self.references.push(Reference { address: value.clone(), is_hyperlink });
                }
                _ => {}
            }
        }
        let describes = |(name, value): &(String, String)| name == "alt" && !value.is_empty();
        if tag.name == "img" && !tag.attributes.iter().any(describes) {
            self.undescribed.push(tag.attribute("src").unwrap_or_default().to_owned());
        }
    }
}

/// The addresses that a style sheet fetches: `url(…)` and `@import "…"`.
#[must_use]
pub fn css_addresses(css: &str) -> Vec<String> {
    let unquote = |text: &str| text.trim().trim_matches(['"', '\'']).to_owned();
    let urls = css.match_indices("url(").filter_map(|(start, _)| {
        let inside = &css[start + 4..];
        inside.find(')').map(|end| unquote(&inside[..end]))
    });
    let imports = css.match_indices("@import").filter_map(|(start, _)| {
        let inside = css[start + 7..].trim_start();
        let quoted = inside.starts_with(['"', '\'']);
        inside.find(';').filter(|_| quoted).map(|end| unquote(&inside[..end]))
    });
    urls.chain(imports).collect()
}

fn fetched(addresses: Vec<String>) -> impl Iterator<Item = Reference> {
    addresses.into_iter().map(|address| Reference { address, is_hyperlink: false })
}

fn after<'a>(text: &'a str, mark: &str) -> &'a str {
    text.find(mark).map_or("", |start| &text[start + mark.len()..])
}

/// An opening tag; of a closing one only the slash that its name starts with matters.
struct Tag {
    name: String,
    attributes: Vec<(String, String)>,
}

impl Tag {
    /// Reads the tag at the start of `text`, which is a `<`; returns it with its length in bytes.
    fn parse(text: &str) -> (Self, usize) {
        let is_space_or_end = |c: char| c.is_ascii_whitespace() || c == '>';
        let end = text.find(is_space_or_end).unwrap_or(text.len());
        let mut tag = Self {
            name: text[1..end].trim_end_matches('/').to_ascii_lowercase(),
            attributes: Vec::new(),
        };
        let mut rest = &text[end..];
        loop {
            rest = rest.trim_start_matches(|c: char| c.is_ascii_whitespace() || c == '/');
            if rest.is_empty() || rest.starts_with('>') {
                let length = text.len() - rest.len() + rest.len().min(1);
                return (tag, length);
            }
            let end = rest.find(|c| is_space_or_end(c) || c == '=').unwrap_or(rest.len());
            let name = rest[..end.max(1)].to_ascii_lowercase();
            rest = &rest[end.max(1)..];
            let value;
            (value, rest) = attribute_value(rest);
            tag.attributes.push((name, value));
        }
    }

    fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(n, _)| n == name).map(|(_, value)| value.as_str())
    }
}

/// Splits `="value" more` into the value and the rest; an attribute without `=` has the value "".
fn attribute_value(text: &str) -> (String, &str) {
    let Some(text) = text.strip_prefix('=') else {
        return (String::new(), text);
    };
    let quote = text.chars().next().filter(|c| matches!(c, '"' | '\''));
    let (value, rest) = match quote {
        Some(quote) => text[1..].split_once(quote).unwrap_or((&text[1..], "")),
        None => {
            let is_end = |c: char| c.is_ascii_whitespace() || c == '>';
            text.split_at(text.find(is_end).unwrap_or(text.len()))
        }
    };
    (value.replace("&amp;", "&").replace("&quot;", "\"").replace("&#39;", "'"), rest)
}

#[cfg(test)]
mod tests {
    use super::{Page, css_addresses};

    #[test]
    fn addresses_and_names_are_found_however_they_are_quoted() {
        let page = Page::parse(
            "<!-- <a href=no> --><h2 id=top class='x'>T</h2><a href='a.html?q=1&amp;r'>a</a>\
             <img src=\"p.png\" alt=\"a < b\"><img src=q.png><script>'<a href=no>'</script>\
             <style>b { background: url(\"c.png\") }</style><br/>",
        );
        let addresses: Vec<_> = page.references.iter().map(|r| r.address.as_str()).collect();
        assert_eq!(page.ids, ["top"], "ids");
        assert_eq!(addresses, ["a.html?q=1&r", "p.png", "q.png", "c.png"], "addresses");
        assert!(page.references[0].is_hyperlink, "the reader follows <a>");
        assert!(!page.references[1].is_hyperlink, "the browser fetches <img>");
        assert_eq!(page.undescribed, ["q.png"], "a picture without alt");
    }

    #[test]
    fn broken_html_ends_the_search_quietly() {
        for html in ["<", "<a", "<a href", "<a href=", "<a href=\"x", "<!-- ", "< >", "<a =>"] {
            let page = Page::parse(html);
            assert!(page.ids.is_empty(), "{html}: {page:?}");
        }
    }

    #[test]
    fn style_sheets_fetch_by_url_and_import() {
        let css = "@import 'a.css'; @import url(b.css); i { src: url( 'c.woff2' ) }";
        assert_eq!(css_addresses(css), ["b.css", "c.woff2", "a.css"], "three addresses");
    }
}
