//! A picture in five lines.

use workbench::Image;

/// Size, mean, minimum, maximum (red, green, blue) and the hash of all floats, as text.
///
/// The first lines tell a person how a picture changed; the last one tells that it did.
pub(crate) fn summary(image: &Image) -> String {
    let [r, g, b] = image.mean();
    let mean = format!("{r:.7} {g:.7} {b:.7}");
    let list = |[r, g, b]: [f32; 3]| format!("{r} {g} {b}"); // the shortest text of the very float
    format!(
        "size     {} x {}\nmean     {mean}\nminimum  {}\nmaximum  {}\nhash     {:016x}\n",
        image.width,
        image.height,
        list(image.min()),
        list(image.max()),
        image.hash()
    )
}
