//! Discrete oriented polytopes: K1 to K6.

crate::catalogue! {}
