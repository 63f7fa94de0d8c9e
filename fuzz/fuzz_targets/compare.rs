#![no_main]

use predicament_fuzz::check;
use predicament_predicates::PredicateKind;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check(PredicateKind::Compare, bytes));
