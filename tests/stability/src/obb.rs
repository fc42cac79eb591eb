//! Oriented boxes: O1 to O8.

crate::catalogue! {}
