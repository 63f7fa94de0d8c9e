#![no_main]

use predicament_fuzz::constructed;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| constructed::check(bytes));
