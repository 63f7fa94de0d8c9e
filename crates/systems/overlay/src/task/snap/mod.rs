//! The task `snap2d`: segments rounded to doubles, by snap rounding and by rounding each crossing.
//!
//! The predicates under test find the arrangement; its rounding is exact. So a wrong sign shows as a crossing that is
//! not hot. The effect of rounding itself shows under exact signs, method by method, in `snap.csv`.

mod checks;
mod content;
mod contradiction;
mod judge;
mod replies;
mod section;
mod spoiled;

use crate::algorithm::overlay::{self, Arrangement, Edge, arrange};
use crate::algorithm::snap::{Drawing, Pixel, Snapped, snap};
use crate::truth::Truth;
use predicament_corpus::{Context, Family, LoadedScene, SceneFormat, Source};
use predicament_crossings::task::memory::{Bytes, estimate};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Construction, Plane, PredicateKind, Predicates, Query, Scene, Sign, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::{Role, Shape};
use std::collections::BTreeSet;

pub use content::{Drawn, method_name};
pub use contradiction::Contradiction;
pub use section::SnapRow;

use predicament_tasks::output::{Canvas, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::segment_source::named;
use predicament_tasks::{
    Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome, Spoiled,
    Stop, Task, Turns, Watch, digest, output,
};

/// The task `snap2d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Snap2d;

/// The chains of all segments.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Chains {
    /// The rounded drawing: pixels and chains.
    pub snapped: Snapped,
    /// The first rule that signs break.
    pub broken: Option<Contradiction>,
}

impl Answer for Chains {
    fn digest(&self) -> u64 {
        let pixels = self.snapped.pixels.iter().flatten().map(|i| i.cast_unsigned());
        let of_chain = |chain: &Vec<u32>| chain.iter().map(|&at| u64::from(at)).chain([u64::MAX]).collect::<Vec<_>>();
        let chains = self.snapped.chains.iter().flat_map(of_chain);
        let broken = self.broken.map_or("", Contradiction::rule);
        digest(pixels.chain([u64::MAX]).chain(chains).flat_map(u64::to_le_bytes).chain(broken.bytes()))
    }
}

impl Chains {
    /// The pixels of each chain.
    #[must_use]
    pub fn pixels(&self) -> Vec<Vec<Pixel>> {
        let of = |chain: &Vec<u32>| chain.iter().map(|&at| self.snapped.pixels[at as usize]).collect();
        self.snapped.chains.iter().map(of).collect()
    }
}

/// Coordinates of all input points.
fn points(scene: &Scene) -> Vec<[f64; 2]> {
    scene.vertices().map(|v| [scene.point(v)[0], scene.point(v)[1]]).collect()
}

/// The incidences of an arrangement: pairs of segments that cross, and segments with the points on them. `in_line` is
/// true for two segments on one line.
fn incidences(
    scene: &Scene,
    arrangement: &Arrangement,
    in_line: impl Fn([Vertex; 2], [Vertex; 2]) -> bool,
) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
    let number = |at: usize| u32::try_from(at).expect("fewer than 2^32");
    let place = |ends: [_; 2]| arrangement.segments.binary_search(&ends).ok().map(number);
    let (mut crossings, mut touching) = (Vec::new(), Vec::new());
    for segment in 0..arrangement.segments.len() {
        for v in arrangement.chain(segment).iter().map(|&node| arrangement.vertices[node as usize]) {
            match scene.construction(v) {
                Some(Construction::Ssi(lines)) if v.is_constructed() => {
                    let by = lines.map(|mut ends| {
                        ends.sort_unstable();
                        place(ends)
                    });
                    // One of the two segments that define it: not the segment itself, and not one in line with it, such
                    // as a copy.
                    let others = by.into_iter().flatten().filter(|&other| other != number(segment));
                    let ends = |of: usize| arrangement.segments[of];
                    let other = others.into_iter().find(|&other| !in_line(ends(segment), ends(other as usize)));
                    crossings.extend(other.map(|other| [number(segment).min(other), number(segment).max(other)]));
                }
                _ => touching.push([number(segment), number(v.index())]),
            }
        }
    }
    crossings.sort_unstable();
    crossings.dedup();
    (crossings, touching)
}

/// Computes the arrangement and rounds it.
fn solve(session: &mut dyn Predicates, content: &Drawn) -> Result<Chains, Halt> {
    let edges: Vec<Edge> = content.segments.iter().map(|&[a, b]| Edge::whole(a, b)).collect();
    let arrangement = arrange(session, &edges, overlay::Method::Grid)?;
    if arrangement.segments != content.segments {
        return Ok(Chains { broken: Some(Contradiction::Segments), ..Chains::default() });
    }
    let turn = |[a, b]: [Vertex; 2], c| session.orient2d(Plane::Xy, a, b, c);
    let in_line = |line, [c, d]: [Vertex; 2]| [turn(line, c), turn(line, d)] == [Sign::Zero; 2];
    let (crossings, touching) = incidences(session.scene(), &arrangement, in_line);
    let points = points(session.scene());
    let segments: Vec<[u32; 2]> =
        content.segments.iter().map(|ends| ends.map(|v| u32::try_from(v.index()).expect("fewer than 2^32"))).collect();
    let drawing = Drawing { points: &points, segments: &segments, crossings: &crossings, touching: &touching };
    Ok(match snap(drawing, content.pixel, content.method) {
        Ok(snapped) => Chains { snapped, broken: arrangement.broken.map(Contradiction::from) },
        Err(_) => Chains { broken: Some(Contradiction::NoPoint), ..Chains::default() },
    })
}

