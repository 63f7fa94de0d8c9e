//! The union of many random cubes: mass properties, time and peak memory.
//!
//! `cargo run --release -p predicament-algorithms --example cube_union -- 1000000 [DENSITY [THREADS]]`
//!
//! Lower corners are uniform on a grid of 2^30 points along each axis; DENSITY
//! is how many cubes cover a point on average (1 if not given).

use std::time::Instant;

use predicament_algorithms::cube_union::cube_union;

#[path = "../benches/cube_union/random.rs"]
mod random;

/// The most memory that the process has had, in KiB; Linux only.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let usage = "usage: cube_union CUBES [DENSITY [THREADS]]";
    let count: usize = args.first().ok_or(usage)?.parse()?;
    let density: f64 = args.get(1).map_or(Ok(1.0), |arg| arg.parse())?;
    let threads: usize = args.get(2).map_or(Ok(1), |arg| arg.parse())?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (lowers, edge) = random::cubes(count, density, 2026);
    let before = peak();
    let start = Instant::now();
    let mass = pool.install(|| cube_union(&lowers, edge))?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{count} cubes of edge {edge}, density {density}, {threads} threads");
    println!("{mass:?}");
    println!("Euler characteristic {:?}", mass.vertices.euler_characteristic());
    #[allow(clippy::cast_precision_loss)] // for a person to read
    let [cubes, before, after] = [count as f64, before.unwrap_or(0) as f64, peak().unwrap_or(0) as f64];
    println!("{seconds:.3} s, {:.0} cubes/s/thread", cubes / seconds / f64::from(u32::try_from(threads)?));
    println!(
        "peak {:.0} MiB, {:.0} MiB of them before; {:.1} bytes a cube",
        after / 1024.0,
        before / 1024.0,
        after * 1024.0 / cubes
    );
    Ok(())
}
