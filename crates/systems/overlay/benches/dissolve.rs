//! Benchmark: the counties of the United States dissolved into states, on one thread; 3,231 regions in 56 groups.
//!
//! The feature `peers` adds `i_overlay` and `geo`: they run on the same coordinates in the same run, in turns. The aim:
//! faster than GEOS, with areas that add up exactly, which the suite `map-dissolves` checks.
//!
//! Programs of other libraries take part if `DISSOLVE_PROGRAMS` names them: `name=command`, separated by semicolons,
//! words of a command separated by blanks. They read one WKT polygon per line, with an empty line after each group.
//! They print the seconds that it took, the number of corners of the result, and the number of groups for which they
//! have no union; `dissolve.py` beside this file is such a program for GEOS.
//!
//! Our algorithm gets rings of coordinates or, as from a file of arcs, of vertices; its time includes preparing the
//! sessions. `predicament corpus fetch us-counties` fetches the map.

use std::collections::{BTreeSet, HashMap};
use std::fmt::Write as _;
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use predicament_exact::Exact;
use predicament_formats::{Cache, Decimals, ImportedMap, Manifest, text_of, topojson};
use predicament_overlay::algorithm::overlay::{Method, Operation, Polygon, Rule, overlay};
use predicament_predicates::{Backend, Off, Scene, Vertex};
use predicament_sos::Sos;

const ROUNDS: usize = 15;

/// The counties of a state.
struct State {
    points: Vec<[f64; 2]>,
    /// All rings, as vertices.
    loops: Vec<Vec<Vertex>>,
    /// The counties' polygons, as coordinates: an outer ring, then its holes.
    polygons: Vec<Vec<Vec<[f64; 2]>>>,
}

impl State {
    fn new(map: ImportedMap) -> State {
        let rings = map.map.regions().iter().flat_map(|region| &region.rings);
        let loops: Vec<Vec<Vertex>> = rings.map(|ring| ring.vertices().to_vec()).collect();
        let mut polygons: Vec<Vec<Vec<[f64; 2]>>> = Vec::new();
        for one in &loops {
            let ring: Vec<[f64; 2]> = one.iter().map(|v| map.points[v.index()]).collect();
            // In this file outer rings are clockwise, and holes follow the outer ring that they are in.
            match polygons.last_mut() {
                Some(last) if twice_area(&ring) > 0.0 => last.push(ring),
                _ => polygons.push(vec![ring]),
            }
        }
        State { points: map.points, loops, polygons }
    }

    /// The number of corners of the union of the counties.
    fn dissolved<B: Backend>(&self, backend: &B, method: Method) -> usize {
        dissolved(backend, &self.points, &self.loops, method)
    }

    /// The number of corners of the union, computed from coordinates.
    fn dissolved_from_coordinates<B: Backend>(&self, backend: &B, method: Method) -> usize {
        let rings = || self.polygons.iter().flatten();
        let most = rings().map(Vec::len).sum();
        let mut welded: HashMap<[u64; 2], Vertex> = HashMap::with_capacity(most);
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(most);
        let mut vertex = |point: &[f64; 2]| {
            *welded.entry(point.map(f64::to_bits)).or_insert_with(|| {
                points.push(*point);
                Vertex::input(points.len() - 1)
            })
        };
        let loops: Vec<Vec<Vertex>> = rings().map(|ring| ring.iter().map(&mut vertex).collect()).collect();
        dissolved(backend, &points, &loops, method)
    }
}

fn dissolved<B: Backend>(backend: &B, points: &[[f64; 2]], loops: &[Vec<Vertex>], method: Method) -> usize {
    let scene = Scene::from_points2(points).expect("finite");
    let mut session = backend.prepare(&scene, Off).expect("points");
    let counties = Polygon::of_vertices(loops, Rule::NonZero);
    let made = overlay(&mut session, [&counties, &Polygon::default()], method).expect("nothing crosses");
    let regions = made.regions(Operation::Union).regions;
    regions.iter().flat_map(|region| region.loops()).map(Vec::len).sum()
}

fn twice_area(ring: &[[f64; 2]]) -> f64 {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

fn states() -> Vec<State> {
    let manifest = Manifest::parse("fetch.toml", include_str!("../../../../corpora/fetch.toml")).expect("a manifest");
    let entry = manifest.entry("us-counties").expect("an entry");
    let bytes = Cache::default_dir().and_then(|cache| cache.bytes(entry)).expect("run `predicament corpus fetch`");
    let text = text_of("counties", bytes).expect("a text");
    let decimals = Decimals::new(false);
    let mut ids: BTreeSet<String> = BTreeSet::new();
    let mut note = |_: usize, id: Option<&str>| {
        ids.extend(id.and_then(|id| id.get(..2)).map(str::to_owned));
        false
    };
    topojson::read_some("counties", &text, "counties", &decimals, &mut note).expect("a map");
    let state = |begin: &String| {
        let mut of_state = |_: usize, id: Option<&str>| id.is_some_and(|id| id.starts_with(begin.as_str()));
        topojson::read_some("counties", &text, "counties", &decimals, &mut of_state).expect("a map")
    };
    ids.iter().map(|begin| State::new(state(begin))).collect()
}

/// The result of one program or method.
#[derive(Clone, Copy, Default)]
struct Made {
    /// The number of corners of all results.
    corners: usize,
    /// The number of states without a result.
    missing: usize,
    /// The time by the program's own clock, if it has one.
    own: Option<Duration>,
}

/// A program or method with its name.
type Way<'a> = (String, Box<dyn Fn() -> Made + 'a>);

fn way<'a>(name: &str, states: &'a [State], one: impl Fn(&'a State) -> usize + 'a) -> Way<'a> {
    (name.to_owned(), Box::new(move || Made { corners: states.iter().map(&one).sum(), ..Made::default() }))
}

