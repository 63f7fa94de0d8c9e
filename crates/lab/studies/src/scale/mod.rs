//! The study of scale: do time and memory grow like the scenes, and is the stated memory enough?
//!
//! Each task names scenes of any size whose answers grow like the scenes ([`scaled_on`]). The study answers them in
//! sizes that grow tenfold, with the backend's fastest method on all threads, and measures the time and the peak
//! memory of each answer, both divided by the size. Each answer has a process of its own, if the host can start the
//! tool again. The memory that the task states beforehand ([`memory_of`]) is in the same row: `solve` refuses scenes
//! by it. Scenes that would need more than is allowed are not answered.
//!
//! * [`Scale`]: the study. [`Row`]: a row of its file.
//!
//! [`scaled_on`]: predicament_tasks::AnyTask::scaled_on
//! [`memory_of`]: predicament_tasks::AnyTask::memory_of

mod apart;
mod measured;
mod plots;
mod row;
mod study;
mod table;

pub use row::Row;
pub use study::Scale;
