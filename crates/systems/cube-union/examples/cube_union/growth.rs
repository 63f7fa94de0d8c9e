//! Growth of time and memory with the number of cubes.
//!
//! Each row is measured in a separate process, so that its peak memory is not affected by other rows. Of three runs,
//! the one with the least CPU time counts.

use std::path::Path;
use std::process::Command;

use predicament_report::{Curve, Curves, curves};
use serde::{Deserialize, Serialize};

/// The first number of cubes; its successors are alternately 3 and 10/3 times as large.
const FIRST: usize = 1000;
/// The mean numbers of cubes that cover a point.
const DENSITIES: [f64; 2] = [1.0, 36.0];
const RUNS: usize = 3;

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// The measurements of one run.
#[derive(Serialize, Deserialize, Clone, Copy)]
pub struct Row {
    pub cubes: usize,
    pub density: f64,
    pub threads: usize,
    /// The elapsed time.
    pub seconds: f64,
    /// The CPU time of all threads.
    pub cpu_seconds: f64,
    /// Peak memory before the union.
    pub input_kib: u64,
    /// Peak memory after the union.
    pub peak_kib: u64,
}

#[allow(clippy::cast_precision_loss)] // far from 2^53
impl Row {
    /// Cubes per second of CPU time.
    pub fn rate(&self) -> f64 {
        self.cubes as f64 / self.cpu_seconds
    }

    /// Peak memory per cube, input included.
    pub fn bytes(&self) -> f64 {
        self.peak_kib as f64 * 1024.0 / self.cubes as f64
    }

    fn mib(&self) -> f64 {
        self.peak_kib as f64 / 1024.0
    }

    fn microseconds(&self) -> f64 {
        self.cpu_seconds * 1e6
    }
}

/// Prints a row for [`run`] to read.
pub fn print(row: &Row) -> Outcome<()> {
    let mut writer = csv::Writer::from_writer(std::io::stdout());
    writer.serialize(row)?;
    Ok(writer.flush()?)
}

fn measured(cubes: usize, density: f64, threads: usize) -> Outcome<Row> {
    let [cubes, density, threads] = [cubes.to_string(), density.to_string(), threads.to_string()];
    let output = Command::new(std::env::current_exe()?)
        .args([&cubes, "--row", "--density", &density, "--threads", &threads])
        .output()?;
    if !output.status.success() {
        return Err(format!("{cubes} cubes: {}", String::from_utf8_lossy(&output.stderr).trim()).into());
    }
    let row = csv::Reader::from_reader(&output.stdout[..]).deserialize().next();
    Ok(row.ok_or_else(|| format!("{cubes} cubes: no row"))??)
}

/// Measures, prints the table as Markdown, and writes growth.csv and cubes.svg.
pub fn run(folder: &Path, largest: usize, threads: usize) -> Outcome<()> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let path = folder.join("growth.csv");
    let mut writer = csv::Writer::from_path(&path)?;
    let mut rows: Vec<Row> = Vec::new();
    println!("| cubes | density | CPU seconds | cubes per CPU second | peak MiB | bytes a cube |");
    println!("|---:|---:|---:|---:|---:|---:|");
    for density in DENSITIES {
        let thrice = |power: usize| [power, power.saturating_mul(3)];
        let powers = std::iter::successors(Some(FIRST), |power| power.checked_mul(10));
        for cubes in powers.flat_map(thrice).take_while(|&cubes| cubes <= largest) {
            let runs = (0..RUNS).map(|_| measured(cubes, density, threads)).collect::<Outcome<Vec<Row>>>()?;
            let best = runs.into_iter().min_by(|a, b| a.cpu_seconds.total_cmp(&b.cpu_seconds));
            let row = best.ok_or("no runs")?;
            println!(
                "| {cubes} | {density} | {:.4} | {:.0} | {} | {:.1} |",
                row.cpu_seconds,
                row.rate(),
                row.peak_kib / 1024,
                row.bytes()
            );
            writer.serialize(row)?;
            rows.push(row);
        }
    }
    writer.flush()?;
    let curve = |name: String, density: f64, value: fn(&Row) -> f64| {
        #[allow(clippy::cast_precision_loss)] // far from 2^53
        let points = rows.iter().filter(|row| row.density == density).map(|row| (row.cubes as f64, value(row)));
        Curve::new(name, points.collect::<Vec<_>>())
    };
    let time =
        DENSITIES.map(|density| curve(format!("CPU microseconds, density {density}"), density, Row::microseconds));
    let memory = DENSITIES.map(|density| curve(format!("peak memory in MiB, density {density}"), density, Row::mib));
    let lines = Curves {
        x: "cubes".into(),
        y: "CPU microseconds, MiB".into(),
        curves: time.into_iter().chain(memory).collect(),
        ..Curves::default()
    };
    if let Some(picture) = curves(&lines)? {
        std::fs::write(folder.join("cubes.svg"), picture.svg)?;
    }
    println!("\n{}", folder.display());
    Ok(())
}
