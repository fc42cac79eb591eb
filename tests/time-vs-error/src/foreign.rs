//! Curves of other renderers, measured elsewhere.

use std::fs;
use std::path::Path;

use crate::csv;
use crate::error::{Error, Result};
use crate::plot::{Line, Mark};

/// A curve of another renderer.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The scene, as the course names it.
    pub scene: String,
    /// Renderer and setting.
    pub name: String,
    /// Seconds of rendering on one thread, and relMSE less that of the reference.
    pub points: Vec<[f64; 2]>,
}

const HEADER: [&str; 5] = ["scene", "renderer", "setting", "seconds", "rel_mse"];

impl Foreign {
    /// The curve in units of time of a plot.
    #[must_use]
    pub fn line(&self, unit: f64) -> Line {
        let mark = |&[seconds, y]: &[f64; 2]| Mark { x: seconds / unit, y, interval: 0.0 };
        Line { name: self.name.clone(), points: self.points.iter().map(mark).collect() }
    }
}

/// Reads the file of `--rows`; rows of one scene, renderer and setting make a curve.
///
/// # Errors
/// If the file cannot be read, has other columns, or a number in it is no number.
pub fn read(path: &Path) -> Result<Vec<Foreign>> {
    let text = fs::read_to_string(path).map_err(|error| Error::file(path, error))?;
    parse(&text).map_err(|reason| Error::file(path, reason))
}

fn parse(text: &str) -> std::result::Result<Vec<Foreign>, String> {
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let header = lines.next().and_then(|(_, line)| csv::cells(line));
    if header.is_none_or(|cells| cells != HEADER) {
        return Err(format!("its first line is not `{}`", HEADER.join(",")));
    }
    let mut curves: Vec<Foreign> = Vec::new();
    for (i, line) in lines {
        let broken =
            || format!("line {}: not `{}` with two positive numbers", i + 1, HEADER.join(","));
        let cells =
            csv::cells(line).filter(|cells| cells.len() == HEADER.len()).ok_or_else(broken)?;
        let positive = |cell: &String| {
            cell.trim().parse().ok().filter(|v: &f64| *v > 0.0 && v.is_finite()).ok_or_else(broken)
        };
        let point = [positive(&cells[3])?, positive(&cells[4])?];
        let (scene, name) = (cells[0].clone(), format!("{}, {}", cells[1], cells[2]));
        match curves.iter_mut().find(|curve| curve.scene == scene && curve.name == name) {
            Some(curve) => curve.points.push(point),
            None => curves.push(Foreign { scene, name, points: vec![point] }),
        }
    }
    for curve in &mut curves {
        curve.points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    }
    Ok(curves)
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn rows_of_one_setting_are_a_curve() {
        let text = "scene,renderer,setting,seconds,rel_mse\n\
            cornell-box,Other,\"path, 8\",2,0.5\ncornell-box,Other,\"path, 8\",1,1\n\
            furnace,Other,x,1,1e-3\n";
        let curves = parse(text).expect("three rows");
        assert_eq!(curves.len(), 2, "{curves:?}");
        assert_eq!(curves[0].name, "Other, path, 8", "{curves:?}");
        assert_eq!(curves[0].points, [[1.0, 1.0], [2.0, 0.5]], "sorted by time");
        assert_eq!(curves[0].line(0.5).points[1].x, 4.0, "in units");
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        let header = "scene,renderer,setting,seconds,rel_mse\n";
        for row in ["a,b,c,1", "a,b,c,0,1", "a,b,c,1,NaN", "a,b,c,x,1"] {
            let message = parse(&format!("{header}a,b,c,1,1\n{row}\n")).expect_err(row);
            assert!(message.starts_with("line 3"), "{row}: {message}");
        }
        assert!(parse("scene,seconds\n").expect_err("columns").contains("first line"), "columns");
    }
}
