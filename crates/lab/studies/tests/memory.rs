//! Stated memory, compared with the bytes that an answer and its files allocate.
//!
//! The study of scale reads the memory of a process. That says nothing about small scenes: a process uses pages again
//! that it has freed, and it never returns some. An allocator counts bytes, so scenes of milliseconds suffice. The
//! allocator counts for all threads, so the test has a program of its own.

use peak_alloc::PeakAlloc;
use predicament_studies::compare::Input;
use predicament_tasks::Purpose;
use predicament_tasks::output::Choice;
use rayon::ThreadPoolBuilder;
use tempfile::tempdir;

#[global_allocator]
static ALLOCATED: PeakAlloc = PeakAlloc;

/// The size of the scenes.
const N: usize = 10_000;

/// The most bytes that are allocated at a time to find an answer and to write its files.
fn allocated(input: Input) -> (usize, u64) {
    let (exact, folder, task) = (predicament_bundle::backend("exact").unwrap(), tempdir().unwrap(), input.task);
    let answered = |n: usize| {
        let loaded = input.sized(n).scene(1).unwrap();
        let before = ALLOCATED.current_usage();
        ALLOCATED.reset_peak_usage();
        let (scene, content) = (&loaded.scene, loaded.content.as_ref());
        let mut written = None;
        let answer = exact.answer_any(task.name(), scene, content, Purpose::Files, &mut |answer| {
            written = Some(task.write_answer(&loaded, answer, folder.path(), &Choice::default()).unwrap());
        });
        answer.unwrap();
        assert!(written.is_some_and(|written| !written.files.is_empty()), "{}", task.name());
        (ALLOCATED.peak_usage() - before, task.memory_of(&loaded).unwrap())
    };
    // The first answer makes tables that later ones use.
    answered(100);
    answered(N)
}

#[test]
fn the_stated_memory_suffices_for_an_answer_and_its_files() {
    let scaled = predicament_bundle::tasks().iter().filter_map(|&task| Some(Input { task, of: task.scaled_on()? }));
    // Each thread has memory of its own, which does not grow with the scene.
    let alone = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let measured: Vec<(&str, f64)> = scaled
        .map(|input| {
            let (most, stated) = alone.install(|| allocated(input));
            let [most, stated] = [most as u64, stated].map(predicament_records::approximately);
            (input.task.name(), most / stated)
        })
        .collect();
    assert!(measured.len() > 5, "{measured:?}");
    assert!(measured.iter().all(|(_, share)| *share < 1.0), "{measured:?}");
}
