//! Small scene files.

/// A camera 5 before the origin, a light above it, a white material, and nothing to see.
pub(crate) const HEAD: &str = "background = [0.25, 0.5, 0.75]\n\
    [camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [24, 16]\n\
    [materials.white]\nkd = [0.5, 0.5, 0.5]\n\
    [materials.glass]\nsurface = 'glass'\n\
    [[point_light]]\nposition = [3, 4, 5]\nintensity = [20, 20, 20]\n";

/// A ball, as the last record: more of its keys may follow.
pub(crate) const BALL: &str = "[[sphere]]\ncenter = [0, 0, 0]\nmaterial = 'white'\nradius = 1\n";

/// A mesh `a.obj`, as the last record.
pub(crate) const MESH: &str = "[[mesh]]\nfile = 'a.obj'\n";

/// The head, and these records.
pub(crate) fn scene(records: &str) -> String {
    format!("{HEAD}{records}")
}
