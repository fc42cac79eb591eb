//! Rays and triangles: T1 to T18.

crate::catalogue! {}
