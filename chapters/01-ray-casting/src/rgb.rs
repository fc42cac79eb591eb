//! Colours.

/// Red, green and blue: linear, with the primaries of Rec. 709. A radiance, an intensity or a
/// reflectance, as its name says; vectors' arithmetic works component by component.
pub type Rgb = glam::Vec3;
