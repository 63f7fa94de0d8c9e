//! tmp
use predicament_report::*;
fn main() {
    let mut args: Vec<String> = std::env::args().skip(1).collect();
    let out = args.pop().unwrap();
    let runs: Vec<RunDir> = args.iter().map(|p| RunDir::open(p).unwrap()).collect();
    write_pages(&runs, out).unwrap();
}
