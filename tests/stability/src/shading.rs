//! Blinn-Phong: BP1 to BP12.

crate::catalogue! {}
