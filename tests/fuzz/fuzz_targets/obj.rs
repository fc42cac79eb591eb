#![no_main]
//! See `stability::replay::obj`.

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| stability::replay::obj(bytes));
