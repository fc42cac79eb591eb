//! The lines of an OBJ file, checked and tidied up for `tobj`.
//!
//! `tobj` reads numbers, follows negative indices and makes one index out of three. What it does
//! not do is done here, line by line: say which line is wrong, check that indices exist and
//! numbers are finite, keep vertices with and without normals apart (it would shift the normals),
//! and read files that use tabs, other line endings or vertex colours.

use std::io::{self, BufRead, Read};

use crate::SceneError;
use crate::text_lines::{TextLines, finite, keyword};

/// What the faces between two changes of material or of layout have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Group {
    /// Which material, as [`Libraries::find`] said.
    pub(crate) material: Option<u32>,
    /// Whether every corner has texture coordinates.
    pub(crate) texture_coordinates: bool,
    /// Whether every corner has a normal.
    pub(crate) normals: bool,
}

/// Whoever knows the materials that an OBJ file names.
pub(crate) trait Libraries {
    /// Reads the MTL file that `mtllib` names.
    fn load(&mut self, name: &str) -> Result<(), String>;

    /// The material that `usemtl` names; `None` is the default one.
    fn find(&mut self, name: &str) -> Result<Option<u32>, String>;
}

/// Hands `tobj` tidy lines: `v x y z [w]`, `vt u v`, `vn x y z`, `f …`, and `g` at the start of
/// each [`Group`].
pub(crate) struct ObjLines<'a, R, L> {
    lines: TextLines<'a, R>,
    libraries: &'a mut L,
    /// How many positions, texture coordinates and normals have been read.
    counts: [u64; 3],
    material: Option<u32>,
    /// The groups so far, one a mesh of `tobj`.
    pub(crate) groups: Vec<Group>,
    /// How many lines and points were left out.
    pub(crate) lines_and_points: u64,
    /// What is wrong, when a read has failed.
    pub(crate) fault: Option<SceneError>,
    line: String,
    tidy: String,
    used: usize,
}

impl<'a, R: BufRead, L: Libraries> ObjLines<'a, R, L> {
    pub(crate) fn new(lines: TextLines<'a, R>, libraries: &'a mut L) -> Self {
        Self {
            lines,
            libraries,
            counts: [0; 3],
            material: None,
            groups: Vec::new(),
            lines_and_points: 0,
            fault: None,
            line: String::new(),
            tidy: String::new(),
            used: 0,
        }
    }

    /// The error that the line read last deserves.
    pub(crate) fn error(&self, reason: impl Into<String>) -> SceneError {
        self.lines.error(reason)
    }

    /// Replaces the tidy text by that of the next line that has any; leaves it empty at the end.
    fn advance(&mut self) -> Result<(), SceneError> {
        self.tidy.clear();
        self.used = 0;
        let mut line = std::mem::take(&mut self.line);
        while self.tidy.is_empty() && self.lines.read(&mut line)? {
            self.tidy_up(&line).map_err(|reason| self.lines.error(reason))?;
        }
        self.line = line;
        Ok(())
    }

