//! The crate `delaunay`, with points sorted by vertex. `kernel.rs` has its conventions.

mod kernel;

fn main() -> std::process::ExitCode {
    predicament_engine::serve::<kernel::Delaunay<true>>()
}
