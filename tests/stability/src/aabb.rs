//! Axis-aligned boxes: B1 to B15.

crate::catalogue! {}
