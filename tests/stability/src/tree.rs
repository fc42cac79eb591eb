//! Trees: V1 to V14.

crate::catalogue! {}
