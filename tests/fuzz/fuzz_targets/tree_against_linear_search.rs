#![no_main]
//! See `stability::replay::tree_against_linear_search`.

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| stability::replay::tree_against_linear_search(bytes));
