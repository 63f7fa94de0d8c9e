//! The contestants of the race: backends in this process, and programs of other libraries.

use std::collections::HashMap;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use predicament_exact::Exact;
use predicament_mesh::MaterialMesh;
use predicament_mesh_intersect::algorithm::overlay::{Zeros, mesh_overlay};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Off, Predicates, Vertex};
use predicament_sos::PerMesh;

use crate::closed::{self, Closed, index, place};

/// The outcome of a union.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Outcome {
    Right,
    #[default]
    Refused,
    Crashed,
    TimedOut,
    /// A result that is not closed.
    Open,
    /// A result with another volume than most others.
    Volume,
}

/// The union of a pair by one contestant.
#[derive(Clone, Default)]
pub struct Made {
    pub seconds: f64,
    pub triangles: usize,
    pub volume: f64,
    pub outcome: Outcome,
    pub why: String,
}

impl Made {
    fn failed(outcome: Outcome, why: impl Into<String>) -> Made {
        Made { outcome, why: why.into(), ..Made::default() }
    }

    fn of(seconds: f64, union: &Closed) -> Made {
        let outcome = if is_closed(union) { Outcome::Right } else { Outcome::Open };
        Made { seconds, triangles: union.triangles.len(), volume: union.volume(), outcome, why: String::new() }
    }
}

/// True if sides of triangles cancel, with corners compared by position.
fn is_closed(mesh: &Closed) -> bool {
    let mut places: HashMap<[u64; 3], u32> = HashMap::with_capacity(mesh.points.len());
    let mut stands: Vec<u32> = Vec::with_capacity(mesh.points.len());
    for point in &mesh.points {
        let next = index(places.len());
        stands.push(*places.entry(point.map(|x| (x + 0.0).to_bits())).or_insert(next));
    }
    let corners = mesh.triangles.iter().map(|triangle| triangle.map(|at| stands[at as usize]));
    let sides = corners.flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]).filter(|[a, b]| a != b);
    let mut ends: Vec<([u32; 2], i32)> = sides.map(|[a, b]| if a < b { ([a, b], 1) } else { ([b, a], -1) }).collect();
    ends.sort_unstable();
    ends.chunk_by(|a, b| a.0 == b.0).all(|same| same.iter().map(|(_, sign)| sign).sum::<i32>() == 0)
}

/// Reads a mesh from a file of [`Closed::bytes`].
pub fn mesh(path: &Path) -> Result<Closed, String> {
    let bytes = std::fs::read(path).map_err(|why| format!("{}: {why}", path.display()))?;
    let read = || {
        let (counts, rest) = bytes.split_first_chunk::<16>()?;
        let counts = counts.as_chunks::<8>().0;
        let [points, triangles] = [0, 1].map(|at: usize| usize::try_from(u64::from_le_bytes(counts[at])));
        let (points, corners) = rest.split_at_checked(points.ok()?.checked_mul(24)?)?;
        let coordinates: Vec<f64> = points.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        let ids: Vec<u32> = corners.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
        let made = Closed { points: coordinates.as_chunks().0.to_vec(), triangles: ids.as_chunks().0.to_vec() };
        let are_in = made.triangles.as_flattened().iter().all(|&at| (at as usize) < made.points.len());
        (are_in && Ok(made.triangles.len()) == triangles).then_some(made)
    };
    read().ok_or_else(|| format!("{}: not a file of a mesh", path.display()))
}

/// Files of a pair, and of a program's result.
pub struct Files([PathBuf; 3]);

/// Writes a pair to files in a folder, for programs.
pub fn write(folder: &Path, closed: &[Closed; 2]) -> Result<Files, String> {
    let files = ["first", "second", "result"].map(|name| folder.join(format!("race-{name}.bin")));
    for (file, mesh) in files.iter().zip(closed) {
        std::fs::write(file, mesh.bytes()).map_err(|why| format!("{}: {why}", file.display()))?;
    }
    Ok(Files(files))
}

/// A contestant: a backend of ours, or a program of another library.
pub enum Contestant {
    Ours(&'static str, fn(&[Closed; 2]) -> Made),
    Program(Program),
}

impl Contestant {
    pub fn name(&self) -> &str {
        match self {
            Contestant::Ours(name, _) => name,
            Contestant::Program(program) => &program.name,
        }
    }

