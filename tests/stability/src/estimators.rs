//! Estimators against closed forms: E1 to E16.

crate::catalogue! {}
