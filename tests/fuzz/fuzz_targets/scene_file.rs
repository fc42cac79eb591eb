#![no_main]
//! See `stability::replay::scene_file`.

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| stability::replay::scene_file(bytes));
