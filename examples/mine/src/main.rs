//! The tool with one more backend.

use mine::Mine;

fn main() -> std::process::ExitCode {
    predicament::cli().backend(Mine).main()
}
