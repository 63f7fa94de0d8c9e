//! The crate `delaunay`, with points in the order of the arguments. `kernel.rs` has its conventions.

mod kernel;

fn main() -> std::process::ExitCode {
    predicament_engine::serve::<kernel::Delaunay<false>>()
}
