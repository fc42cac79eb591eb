//! Pictures: G1 to G7.

crate::catalogue! {}
