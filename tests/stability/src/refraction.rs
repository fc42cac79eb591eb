//! Reflection, refraction, Fresnel: F1 to F15.

crate::catalogue! {}
