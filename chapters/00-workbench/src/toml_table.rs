//! Tables of a TOML file, read key by key, with errors that name line, key and remedy.

use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::{SceneError, suggestion};

/// A text and the file it comes from.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) path: &'a Path,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// The error that what stands at `offset` deserves.
    pub(crate) fn error(&self, offset: usize, reason: impl Into<String>) -> SceneError {
        let before = self.text.as_bytes().iter().take(offset);
        let line = 1 + before.filter(|&&byte| byte == b'\n').count();
        SceneError::line(self.path, line, reason)
    }
}

/// A table of the file.
#[derive(Clone, Copy)]
pub(crate) struct Table<'a> {
    source: Source<'a>,
    /// What errors call it, for example "[camera]".
    name: &'a str,
    offset: usize,
    entries: &'a DeTable<'a>,
}

impl<'a> Table<'a> {
    /// The table that is the whole file.
    pub(crate) fn root(source: Source<'a>, entries: &'a DeTable<'a>) -> Self {
        Self { source, name: "the file", offset: 0, entries }
    }

    /// Fails when the table has a key that is not in `known`.
    pub(crate) fn check_keys(&self, known: &[&str]) -> Result<(), SceneError> {
        for (key, _) in self.entries {
            let name = key.get_ref().as_ref();
            if !known.contains(&name) {
                let remark = suggestion::remark(name, known.iter().copied());
                let reason = format!("{} has no key `{}`; {remark}", self.name, shortened(name));
                return Err(self.source.error(key.span().start, reason));
            }
        }
        Ok(())
    }

    /// What stands at `key`, if anything does.
    pub(crate) fn get(&self, key: &'a str) -> Option<Item<'a>> {
        let (_, value) = self.entries.iter().find(|(name, _)| name.get_ref().as_ref() == key)?;
        Some(Item { source: self.source, key, value })
    }

    /// What stands at `key`, which must be there.
    pub(crate) fn require(&self, key: &'a str) -> Result<Item<'a>, SceneError> {
        self.get(key).ok_or_else(|| {
            let reason = format!("{} needs the key `{key}`", self.name);
            self.source.error(self.offset, reason)
        })
    }

    /// The keys of the table with what stands there, in the order of their names.
    pub(crate) fn items(&self) -> impl Iterator<Item = Item<'a>> {
        let source = self.source;
        self.entries.iter().map(move |(key, value)| Item { source, key: key.get_ref(), value })
    }

    /// The tables of the array of tables `key`, none if it is left out.
    pub(crate) fn tables(&self, key: &'a str, name: &'a str) -> Result<Vec<Self>, SceneError> {
        let Some(item) = self.get(key) else {
            return Ok(Vec::new());
        };
        let DeValue::Array(array) = item.value.get_ref() else {
            return Err(item.error(format!("must be written as {name}, as often as you like")));
        };
        array.iter().map(|value| Item { value, ..item }.table(name)).collect()
    }
}

/// What stands at a key.
#[derive(Clone, Copy)]
pub(crate) struct Item<'a> {
    source: Source<'a>,
    pub(crate) key: &'a str,
    value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Item<'a> {
    /// The error "line n: `key` …".
    pub(crate) fn error(&self, reason: impl AsRef<str>) -> SceneError {
        self.error_at(self.value.span(), reason.as_ref())
    }

    fn error_at(&self, span: Range<usize>, reason: &str) -> SceneError {
        self.source.error(span.start, format!("`{}` {reason}", shortened(self.key)))
    }

    /// A table, which errors call `name`.
    pub(crate) fn table(&self, name: &'a str) -> Result<Table<'a>, SceneError> {
        match self.value.get_ref() {
            DeValue::Table(entries) => {
                Ok(Table { source: self.source, name, offset: self.value.span().start, entries })
            }
            _ => Err(self.error("must be a table")),
        }
    }

    /// A text.
    pub(crate) fn text(&self) -> Result<&'a str, SceneError> {
        match self.value.get_ref() {
            DeValue::String(text) => Ok(text),
            _ => Err(self.error("must be a text in quotes")),
        }
    }