#[cfg(feature = "peers")]
fn peers<'a>(states: &'a [State], areas: &'a [Vec<geo::Polygon>]) -> Vec<Way<'a>> {
    use geo::CoordsIter;
    use i_overlay::core::fill_rule::FillRule;
    use i_overlay::core::overlay_rule::OverlayRule;
    use i_overlay::float::single::SingleFloatOverlay;

    let of_i_overlay = move |state: &State| {
        let rings: Vec<Vec<[f64; 2]>> = state.polygons.iter().flatten().cloned().collect();
        let no_clip: Vec<Vec<[f64; 2]>> = Vec::new();
        let made = rings.overlay(&no_clip, OverlayRule::Subject, FillRule::NonZero);
        made.iter().flatten().map(Vec::len).sum()
    };
    let of_geo = move || {
        let corners = |areas: &Vec<geo::Polygon>| {
            let made = geo::unary_union(areas);
            let rings: usize = made.iter().map(|polygon| 1 + polygon.interiors().len()).sum();
            made.coords_count() - rings
        };
        Made { corners: areas.iter().map(corners).sum(), ..Made::default() }
    };
    vec![way("i_overlay", states, of_i_overlay), ("geo".to_owned(), Box::new(of_geo))]
}

#[cfg(feature = "peers")]
fn areas(states: &[State]) -> Vec<Vec<geo::Polygon>> {
    use geo::{Coord, LineString};
    let line = |ring: &Vec<[f64; 2]>| LineString::new(ring.iter().map(|&[x, y]| Coord { x, y }).collect());
    let area = |rings: &Vec<Vec<[f64; 2]>>| geo::Polygon::new(line(&rings[0]), rings[1..].iter().map(line).collect());
    states.iter().map(|state| state.polygons.iter().map(area).collect()).collect()
}

/// All polygons as WKT text, for other programs.
fn wkt(states: &[State]) -> String {
    let mut text = String::new();
    for state in states {
        for polygon in &state.polygons {
            let ring = |ring: &Vec<[f64; 2]>| {
                let closed = ring.iter().chain(ring.first());
                format!("({})", closed.map(|[x, y]| format!("{x:?} {y:?}")).collect::<Vec<_>>().join(", "))
            };
            let rings: Vec<String> = polygon.iter().map(ring).collect();
            writeln!(text, "POLYGON ({})", rings.join(", ")).expect("strings take everything");
        }
        text.push('\n');
    }
    text
}

/// Runs a program and reads its output.
fn told(command: &str, text: &str) -> Made {
    let mut words = command.split_whitespace();
    let mut program = Command::new(words.next().expect("a program"));
    program.args(words).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = program.spawn().expect("a program");
    std::io::Write::write_all(&mut child.stdin.take().expect("a pipe"), text.as_bytes()).expect("it reads");
    let out = child.wait_with_output().expect("it ends");
    let said = String::from_utf8_lossy(&out.stdout);
    let mut words = said.split_whitespace();
    let seconds: f64 = words.next().and_then(|word| word.parse().ok()).expect("seconds");
    let mut count = |what: &str| words.next().and_then(|word| word.parse().ok()).expect(what);
    let (corners, missing) = (count("a number of corners"), count("a number of groups"));
    Made { corners, missing, own: Some(Duration::from_secs_f64(seconds)) }
}

fn main() {
    // One thread for everything; index structures would use all.
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("no pool before");
    let states = states();
    let sos = Sos::default();
    let programs = std::env::var("DISSOLVE_PROGRAMS").unwrap_or_default();
    let text = wkt(&states);
    #[cfg(feature = "peers")]
    let areas = areas(&states);
    let mut ways = vec![
        way("exact, grid", &states, |state| state.dissolved(&Exact, Method::Grid)),
        way("exact, grid, from coordinates", &states, |state| state.dissolved_from_coordinates(&Exact, Method::Grid)),
        way("exact, sweep", &states, |state| state.dissolved(&Exact, Method::Sweep)),
        way("sos, grid", &states, |state| state.dissolved(&sos, Method::Grid)),
    ];
    #[cfg(feature = "peers")]
    ways.extend(peers(&states, &areas));
    for (name, command) in programs.split(';').filter_map(|named| named.split_once('=')) {
        let text = &text;
        ways.push((name.to_owned(), Box::new(move || told(command, text))));
    }
    let mut times = vec![Vec::new(); ways.len()];
    let mut made = vec![Made::default(); ways.len()];
    for _ in 0..ROUNDS {
        for ((_, way), (times, made)) in ways.iter().zip(times.iter_mut().zip(&mut made)) {
            let start = Instant::now();
            *made = black_box(way());
            times.push(made.own.unwrap_or_else(|| start.elapsed()));
        }
    }
    let counts = states.iter().map(|state| (state.polygons.len(), state.loops.iter().map(Vec::len).sum::<usize>()));
    let (polygons, edges) = counts.fold((0, 0), |sums, of| (sums.0 + of.0, sums.1 + of.1));
    println!("{} states, {polygons} polygons, {edges} edges; {ROUNDS} rounds in turns, medians:", states.len());
    let first = median(&mut times[0]);
    for (((name, _), times), made) in ways.iter().zip(&mut times).zip(&made) {
        let time = median(times);
        let missing =
            if made.missing == 0 { String::new() } else { format!(", {} states without a result", made.missing) };
        println!("  {name:32} {time:10.2} ms   {:6.2} × ours   {} corners{missing}", time / first, made.corners);
    }
}

/// The median of measured times, in milliseconds.
fn median(times: &mut [Duration]) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64() * 1e3
}
