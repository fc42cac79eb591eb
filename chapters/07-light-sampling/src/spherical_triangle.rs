//! A triangle as a viewer sees it: a piece of the sphere of directions.

use glam::DVec3;
use ray_casting::math;

/// The directions in which a viewer sees a triangle.
///
/// In double precision: a lamp at arm's length is where the corners' directions differ much, but a
/// viewer who nearly touches it sees one of them at 180° from another, where single precision ends.
#[derive(Clone, Copy, Debug)]
pub struct SphericalTriangle {
    /// Unit vectors a, b, c toward the corners.
    corners: [DVec3; 3],
    /// Ω, in sr, above 0 and at most 2π.
    pub solid_angle: f64,
}

impl SphericalTriangle {
    /// What is seen of the triangle with these ways to its corners, which run counter-clockwise for
    /// the viewer; `None` if they do not, and if it is seen along its plane.
    ///
    /// ```text
    /// tan(Ω/2) = det(a, c, b) / (1 + a·b + b·c + c·a)
    /// ```
    ///
    /// a, b, c have unit length \[VanOosteromStrackee83]. The determinant is taken from the edges, as
    /// a·((c − a) × (b − a)): of three nearly equal directions it would be lost in rounding.
    #[inline]
    #[must_use]
    pub fn new(ways: [DVec3; 3]) -> Option<Self> {
        let [a, b, c] = ways;
        let lengths = ways.map(DVec3::length);
        let det = a.dot((c - a).cross(b - a)) / (lengths[0] * lengths[1] * lengths[2]);
        let [a, b, c] = [a / lengths[0], b / lengths[1], c / lengths[2]];
        let rest = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
        let solid_angle = 2.0 * f64::from(math::atan2(det as f32, rest as f32));
        // A viewer at a corner has no direction toward it: then all is NaN, and nothing is seen.
        (det > 0.0 && solid_angle > 0.0).then_some(Self { corners: [a, b, c], solid_angle })
    }

    // ANCHOR: sample
    /// Draws a direction of the triangle, all equally likely: their density is 1/Ω.
    ///
    /// ```text
    /// α = u₀ Ω/2,   tan φ/2 = (1 + a·b) sin α / (cos α det(t, b, a) − sin α t·b)
    /// c' = a cos φ + t sin φ
    /// 1 − cos θ = u₁ (1 − c'·b),   ω = b cos θ + t' sin θ
    /// ```
    ///
    /// The arc from b to a point c' of the side ac cuts off the triangle abc', whose solid angle has
    /// to be the share u₀ of Ω: the formula of [`SphericalTriangle::new`], solved for the angle φ
    /// between a and c'. On that arc, directions are as likely as the strips are wide that end in
    /// them, which is uniform in the cosine of the angle θ from b. t and t' are unit vectors that lead
    /// from a to c and from b to c', at right angles to a and b.
    ///
    /// The idea is Arvo's \[Arvo95]. It departs from his algorithm in the side: that is solved by the
    /// half angle instead of the angles at the corners, which takes one sine and cosine and no
    /// arccosine, and subtracts nothing from 1.
    #[inline]
    #[must_use]
    pub fn sample(&self, u: [f64; 2]) -> DVec3 {
        let [a, b, c] = self.corners;
        let (sin, cos) = math::sin_cos_f64(0.5 * u[0] * self.solid_angle);
        let t = across(a, c);
        let n = 0.5 * (a + b).length_squared() * sin; // (1 + a·b) sin α
        let d = cos * t.dot((b - a).cross(a)) - sin * t.dot(b - a);
        let (cos_phi, sin_phi) = (d * d - n * n, 2.0 * n * d); // both times n² + d²
        let cut = (cos_phi * a + sin_phi * t) / (n * n + d * d);

        let x = u[1] * 0.5 * (cut - b).length_squared(); // 1 − cos θ
        let direction = (1.0 - x) * b + (x * (2.0 - x)).sqrt() * across(b, cut);
        // Seen from all but within an edge, its ends are opposite each other, and what is across is
        // what rounding has left.
        direction.normalize()
    }
    // ANCHOR_END: sample
}

/// The unit vector at right angles to `from` that leads to `to`; zero if the two are one.
///
/// Of the difference, which keeps its digits when they are close.
#[inline]
fn across(from: DVec3, to: DVec3) -> DVec3 {
    let way = to - from;
    (way - from.dot(way) * from).normalize_or_zero()
}
