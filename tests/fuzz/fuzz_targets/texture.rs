#![no_main]
//! See `stability::replay::texture`.

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| stability::replay::texture(bytes));
