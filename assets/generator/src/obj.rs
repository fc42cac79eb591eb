//! Writing OBJ files.

use crate::Surface;
use crate::decimal::{Decimal, push_integer};
use std::io::{self, Write};

/// What an OBJ file holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ObjSize {
    /// Lines that begin with `v`.
    pub vertices: u64,
    /// Lines that begin with `f`.
    pub triangles: u64,
}

/// Writes a surface as an OBJ file: positions with seven decimals, then triangles.
///
/// A vertex of exactly whole numbers is written without decimals: it saves nothing, but the
/// reference images were made from a file that writes its poles like this, and the checksum that
/// proves the two files equal compares bytes.
/// `out` should be buffered.
///
/// # Errors
/// Those of `out`.
pub fn write_obj(out: &mut impl Write, surface: &impl Surface) -> io::Result<ObjSize> {
    let mut size = ObjSize::default();
    let mut line = Vec::new();
    for position in surface.positions() {
        let whole = position.iter().all(|x| x.fract() == 0.0);
        line.clear();
        line.push(b'v');
        for x in position.map(Decimal::from) {
            line.push(b' ');
            if whole {
                x.push_whole(&mut line);
            } else {
                x.push(&mut line);
            }
        }
        line.push(b'\n');
        out.write_all(&line)?;
        size.vertices += 1;
    }
    for triangle in surface.triangles() {
        line.clear();
        line.push(b'f');
        for vertex in triangle {
            line.push(b' ');
            push_integer(&mut line, u64::from(vertex) + 1);
        }
        line.push(b'\n');
        out.write_all(&line)?;
        size.triangles += 1;
    }
    Ok(size)
}
