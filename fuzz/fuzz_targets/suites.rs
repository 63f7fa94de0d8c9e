#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| predicament_fuzz::suites::check(bytes));
