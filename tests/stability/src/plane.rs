//! Rays and planes, which are two triangles: P1 to P6.

crate::catalogue! {}
