//! The union of many cubes: mass properties, time and peak memory.
//!
//! ```text
//! cargo run --release -p predicament-algorithms --example cube_union -- 1000000 --density 36
//! cargo run --release -p predicament-algorithms --example cube_union -- 1000 --write cubes.csv
//! cargo run --release -p predicament-algorithms --example cube_union -- --read cubes.csv
//! cargo run --release -p predicament-algorithms --example cube_union -- --growth target/cubes
//! ```
//!
//! Random lower corners are uniform on a grid of 2^30 points along each axis. Seconds are those of the union alone. For
//! their interpretation, see `docs/CUBES.md`.

mod file;
mod growth;
mod process;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use predicament_cube_union::algorithm::{Coordinate, Mass, cube_union};

use process::{cpu_seconds, peak_kib};

mod random;

/// Volume, surface area and edge length of the union of many cubes
#[derive(Parser)]
struct Args {
    /// The number of random cubes
    #[arg(required_unless_present_any = ["read", "growth"], conflicts_with_all = ["read", "growth"])]
    cubes: Option<usize>,

    /// The mean number of random cubes that cover a point
    #[arg(long, default_value_t = 1.0, value_parser = density)]
    density: f64,

    /// The seed of the random cubes
    #[arg(long, default_value_t = 2026)]
    seed: u64,

    /// The number of threads
    #[arg(long, default_value_t = 1)]
    threads: usize,

    /// Also write the random cubes to a file
    #[arg(long, value_name = "FILE", requires = "cubes")]
    write: Option<PathBuf>,

    /// Read the cubes from a file
    #[arg(long, value_name = "FILE")]
    read: Option<PathBuf>,

    /// Measure growth from 1,000 cubes on: a table, growth.csv and cubes.svg in this folder
    #[arg(long, value_name = "DIR", conflicts_with = "read")]
    growth: Option<PathBuf>,

    /// The maximum number of cubes in the growth table
    #[arg(long, default_value_t = 10_000_000, requires = "growth")]
    largest: usize,

    /// Print one row of the growth table
    #[arg(long, hide = true)]
    row: bool,
}

fn density(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(density) if density > 0.0 && f64::is_finite(density) => Ok(density),
        _ => Err("not a positive number".into()),
    }
}

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &Args) -> Result<(), Box<dyn std::error::Error>> {
    if let Some(folder) = &args.growth {
        return growth::run(folder, args.largest, args.threads);
    }
    if let Some(path) = &args.read {
        let (lowers, edge) = file::read(path)?;
        return measure(args, &lowers, edge);
    }
    let (lowers, edge) = random::cubes(args.cubes.unwrap_or(0), args.density, args.seed);
    if let Some(path) = &args.write {
        file::write(path, &lowers, edge)?;
    }
    measure(args, &lowers, edge)
}

fn measure<C: Coordinate>(args: &Args, lowers: &[[C; 3]], edge: C) -> Result<(), Box<dyn std::error::Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.threads).build()?;
    // The start of the threads is not part of the union.
    pool.broadcast(|_| ());
    let (input_kib, cpu) = (peak_kib()?, cpu_seconds()?);
    let start = Instant::now();
    let mass = pool.install(|| cube_union(lowers, edge))?;
    let seconds = start.elapsed().as_secs_f64();
    let row = growth::Row {
        cubes: lowers.len(),
        density: args.density,
        threads: pool.current_num_threads(),
        seconds,
        cpu_seconds: cpu_seconds()? - cpu,
        input_kib,
        peak_kib: peak_kib()?,
    };
    if args.row {
        growth::print(&row)?
    } else {
        print(&mass, edge.into(), &row)
    }
    Ok(())
}

fn print(mass: &Mass, edge: i64, row: &growth::Row) {
    println!("cubes {} of edge {edge}", row.cubes);
    println!("volume {}\narea {}\nedge length {}", mass.volume, mass.area, mass.edge_length);
    let vertices = &mass.vertices;
    println!(
        "vertices {}: {} corners, {} edge and face, {} three faces",
        vertices.total(),
        vertices.corners,
        vertices.edge_faces,
        vertices.three_faces
    );
    match vertices.euler_characteristic() {
        Some(characteristic) => println!("Euler characteristic {characteristic}"),
        None => println!("no Euler characteristic: not a closed surface"),
    }
    println!(
        "seconds {:.6} on {} threads, {:.6} of CPU: {:.0} cubes per CPU second",
        row.seconds,
        row.threads,
        row.cpu_seconds,
        row.rate()
    );
    let mib = |kib: u64| kib / 1024;
    println!(
        "peak memory {} MiB, {} MiB of them before the union; {:.1} bytes a cube",
        mib(row.peak_kib),
        mib(row.input_kib),
        row.bytes()
    );
}
