
fn main() -> std::process::ExitCode {
    serve::<Mine>()
}
