//! Drawings of the derivations. Nothing in them is measured.

use crate::diagram::{Diagram, bold};
use crate::figures::Drawing;

/// The camera from the side: eye, picture at distance 1, the ray through a point of it.
pub(super) fn camera() -> Drawing {
    Diagram::new(
        300,
        "A pinhole camera from the side. The picture stands at distance 1 in front of the eye and \
         reaches up and down by the tangent of half the field of view.",
    )
    .path(0, 1.0, "5 4", "M60 150L420 17M60 150L420 283M60 150H600")
    .path(0, 3.0, "none", "M330 50V250")
    .path(2, 2.0, "none", "M170 150A110 110 0 0 0 163.2 111.8")
    .text(2, "start", [184.0, 143.0], "fov/2")
    .arrow(0, [60.0, 150.0], [326.0, 150.0])
    .text(0, "middle", [205.0, 170.0], "forward, length 1")
    .path(0, 1.0, "none", "M341 50h8M345 50V150M341 150h8")
    .text(0, "start", [356.0, 128.0], "tan(fov/2)")
    .arrow(1, [60.0, 150.0], [600.0, 40.0])
    .text(1, "end", [672.0, 30.0], "the ray through (x, y)")
    .dot(1, [330.0, 95.0])
    .dot(0, [60.0, 150.0])
    .text(0, "middle", [48.0, 176.0], "eye")
    .text(0, "start", [342.0, 238.0], "picture")
    .text(0, "end", [322.0, 42.0], "y = 0")
    .text(0, "end", [322.0, 270.0], "y = height")
    .finish()
}

/// A ray and a sphere: what the stable form measures.
pub(super) fn sphere() -> Drawing {
    Diagram::new(
        270,
        "A ray crosses a sphere. The vector l stands upright on the ray and reaches it from the \
         centre; half the chord is the root of r squared minus l squared.",
    )
    .path(0, 2.0, "none", "M330 160a100 100 0 1 0 200 0a100 100 0 1 0 -200 0z")
    .arrow(1, [60.0, 100.0], [640.0, 100.0])
    .text(1, "middle", [620.0, 90.0], "ray")
    .dot(1, [60.0, 100.0])
    .text(1, "middle", [60.0, 86.0], &bold("o"))
    .dot(0, [430.0, 160.0])
    .text(0, "start", [438.0, 178.0], &bold("c"))
    .arrow(0, [430.0, 160.0], [68.0, 102.0])
    .text(0, "middle", [210.0, 148.0], &bold("f"))
    .arrow(2, [430.0, 160.0], [430.0, 102.0])
    .text(2, "start", [437.0, 136.0], &bold("l"))
    .path(0, 1.5, "5 4", "M430 160L350 100")
    .text(0, "end", [384.0, 144.0], "r")
    .dot(3, [350.0, 100.0])
    .dot(3, [510.0, 100.0])
    .text(3, "end", [342.0, 90.0], "t₀")
    .text(3, "start", [518.0, 90.0], "t₁")
    .path(3, 1.0, "none", "M350 40v8M350 44H430M430 40v8")
    .text(3, "middle", [390.0, 30.0], "√(r² − l²)")
    .finish()
}

/// The triangle as the ray sees it: three areas around the origin.
pub(super) fn edges() -> Drawing {
    Diagram::new(
        270,
        "A triangle a, b, c seen along the ray, which is the origin. Lines from the origin to the \
         corners cut it into three triangles, U opposite a, V opposite b, W opposite c.",
    )
    .path(0, 2.0, "none", "M150 220L560 190L310 40z")
    .path(1, 1.5, "5 4", "M340 160L150 220M340 160L560 190M340 160L310 40")
    .dot(1, [340.0, 160.0])
    .text(1, "start", [350.0, 152.0], "the ray")
    .text(0, "end", [140.0, 226.0], "a")
    .text(0, "start", [570.0, 196.0], "b")
    .text(0, "middle", [310.0, 28.0], "c")
    .text(2, "middle", [420.0, 128.0], "U")
    .text(2, "middle", [262.0, 146.0], "V")
    .text(2, "middle", [350.0, 196.0], "W")
    .finish()
}
