//! `resolve`: turns a self-intersecting mesh into one that does not intersect itself.

use std::collections::BTreeMap;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use predicament_exact::Exact;
use predicament_formats::{CorpusError, Decimals, MeshFormat, mesh, read_bytes, write_mesh};
use predicament_mesh::MaterialError;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_mesh_intersect::algorithm::resolve::{Counts, Unresolved, rounded};
use predicament_mesh_intersect::algorithm::rounding::Closed;
use predicament_mesh_intersect::checks::flaw_of;
use predicament_predicates::Vertex;
use predicament_records::replace;

use crate::exit::{self, Failure};
use crate::progress;

const EXAMPLES: &str = "\
The mesh has to be closed: triangles on both sides use each edge equally often in each direction. The result is the \
surface of the points with a positive winding number. Overlapping parts become one; parts inside other parts and \
parts that are inside out are removed. Triangles that cross, fold onto or touch each other meet in common corners and \
edges. Decisions are exact. Constructed vertices are rounded to doubles; if triangles then cross, the mesh is \
resolved again.

The output is OFF, OBJ, PLY (binary) or STL (ASCII), by the name of the file. Results of up to 2,000 triangles are \
checked in rationals; --check also checks larger ones. Crossings that remain after rounding are reported, with exit \
code 100.

Examples:
  predicament corpus resolve part.stl --out part-resolved.off
  predicament corpus resolve scan.ply.gz --round --out scan.ply && predicament solve mesh-intersect scan.ply tool.off \\
      -b sos:per-mesh --out out/cut";

/// Results with more triangles are checked only on request.
const CHECKED: usize = 2_000;

/// Resolve a mesh that crosses, folds onto or touches itself, exactly, and round the result
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The mesh: .off, .obj, .ply or .stl, optionally followed by .gz
    #[arg(value_name = "MESH")]
    pub mesh: PathBuf,

    /// The file to write: .off, .obj, .ply or .stl
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,

    /// Round decimals that are not doubles to the nearest double
    #[arg(long)]
    pub round: bool,

    /// Check a result of any size in rationals
    #[arg(long)]
    pub check: bool,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let _working = progress::working("resolving the mesh");
    let format = format(&args.out)?;
    let given = read(args)?;
    let (mesh, counts) = rounded(&Exact, &given).map_err(|why| Failure::usage(unresolved(&why, &args.mesh)))?;
    if mesh.triangles.is_empty() {
        let message = format!("{}: the result is empty: no point has a positive winding number", args.mesh.display());
        return Err(Failure::usage(format!("{message}; turn it over if it is inside out")));
    }
    write(&args.out, format, &mesh)?;
    told(&given, &mesh, &counts, args);
    if counts.left > 0 {
        note!("{} pairs of triangles still cross: they are closer together than neighbouring doubles", counts.left);
        return Ok(exit::UNEXPECTED);
    }
    if args.check || mesh.triangles.len() <= CHECKED {
        if let Some(flaw) = flaw_of(&mesh.points, &mesh.triangles) {
            note!("{}: {flaw}; this is a bug: please report it", args.out.display());
            return Ok(exit::UNEXPECTED);
        }
        say!("checked in rationals: it does not cross itself");
    }
    Ok(exit::OK)
}

/// Prints what was done.
fn told(given: &Closed, mesh: &Closed, counts: &Counts, args: &Args) {
    say!("{}: {} triangles", args.mesh.display(), given.triangles.len());
    say!(
        "{} pairs crossed; {} triangles cut, {} points constructed, {} faces inside dropped, in {} passes",
        counts.pairs,
        counts.cut,
        counts.constructed,
        counts.dropped,
        counts.passes
    );
    say!("each coordinate moved by at most {:e}", counts.farthest);
    say!("{}: {} triangles, {} points", args.out.display(), mesh.triangles.len(), mesh.points.len());
}

/// The mesh of a file, without points that no triangle uses.
fn read(args: &Args) -> Result<Closed, Failure> {
    let name = args.mesh.display().to_string();
    let file = |message: String, cure: &str| Failure::from(CorpusError::file(name.clone(), message, cure));
    let decimals = Decimals::new(args.round);
    let read = read_bytes(&args.mesh).and_then(|bytes| mesh::read(&name, bytes, &decimals)).map_err(|error| {
        let round = error.cure.contains("round = true");
        let cure = if round { "add --round to read the nearest doubles".to_owned() } else { error.cure.clone() };
        Failure::from(CorpusError { cure, ..error })
    })?;
    let mut places: BTreeMap<Vertex, u32> = read.triangles.as_flattened().iter().map(|&v| (v, 0)).collect();
    let mut points = Vec::with_capacity(places.len());
    for ((&v, place), at) in places.iter_mut().zip(0..) {
        *place = at;
        points.push(read.points[v.index()]);
    }
    let triangles = read.triangles.iter().map(|triangle| triangle.map(|v| places[&v])).collect();
    let closed = Closed { points, triangles };
    if closed.triangles.is_empty() {
        return Err(file("a mesh without triangles".to_owned(), "name a file with faces"));
    }
    let own: Vec<Vertex> = places.into_keys().collect();
    closed.check().map_err(|why| {
        let message = match why {
            MaterialError::Open { edge, triangles, .. } => {
                let [a, b] = edge.map(|v| read.places.point_name(own[v.index()].index()));
                format!("the mesh is open at the edge of points {a} and {b}, which has {triangles} triangle(s)")
            }
            why => why.to_string(),
        };
        file(message, "close the mesh: an open mesh has no inside")
    })?;
    Ok(closed)
}

fn unresolved(why: &Unresolved, file: &Path) -> String {
    format!("{}: {why}", file.display())
}

/// The format of a file, by its name.
fn format(file: &Path) -> Result<MeshFormat, Failure> {
    let formats = [MeshFormat::Off, MeshFormat::Obj, MeshFormat::PlyBinary, MeshFormat::StlAscii];
    let name = file.to_string_lossy().to_lowercase();
    let named = formats.into_iter().find(|format| name.ends_with(format.extension()));
    named.ok_or_else(|| {
        Failure::usage(format!(
            "{}: this is not a format for meshes; name a .off, .obj, .ply or .stl file",
            file.display()
        ))
    })
}

fn write(file: &Path, format: MeshFormat, mesh: &Closed) -> Result<(), Failure> {
    let failed = |why: &dyn std::fmt::Display| Failure::usage(format!("{}: {why}", file.display()));
    let faces: IndexedFaces = mesh.triangles.iter().copied().collect();
    let mut bytes = BufWriter::new(Vec::new());
    write_mesh(&mut bytes, format, &mesh.points, &faces).map_err(|why| failed(&why))?;
    let bytes = bytes.into_inner().map_err(|why| failed(&why))?;
    replace(file, &bytes).map_err(|why| failed(&why))
}
