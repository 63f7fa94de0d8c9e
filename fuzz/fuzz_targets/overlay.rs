#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| predicament_fuzz::scenes::check(
    bytes,
    predicament_fuzz::tasks_of("overlay")
));

libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, seed: u32| {
    predicament_fuzz::mutate::in_place(data, size, most, seed, libfuzzer_sys::fuzzer_mutate)
});
