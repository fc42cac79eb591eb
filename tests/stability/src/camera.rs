//! The camera: C1 to C8.

crate::catalogue! {}