impl SceneFormat for Snap2d {
    fn name(&self) -> &'static str {
        "snap2d"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "segments and their crossings rounded to pixels: snap rounding, iterated snap rounding, or each point \
         separately"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "segments", "pixel", "method"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["segments"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &content::FAMILIES
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["pixel", "method"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["method"]
    }
}

impl Task for Snap2d {
    type Content = Drawn;
    type Truth = Truth;
    type Answer = Chains;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("snap-uniform", 30).with("pixel = 8"),
                Compared::near("snap-near", 30).with("pixel = 8"),
                Compared::degenerate("snap-lattice", 30).with("pixel = 4"),
            ]
        }
    }

    fn turns(&self, knob: Knob) -> Turns {
        match knob {
            Knob::Scale => Turns::Nowhere("pixels keep their size"),
            Knob::Translation => Turns::UpTo(40, "centres of pixels are not doubles"),
            _ => Turns::Everywhere,
        }
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d]
    }

    fn memory(&self, scene: &Scene, content: &Drawn) -> Option<u64> {
        Some(estimate(scene, &content.segments, Bytes { segment: 800, crossing: 500 }))
    }

    fn scaled(&self) -> Option<Compared> {
        Some(Compared::general("snap-short", 1).with("pixel = 20"))
    }

    fn constructs(&self) -> bool {
        true
    }

    fn judges_whole(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &Drawn, watch: &Watch) -> Result<Truth, Stop> {
        Truth::new(scene, &content.segments, watch)
    }

    fn sampled(&self, truth: &Truth) -> Option<String> {
        truth.sampled()
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Drawn,
        how: &How<'_>,
        answer: &mut Chains,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        *answer = solve(session, content)?;
        how.watch.done(content.segments.len() as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Snap2d>,
        asked: &Asked<'_>,
        answer: &Chains,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, answer, outcome)
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Snap2d>> {
        spoiled::all()
    }

    fn replies(&self) -> Option<&'static dyn Replies<Snap2d>> {
        Some(&replies::Judge)
    }

    fn describe(&self, loaded: &LoadedScene, content: &Drawn, watch: &Watch) -> Result<String, Stop> {
        let truth = Truth::new(&loaded.scene, &content.segments, watch)?;
        let (segments, crossings) = (content.segments.len(), truth.crossings.len());
        let (method, pixel) = (method_name(content.method), content.pixel);
        Ok(format!("{segments} segments with {crossings} pairs that cross, by method {method}; pixels of 2^{pixel}\n"))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Drawn,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let (at, about) = named(&content.segments, query)?;
        let ask = |backend: &dyn Contestant| {
            backend.answer(self, scene, content).map(|chains| match chains.pixels().get(at) {
                Some(chain) => chain.iter().map(|[x, y]| format!("({x}, {y})")).collect::<Vec<_>>().join(" "),
                None => chains.broken.map_or("no chain".to_owned(), |broken| broken.to_string()),
            })
        };
        Ok(about.with_answers(backends, ask))
    }

    fn write(&self, scene: &Scene, content: &Drawn, answer: &Chains, files: &mut Files) -> Result<(), output::Error> {
        // A line has at least two positions.
        let line = |chain: &Vec<u32>| -> Vec<[f64; 2]> {
            let line: Vec<[f64; 2]> = chain.iter().map(|&at| answer.snapped.centre(at, content.pixel)).collect();
            if line.len() == 1 { line.repeat(2) } else { line }
        };
        let chains = &answer.snapped.chains;
        files.write("chains.geojson", |out| {
            let feature = |(chain, [a, b]): (&Vec<u32>, &[Vertex; 2])| {
                Ok(serde_json::json!({
                    "type": "Feature",
                    "geometry": { "type": "LineString", "coordinates": line(chain) },
                    "properties": { "segment": [a.to_string(), b.to_string()] },
                }))
            };
            output::collection(out, chains.iter().zip(&content.segments).map(feature))
        })?;
        files.by_format("chains.wkt", |out| {
            let place = |[x, y]: &[f64; 2]| format!("{x:?} {y:?}");
            chains.iter().try_for_each(|chain| {
                let places: Vec<String> = line(chain).iter().map(place).collect();
                writeln!(out, "LINESTRING ({})", places.join(", "))
            })
        })?;
        output::vertices(files, scene, content.segments.as_flattened().iter().copied())
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &Drawn,
        answer: Option<&Chains>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        canvas.lines(scene, "segments", Role::Given, &content.segments)?;
        let Some(answer) = answer else { return Ok(()) };
        let centre = |&at: &u32| {
            let [x, y] = answer.snapped.centre(at, content.pixel);
            [x, y, 0.0]
        };
        let chains = answer.snapped.chains.iter().map(|chain| vec![chain.iter().map(centre).collect()]);
        canvas.places("chains", Role::Found, Shape::Lines, chains);
        let half = 2_f64.powi(content.pixel) / 2.0;
        let pixel = |[x, y, _]: [f64; 3]| {
            let corner = |[i, j]: [f64; 2]| [x + i * half, y + j * half, 0.0];
            vec![[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner).to_vec()]
        };
        let hot: BTreeSet<u32> = answer.snapped.chains.iter().flatten().copied().collect();
        canvas.places("hot pixels", Role::Faint, Shape::Areas, hot.iter().map(|at| pixel(centre(at))));
        Ok(())
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<SnapRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        section::section(runs)
    }
}