    /// The union of a pair: time, number of triangles and volume.
    pub fn unite(&mut self, closed: &[Closed; 2], files: &Files) -> Made {
        match self {
            Contestant::Ours(_, unite) => {
                std::panic::catch_unwind(|| unite(closed)).unwrap_or_else(|_| Made::failed(Outcome::Crashed, "a panic"))
            }
            Contestant::Program(program) => program.unite(files),
        }
    }
}

/// Our backends, and the programs that `MESH_RACE_PROGRAMS` names: `name=command`, separated by semicolons.
pub fn contestants(folder: &Path, cap: Duration) -> Result<Vec<Contestant>, String> {
    let mut all = vec![
        Contestant::Ours("sos:per-mesh", |closed| union(&PerMesh, closed)),
        Contestant::Ours("exact", |closed| union(&Exact, closed)),
    ];
    let programs = std::env::var("MESH_RACE_PROGRAMS").unwrap_or_default();
    for named in programs.split(';').filter(|named| !named.is_empty()) {
        let (name, command) = named.split_once('=').ok_or(format!("`{named}` is not `name=command`"))?;
        let command: Vec<String> = command.split_whitespace().map(str::to_owned).collect();
        let said = folder.join(format!("race-{name}.stderr"));
        let name = name.to_owned();
        all.push(Contestant::Program(Program { name, command, said, cap, running: None }));
    }
    Ok(all)
}

/// The union by a backend, from arrays to arrays.
fn union<B: Backend>(backend: &B, closed: &[Closed; 2]) -> Made {
    let start = Instant::now();
    let (scene, [first, second]) = closed::scene(closed.each_ref());
    let check = |corners| MaterialMesh::of_closed(scene.len(), corners).map(Arc::new);
    let (first, second) = rayon::join(|| check(first), || check(second));
    let meshes = match (first, second) {
        (Ok(first), Ok(second)) => [first, second],
        (Err(why), _) | (_, Err(why)) => return Made::failed(Outcome::Refused, why.to_string()),
    };
    let mut session = backend.prepare(&scene, Off).expect("in space");
    let overlay = match mesh_overlay(&mut session, meshes, Zeros::Zero) {
        Ok(overlay) => overlay,
        Err(why) => return Made::failed(Outcome::Refused, why.to_string()),
    };
    let union = arrays(&session, &overlay.solid(Operation::Union).triangles);
    Made::of(start.elapsed().as_secs_f64(), &union)
}

/// Triangles as arrays, with points in doubles.
fn arrays(session: &impl Predicates, triangles: &[[Vertex; 3]]) -> Closed {
    let scene = session.scene();
    let mut at = vec![u32::MAX; scene.len() + scene.constructions().len()];
    let mut union = Closed::default();
    union.triangles.reserve(triangles.len());
    for &triangle in triangles {
        union.triangles.push(triangle.map(|v| {
            let at = &mut at[v.construction().map_or_else(|| v.index(), |number| scene.len() + number)];
            if *at == u32::MAX {
                *at = index(union.points.len());
                union.points.push(place(scene, v));
            }
            *at
        }));
    }
    union
}

/// A program of another library, which runs from pair to pair.
pub struct Program {
    name: String,
    command: Vec<String>,
    /// The file of its stderr.
    said: PathBuf,
    cap: Duration,
    running: Option<(Child, Receiver<String>)>,
}

impl Program {
    fn start(&self) -> Result<(Child, Receiver<String>), String> {
        let (program, arguments) = self.command.split_first().ok_or("no command")?;
        let said = std::fs::File::create(&self.said).map_err(|why| why.to_string())?;
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(said);
        let mut child = command.spawn().map_err(|why| format!("{program}: {why}"))?;
        let output = child.stdout.take().expect("piped");
        let (send, receive) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if send.send(line).is_err() {
                    return;
                }
            }
        });
        Ok((child, receive))
    }

    fn unite(&mut self, Files([first, second, result]): &Files) -> Made {
        // A result of another program is not read as this one's.
        std::fs::remove_file(result).ok();
        let started = self.running.take().map_or_else(|| self.start(), Ok);
        let (mut child, answers) = match started {
            Ok(running) => running,
            Err(why) => return Made::failed(Outcome::Crashed, why),
        };
        let question = [first, second, result].map(|file| file.display().to_string()).join(" ") + "\n";
        let asked = child.stdin.as_mut().expect("piped").write_all(question.as_bytes());
        let answer = asked.map_err(|_| RecvTimeoutError::Disconnected).and_then(|()| answers.recv_timeout(self.cap));
        let answer = match answer {
            Ok(answer) => answer,
            Err(why) => {
                child.kill().ok();
                let ended = child.wait().map_or_else(|why| why.to_string(), |status| status.to_string());
                return match why {
                    RecvTimeoutError::Timeout => Made::failed(Outcome::TimedOut, ""),
                    RecvTimeoutError::Disconnected => Made::failed(Outcome::Crashed, ended),
                };
            }
        };
        self.running = Some((child, answers));
        let Ok(seconds) = answer.trim().parse() else {
            return Made::failed(Outcome::Refused, answer.trim_start_matches("refused "));
        };
        match mesh(result) {
            Ok(union) => Made::of(seconds, &union),
            Err(why) => Made::failed(Outcome::Crashed, why),
        }
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        if let Some((mut child, _)) = self.running.take() {
            child.kill().ok();
            child.wait().ok();
        }
    }
}