    /// A finite number.
    pub(crate) fn number(&self) -> Result<f32, SceneError> {
        self.number_at(self.value)
    }

    /// A finite number of which `right` holds; `rule` says what that is.
    pub(crate) fn number_that(
        &self,
        right: impl Fn(f32) -> bool,
        rule: &str,
    ) -> Result<f32, SceneError> {
        let number = self.number()?;
        if right(number) { Ok(number) } else { Err(self.error(format!("is {number}; {rule}"))) }
    }

    /// A whole number, at least `least`.
    pub(crate) fn whole(&self, least: u32) -> Result<u32, SceneError> {
        self.whole_at(self.value, least)
    }

    /// N finite numbers.
    pub(crate) fn vector<const N: usize>(&self) -> Result<[f32; N], SceneError> {
        self.array(|value| self.number_at(value))
    }

    /// N whole numbers, each at least `least`.
    pub(crate) fn whole_vector<const N: usize>(&self, least: u32) -> Result<[u32; N], SceneError> {
        self.array(|value| self.whole_at(value, least))
    }

    /// N vectors of M finite numbers.
    pub(crate) fn vectors<const N: usize, const M: usize>(
        &self,
    ) -> Result<[[f32; M]; N], SceneError> {
        self.array(|value| Item { value, ..*self }.vector())
    }

    /// A linear colour: three finite numbers, at least 0.
    pub(crate) fn color(&self) -> Result<[f32; 3], SceneError> {
        let color = self.vector()?;
        match color.iter().find(|&&value| value < 0.0) {
            Some(negative) => {
                Err(self.error(format!("has the value {negative}; it must be at least 0")))
            }
            None => Ok(color),
        }
    }

    fn array<T, const N: usize>(
        &self,
        read: impl Fn(&'a Spanned<DeValue<'a>>) -> Result<T, SceneError>,
    ) -> Result<[T; N], SceneError> {
        let DeValue::Array(array) = self.value.get_ref() else {
            return Err(self.error(format!("must be {N} values in brackets")));
        };
        let wrong_length = || self.error(format!("has {} values; it must have {N}", array.len()));
        if array.len() != N {
            return Err(wrong_length());
        }
        let values: Vec<T> = array.iter().map(read).collect::<Result<_, _>>()?;
        values.try_into().map_err(|_| wrong_length())
    }

    fn number_at(&self, value: &Spanned<DeValue<'_>>) -> Result<f32, SceneError> {
        let number = match value.get_ref() {
            // Read as f32 at once: by way of f64 it would be rounded twice.
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Integer(integer) => {
                i128::from_str_radix(integer.as_str(), integer.radix()).ok().map(|n| n as f32)
            }
            _ => return Err(self.error_at(value.span(), "must be made of numbers")),
        };
        match number {
            Some(number) if f32::is_finite(number) => Ok(number),
            _ => {
                let text = shortened(&self.source.text[value.span()]).to_owned();
                let reason = format!("has the value {text}, which is not a finite 32-bit number");
                Err(self.error_at(value.span(), &reason))
            }
        }
    }

    fn whole_at(&self, value: &Spanned<DeValue<'_>>, least: u32) -> Result<u32, SceneError> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => {
                i128::from_str_radix(integer.as_str(), integer.radix()).ok()
            }
            _ => None,
        };
        number.and_then(|n| u32::try_from(n).ok()).filter(|&n| n >= least).ok_or_else(|| {
            let text = shortened(&self.source.text[value.span()]).to_owned();
            let reason =
                format!("has the value {text}; it must be a whole number, at least {least}");
            self.error_at(value.span(), &reason)
        })
    }
}

/// The beginning of a text that may be a megabyte long.
pub(crate) fn shortened(text: &str) -> &str {
    match text.char_indices().nth(60) {
        Some((end, _)) => &text[..end],
        None => text,
    }
}
