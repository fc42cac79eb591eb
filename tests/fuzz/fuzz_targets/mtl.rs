#![no_main]
//! See `stability::replay::mtl`.

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| stability::replay::mtl(bytes));
