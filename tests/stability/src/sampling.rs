//! Samplers and their densities: M1 to M14.

crate::catalogue! {}