    fn tidy_up(&mut self, line: &str) -> Result<(), String> {
        let (keyword, rest) = keyword(line);
        // Names may contain a #.
        let numbers = rest.split('#').next().unwrap_or_default();
        match keyword {
            "v" => self.position(numbers),
            "vt" => self.texture_coordinates(numbers),
            "vn" => self.normal(numbers),
            "f" => self.face(numbers),
            "l" | "p" => {
                self.lines_and_points += 1;
                Ok(())
            }
            "mtllib" => self.libraries.load(rest.trim()),
            "usemtl" => {
                self.material = self.libraries.find(rest.trim())?;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// x y z, perhaps a weight w, perhaps a colour, which is left out.
    fn position(&mut self, numbers: &str) -> Result<(), String> {
        let mut values = [0.0; 7];
        let count = read_numbers("v", numbers, &mut values)?;
        if !matches!(count, 3 | 4 | 6 | 7) {
            return Err(format!("`v` has {count} numbers; it must have x, y and z"));
        }
        let weighted = matches!(count, 4 | 7);
        let [x, y, z, w, ..] = values;
        let weight = if weighted { w } else { 1.0 };
        if ![x / weight, y / weight, z / weight].iter().all(|value| value.is_finite()) {
            return Err(format!("`v` has the weight {weight}, which makes it infinite"));
        }
        self.counts[0] += 1;
        let kept = if weighted { 4 } else { 3 };
        if count == kept {
            self.emit("v", numbers);
        } else {
            let words: Vec<&str> = numbers.split_whitespace().take(kept).collect();
            self.emit("v", &words.join(" "));
        }
        Ok(())
    }

    /// u, perhaps v, perhaps a third one, which is left out.
    fn texture_coordinates(&mut self, numbers: &str) -> Result<(), String> {
        let count = read_numbers("vt", numbers, &mut [0.0; 3])?;
        if count == 0 {
            return Err("`vt` has no numbers; it must have u and v".to_owned());
        }
        self.counts[1] += 1;
        self.emit("vt", numbers);
        if count == 1 {
            self.tidy.insert_str(self.tidy.len() - 1, " 0");
        }
        Ok(())
    }

    fn normal(&mut self, numbers: &str) -> Result<(), String> {
        let count = read_numbers("vn", numbers, &mut [0.0; 3])?;
        if count != 3 {
            return Err(format!("`vn` has {count} numbers; it must have x, y and z"));
        }
        self.counts[2] += 1;
        self.emit("vn", numbers);
        Ok(())
    }

    fn face(&mut self, corners: &str) -> Result<(), String> {
        let (mut layout, mut count) = (None, 0);
        for corner in corners.split_whitespace() {
            count += 1;
            let [_, texture_coordinates, normals] = self.corner(corner)?;
            let found = (texture_coordinates, normals);
            if *layout.get_or_insert(found) != found {
                return Err(format!(
                    "the corner `{corner}` has other parts than the first one; write all of a \
                     face's corners in the same way"
                ));
            }
        }
        if count < 3 {
            self.lines_and_points += 1;
            return Ok(());
        }
        let (texture_coordinates, normals) = layout.unwrap_or_default();
        let group = Group { material: self.material, texture_coordinates, normals };
        if self.groups.last() != Some(&group) {
            self.groups.push(group);
            self.tidy.push_str("g\n");
        }
        self.emit("f", corners);
        Ok(())
    }

    /// Which of vertex, texture coordinates and normal a corner such as `3//7` names; they exist.
    fn corner(&self, corner: &str) -> Result<[bool; 3], String> {
        const NAMES: [&str; 3] = ["vertex", "texture coordinate", "normal"];
        let mut named = [false; 3];
        for (part, text) in corner.split('/').enumerate() {
            let unreadable =
                || format!("`f` has the corner `{corner}`, which is not v, v/t, v//n or v/t/n");
            let (name, count) =
                NAMES.get(part).zip(self.counts.get(part)).ok_or_else(unreadable)?;
            if text.is_empty() && part > 0 {
                continue;
            }
            let index: i64 = text.parse().map_err(|_| unreadable())?;
            if index == 0 || index.unsigned_abs() > *count {
                return Err(format!(
                    "a face uses {name} {index}, which does not exist; there are {count} so far, \
                     counted from 1, or from −1 backwards"
                ));
            }
            named[part] = true;
        }
        Ok(named)
    }

    fn emit(&mut self, keyword: &str, words: &str) {
        self.tidy.push_str(keyword);
        self.tidy.push(' ');
        self.tidy.push_str(words);
        self.tidy.push('\n');
    }
}

/// Reads the numbers of a line into `values`, and returns how many there are.
fn read_numbers(keyword: &str, text: &str, values: &mut [f32]) -> Result<usize, String> {
    let mut count = 0;
    for word in text.split_whitespace() {
        let value =
            values.get_mut(count).ok_or_else(|| format!("`{keyword}` has too many numbers"))?;
        *value = finite(word).map_err(|reason| format!("`{keyword}` {reason}"))?;
        count += 1;
    }
    Ok(count)
}

impl<R: BufRead, L: Libraries> BufRead for ObjLines<'_, R, L> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.used == self.tidy.len()
            && let Err(fault) = self.advance()
        {
            self.fault = Some(fault);
            return Err(io::Error::other("the file is at fault"));
        }
        Ok(&self.tidy.as_bytes()[self.used..])
    }

    fn consume(&mut self, amount: usize) {
        self.used += amount;
    }
}

impl<R: BufRead, L: Libraries> Read for ObjLines<'_, R, L> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}
