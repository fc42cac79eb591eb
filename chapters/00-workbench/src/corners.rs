//! What the corners of a polygon tell: whether it has an area, and whether it is flat.
//!
//! All in f64, in which the differences and products of most f32 are exact.

/// A vector of f64.
type Vector = [f64; 3];

/// How far a quad may be from flat, compared to its longer diagonal. Measured scenes are not exact:
/// the red wall of the Cornell box is 2·10⁻³ off, and is meant to be two triangles at an angle of
/// ½°.
const FLATNESS: f64 = 1e-2;

/// (b − a) × (c − a): twice the area of the triangle, along its normal.
pub(crate) fn area_vector(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> Vector {
    cross(difference(b, a), difference(c, a))
}

/// Whether a triangle has exactly no area: two equal corners, or three on a line.
pub(crate) fn is_degenerate([a, b, c]: [[f32; 3]; 3]) -> bool {
    area_vector(a, b, c) == [0.0; 3]
}

/// Why these corners are not those of a flat quad that its diagonal from 0 to 2 divides.
pub(crate) fn quad_fault([a, b, c, d]: [[f32; 3]; 4]) -> Option<&'static str> {
    let (first, second) = (area_vector(a, b, c), area_vector(a, c, d));
    if first == [0.0; 3] || second == [0.0; 3] {
        return Some("have no area: two are equal, or three stand on a line");
    }
    if dot(first, second) <= 0.0 {
        return Some("do not go around a convex outline; list them in that order");
    }
    // Two diagonals that meet lie in a plane.
    let normal = cross(difference(c, a), difference(d, b));
    let distance = dot(difference(b, a), normal).abs() / length(normal);
    let diagonal = length(difference(c, a)).max(length(difference(d, b)));
    (distance > FLATNESS * diagonal).then_some("are not in one plane; use a mesh, or two quads")
}

/// Whether two directions are parallel or opposite, or one of them is zero: |a × b| ≤ 10⁻⁶ |a| |b|.
pub(crate) fn are_parallel(a: Vector, b: Vector) -> bool {
    length(cross(a, b)) <= 1e-6 * length(a) * length(b)
}

/// a − b.
pub(crate) fn difference(a: [f32; 3], b: [f32; 3]) -> Vector {
    std::array::from_fn(|i| f64::from(a[i]) - f64::from(b[i]))
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b.
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{is_degenerate, quad_fault};

    #[test]
    fn a_triangle_without_area_is_degenerate_and_a_tiny_one_is_not() {
        let [a, b, tiny] = [[0.0; 3], [0.1, 0.1, 0.1], [1e-30, 0.0, 0.0]];
        assert!(is_degenerate([a, a, b]), "two equal corners");
        assert!(is_degenerate([a, b, [0.3, 0.3, 0.3]]), "three on a line");
        assert!(!is_degenerate([a, tiny, [0.0, 1e-30, 0.0]]), "a tiny triangle");
        assert!(!is_degenerate([a, b, [0.3, 0.3, 0.3_f32.next_up()]]), "almost on a line");
    }

    #[test]
    fn a_quad_is_flat_and_goes_around() {
        let quad = |z| [[0.0, 0.0, z], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(quad_fault(quad(0.0)), None, "a square");
        assert_eq!(quad_fault(quad(1e-5)), None, "a square with a rounded corner");
        assert!(quad_fault(quad(0.1)).is_some(), "a bent square");
        let [a, b, c, d] = quad(0.0);
        assert!(quad_fault([a, c, b, d]).is_some(), "a bow tie");
        assert!(quad_fault([a, b, b, d]).is_some(), "a triangle");
    }
}
