//! Stages that have to agree, and bits that have to be the same: I1 to I7.

crate::catalogue! {}
