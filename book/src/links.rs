//! Links: every address in the built pages must lead somewhere, and none outside but for reading.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use crate::html::{Page, Reference, css_addresses};
use crate::{Error, Result, folder};

/// Checks all HTML pages and style sheets under `site`; returns how many addresses it followed.
///
/// Within the book, the file and the place in it (`#…`) must exist. Other sites may be linked to,
/// but nothing that a page needs in order to be shown may come from them. A picture must have a
/// text for readers who cannot see it.
///
/// # Errors
///
/// One line for each address that breaks one of these rules; or a file that cannot be read.
pub fn check(site: &Path) -> Result<usize> {
    let mut pages = BTreeMap::new();
    for path in folder::files(site)? {
        let relative = path.strip_prefix(site).unwrap_or(&path).to_path_buf();
        let page = match path.extension().and_then(|extension| extension.to_str()) {
            Some("html") => Page::parse(&folder::read(&path)?),
            Some("css") => style_sheet(&folder::read(&path)?),
            _ => Page::default(),
        };
        pages.insert(relative, page);
    }

    let mut broken = Vec::new();
    for (path, page) in &pages {
        let reasons = page.references.iter().filter_map(|r| {
            follow(&pages, path, r).err().map(|reason| format!("{}: {reason}", r.address))
        });
        let undescribed =
            page.undescribed.iter().map(|picture| format!("{picture}: a picture without alt text"));
        let path = path.display();
        broken.extend(reasons.chain(undescribed).map(|reason| format!("\n  {path}: {reason}")));
    }
    if broken.is_empty() {
        Ok(pages.values().map(|page| page.references.len()).sum())
    } else {
        Err(Error::msg(format!("addresses that lead nowhere:{}", broken.concat())))
    }
}

fn style_sheet(css: &str) -> Page {
    let fetched = |address| Reference { address, is_hyperlink: false };
    let references = css_addresses(css).into_iter().map(fetched).collect();
    Page { references, ..Page::default() }
}

fn follow(
    pages: &BTreeMap<PathBuf, Page>,
    from: &Path,
    reference: &Reference,
) -> std::result::Result<(), String> {
    let address = reference.address.as_str();
    let scheme = address.split_once(':').map(|(scheme, _)| scheme);
    match scheme {
        Some("http" | "https" | "mailto") if reference.is_hyperlink => return Ok(()),
        Some("data") => return Ok(()),
        Some(scheme) if scheme.chars().all(|c| c.is_ascii_alphanumeric()) => {
            return Err("the book must not need anything from outside".to_owned());
        }
        _ if address.starts_with("//") => {
            return Err("the book must not need anything from outside".to_owned());
        }
        _ => {}
    }

    let (path, place) = address.split_once('#').unwrap_or((address, ""));
    let path = path.split('?').next().unwrap_or_default();
    let target = match path {
        "" => from.to_path_buf(),
        path => join(from.parent().unwrap_or(Path::new("")), &percent_decoded(path))
            .ok_or("leads out of the book")?,
    };
    let page = pages.get(&target).ok_or("no such file")?;
    let place = percent_decoded(place);
    if place.is_empty() || page.ids.contains(&place) {
        Ok(())
    } else {
        Err(format!("no such place in {}", target.display()))
    }
}

/// `folder/path` without `.` and `..`; nothing when that would leave the book.
fn join(folder: &Path, path: &str) -> Option<PathBuf> {
    let mut joined = PathBuf::new();
    for component in folder.join(path).components() {
        match component {
            Component::Normal(name) => joined.push(name),
            Component::CurDir => {}
            Component::ParentDir => {
                if !joined.pop() {
                    return None;
                }
            }
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(joined)
}

/// `%20` and its like, resolved; what is not valid stays as it is.
fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        let code = tail.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
        match code.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) if *first == b'%' => {
                bytes.push(byte);
                rest = &tail[2..];
            }
            _ => {
                bytes.push(*first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::{check, join, percent_decoded};

    fn broken(pages: &[(&str, &str)]) -> Vec<String> {
        let site = tempfile::tempdir().expect("a temporary folder");
        for (name, text) in pages {
            let path = site.path().join(name);
            fs::create_dir_all(path.parent().expect("a file has a folder")).expect("a folder");
            fs::write(path, text).expect("a temporary file");
        }
        match check(site.path()) {
            Ok(_) => Vec::new(),
            Err(error) => error.to_string().lines().skip(1).map(str::to_owned).collect(),
        }
    }

    #[test]
    fn good_links_pass() {
        let broken = broken(&[
            ("a.html", "<a href='b/c.html#x'>c</a><a href='#y'>y</a><i id=y></i>"),
            ("b/c.html", "<i id=x></i><img src='../p%20q.png' alt='p'><a href='https://x.y'>o</a>"),
            ("p q.png", ""),
        ]);
        assert!(broken.is_empty(), "{broken:?}");
    }

    #[test]
    fn every_broken_link_is_named() {
        let broken = broken(&[
            ("a.html", "<a href='b.html'></a><a href='#no'></a><a href='../up.html'></a>"),
            ("c.html", "<img src='a.html'><script src='https://x.y/z.js'></script>"),
            ("d.css", "b { background: url(//x.y/z.png) }"),
        ]);
        assert_eq!(broken.len(), 6, "{broken:#?}");
    }

    #[test]
    fn paths_are_joined_without_leaving_the_book() {
        assert_eq!(join(Path::new("a/b"), "../c.html").as_deref(), Some(Path::new("a/c.html")));
        assert_eq!(join(Path::new(""), "../c.html"), None, "above the book");
        assert_eq!(percent_decoded("a%20%zz%"), "a %zz%", "decoded");
    }
}
