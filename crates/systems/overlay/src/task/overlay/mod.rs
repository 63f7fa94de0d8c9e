//! The task `overlay2d`: the arrangement of segments, and the Boolean operations on two polygons.
//!
//! All intersections are found and constructed; the inside of each operand propagates from face to face. Wrong signs
//! miss crossings and put vertices in the wrong order; then faces do not close, and areas do not add up.

mod checks;
mod content;
mod generate;
mod judge;
mod replies;
mod shapes;
mod spoiled;

use crate::algorithm::overlay::{
    Contradiction, Edge, Method, Operation, Overlay, Polygon, Regions, arrange, combine, operate, overlay,
};
use predicament_corpus::{Context, Family, InDecimals, LoadedScene, SceneFormat, Source};
use predicament_crossings::task::memory::{Bytes, estimate};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{PredicateKind, Predicates, Query, Refused, Scene, Vertex};
use predicament_report::drawing::Role;
use serde::Serialize;

pub use content::{Layered, Layers};

pub use checks::RULES;
use predicament_tasks::output::{Canvas, Each, Files};
use predicament_tasks::replies::Replies;
use predicament_tasks::{
    Agreement, Answer, Asked, Case, Check, Compared, Contestant, ExplainError, Explanation, Halt, How, Knob, Outcome,
    Purpose, Spoiled, Stop, Task, Turns, Watch, digest, output,
};

/// The task `overlay2d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Overlay2d;

/// An arrangement and, for polygons, the results.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Overlaid {
    /// The arrangement with winding numbers; for segments, the arrangement alone.
    pub overlay: Overlay,
    /// The results in the order of [`Operation::ALL`]; empty for segments.
    pub regions: [Regions; 4],
    /// The scene with the constructed vertices.
    pub scene: Option<Scene>,
    /// The session's rounded position of each node's vertex; `None` if it rounds nothing.
    pub rounded: Option<Vec<[f64; 2]>>,
    /// Results by a shortcut that leaves out what meets nothing; empty unless they are judged. First all operations of
    /// the operands, then all of their union and the second operand, then all of the union and the third polygon.
    pub shortcuts: Vec<Shortcut>,
    /// The polygon that is combined with the union.
    pub third: Polygon,
}

/// A result by a shortcut, and the same result by a whole overlay.
#[derive(Clone, PartialEq, Debug)]
pub struct Shortcut {
    /// The function and the operation.
    pub name: &'static str,
    /// The result by the shortcut.
    pub short: Regions,
    /// The result by a whole overlay.
    pub whole: Regions,
}

/// The third polygon; the operations by [`operate`], and those of the union with the second operand and with the third
/// polygon by [`combine`].
fn shortcuts(
    session: &mut dyn Predicates,
    [a, b]: [&Polygon; 2],
    regions: &[Regions; 4],
    method: Method,
) -> Result<(Polygon, Vec<Shortcut>), Refused> {
    let union = &regions[0].regions;
    let mut all = Vec::new();
    for (operation, whole) in Operation::ALL.into_iter().zip(regions) {
        let short = operate(session, [a, b], operation, method)?;
        all.push(Shortcut { name: operation.name(), short, whole: whole.clone() });
    }
    let with_triangle = with_triangle(session.scene(), b);
    let mut whole = |third: Polygon| {
        let whole = overlay(session, [&Polygon::from(union.as_slice()), &third], method)?;
        Ok((third, whole))
    };
    let second = whole(b.clone())?;
    // A session may refuse to construct points of other edges than those of the scene.
    let last = whole(with_triangle).unwrap_or_else(|_: Refused| second.clone());
    for (third, wholes) in [&second, &last] {
        for operation in Operation::ALL {
            let short = combine(session, union, third, operation, method)?;
            all.push(Shortcut { name: operation.name(), short, whole: wholes.regions(operation) });
        }
    }
    Ok((last.0, all))
}

/// The second operand and a triangle of input vertices. Where an edge of the scene is not in a result, an edge of the
/// triangle may meet the result.
fn with_triangle(scene: &Scene, second: &Polygon) -> Polygon {
    let corners = [0, 1, 2].map(|part| Vertex::input(part * scene.len() / 3)).to_vec();
    let triangle = Polygon::of_vertices(&[corners], second.rule);
    Polygon { loops: [&second.loops[..], &triangle.loops].concat(), rule: second.rule }
}

impl Overlaid {
    /// Overlays a scene.
    ///
    /// # Errors
    /// [`Refused`] if the session does not construct a crossing.
    fn of(session: &mut dyn Predicates, content: &Layered, purpose: Purpose) -> Result<Overlaid, Refused> {
        let (overlay, regions, (third, shortcuts)) = match content.operands() {
            None => {
                let mut overlay = Overlay::default();
                overlay.arrangement = arrange(session, &content.edges(), content.method)?;
                (overlay, <[Regions; 4]>::default(), Default::default())
            }
            Some([a, b]) => {
                let overlay = overlay(session, [&a, &b], content.method)?;
                let regions = Operation::ALL.map(|operation| overlay.regions(operation));
                let is_judged = purpose == Purpose::Judge;
                let shortcuts =
                    is_judged.then(|| shortcuts(session, [&a, &b], &regions, content.method)).transpose()?;
                (overlay, regions, shortcuts.unwrap_or_default())
            }
        };
        let rounded = |v: Vertex| session.rounded_point(v).and_then(|point| <[f64; 2]>::try_from(point).ok());
        let vertices = &overlay.arrangement.vertices;
        let rounds = vertices.iter().any(|&v| v.is_constructed() && rounded(v).is_some());
        let rounded = rounds.then(|| vertices.iter().map(|&v| rounded(v).unwrap_or_default()).collect());
        Ok(Overlaid { overlay, regions, scene: Some(session.scene().clone()), rounded, shortcuts, third })
    }

    /// A name of a vertex that does not depend on other constructions.
    fn name(&self, v: Vertex) -> [u64; 4] {
        use predicament_predicates::Construction::Ssi;
        let id = |v: Vertex| v.index() as u64;
        match self.scene.as_ref().and_then(|scene| scene.construction(v)) {
            Some(Ssi([[a, b], [c, d]])) => [id(*a), id(*b), id(*c), id(*d)],
            _ => [id(v), u64::MAX, u64::MAX, u64::MAX],
        }
    }
}

/// Digests definitions, not the order of construction: both methods give the same digest.
impl Answer for Overlaid {
    fn digest(&self) -> u64 {
        let arrangement = &self.overlay.arrangement;
        let nodes = arrangement.vertices.iter().flat_map(|&v| self.name(v));
        let pieces = arrangement.pieces.iter().flat_map(|piece| piece.ends.map(u64::from));
        let loops = self.regions.iter().flat_map(|made| {
            made.regions.iter().flat_map(|region| {
                region
                    .loops()
                    .flat_map(|one| one.iter().flat_map(|edge| self.name(edge.from)).chain([one.len() as u64]))
            })
        });
        digest(nodes.chain(pieces).chain(loops).flat_map(u64::to_le_bytes))
    }
}

impl SceneFormat for Overlay2d {
    fn name(&self) -> &'static str {
        "overlay2d"
    }

    fn template(&self) -> String {
        include_str!("template.txt").to_owned()
    }

    fn about(&self) -> &'static str {
        "the arrangement of segments; union, intersection and differences of polygons"
    }

    fn in_decimals(&self) -> InDecimals {
        InDecimals::Integers
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "segments", "first", "second", "rule", "method"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "polygons"]
    }

    fn file_keys(&self) -> &'static [&'static str] {
        &["first", "second"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        content::read(context, fields)
    }

    fn families(&self) -> &'static [Family] {
        &generate::FAMILIES
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["method"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["method"]
    }
}

/// The file of an arrangement.
#[derive(Serialize)]
struct Arranged<'a, E> {
    broken: Option<&'static str>,
    edges: E,
    faces: usize,
    windings: &'a [[i32; 2]],
}

impl Task for Overlay2d {
    type Content = Layered;
    type Truth = ();
    type Answer = Overlaid;

    fn compared(&self) -> &'static [Compared] {
        const {
            &[
                Compared::general("overlay-stars", 24),
                Compared::near("overlay-shifted", 24),
                Compared::degenerate("overlay-squares", 16),
            ]
        }
    }

    fn replies(&self) -> Option<&'static dyn Replies<Overlay2d>> {
        Some(&replies::Judge)
    }

    fn turns(&self, _: Knob) -> Turns {
        Turns::Everywhere
    }

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare, PredicateKind::Orient2d]
    }

    fn memory(&self, scene: &Scene, content: &Layered) -> Option<u64> {
        Some(estimate(scene, &content.segments(), Bytes { segment: 1_500, crossing: 1_500 }))
    }

    fn scaled(&self) -> Option<Compared> {
        Some(Compared::general("overlay-segments", 1))
    }

    fn constructs(&self) -> bool {
        true
    }

    fn judges_whole(&self) -> bool {
        true
    }

    /// The task has no separate truth: the laws and the operands suffice.
    fn truth(&self, _: &Scene, _: &Layered, watch: &Watch) -> Result<(), Stop> {
        watch.done(0)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Layered,
        how: &How<'_>,
        answer: &mut Overlaid,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        *answer = Overlaid::of(session, content, how.purpose)?;
        how.watch.done(content.size() as u64)?;
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Overlay2d>,
        asked: &Asked<'_>,
        answer: &Overlaid,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        outcome.sampled = judge::sampled(case.content);
        judge::judge(case, asked, answer, outcome)
    }

    /// The arrangement over the written points: constructed vertices keep their definitions, and no vertex is rounded.
    /// Shortcuts are judged with the doubles, which they look at.
    fn agreement(
        &self,
        _: &Case<'_, Overlay2d>,
        written: &Case<'_, Overlay2d>,
        asked: &Asked<'_>,
        answer: &Overlaid,
        own: &Outcome,
    ) -> Result<Agreement, Stop> {
        let mut scene = written.scene().clone();
        for definition in answer.scene.iter().flat_map(Scene::constructions) {
            // A definition without a point is a violation, which the judge finds.
            let _ = scene.construct(*definition);
        }
        let over = Overlaid { scene: Some(scene), rounded: None, shortcuts: Vec::new(), ..answer.clone() };
        let mut outcome = Outcome::default();
        judge::judge(written, asked, &over, &mut outcome)?;
        Ok(Agreement::of_wholes(own, &outcome))
    }

    fn checks(&self) -> &'static [Check] {
        checks::CHECKS
    }

    fn spoiled(&self) -> Vec<Spoiled<Overlay2d>> {
        spoiled::all()
    }

    fn describe(&self, _: &LoadedScene, content: &Layered, _: &Watch) -> Result<String, Stop> {
        Ok(match &content.layers {
            Layers::Segments(segments) => format!("{} segments\n", segments.len()),
            Layers::Polygons(operands, _) => {
                let [a, b] = operands.each_ref().map(|loops| (loops.len(), loops.iter().map(Vec::len).sum::<usize>()));
                format!("{} loops of {} corners, and {} of {}\n", a.0, a.1, b.0, b.1)
            }
        })
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Layered,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let _ = query;
        let ask = |backend: &dyn Contestant| backend.answer(self, scene, content).map(|found| told(&found));
        Ok(Explanation::default().with_answers(backends, ask))
    }

    /// Offers each result as a picture and GeoJSON, the arrangement as JSON, and all vertices exactly.
    fn write(
        &self,
        scene: &Scene,
        content: &Layered,
        answer: &Overlaid,
        files: &mut Files,
    ) -> Result<(), output::Error> {
        let arrangement = &answer.overlay.arrangement;
        files.broken(arrangement.broken);
        let (shown, at) = shown(scene, answer)?;
        if content.operands().is_some() {
            let ring = |one: &Vec<Edge>| one.iter().map(|edge| at(edge.from)).collect::<Vec<_>>();
            for (operation, made) in Operation::ALL.into_iter().zip(&answer.regions) {
                let polygons = made.regions.iter().map(|region| region.loops().map(ring).collect());
                output::plane(files, &shown, operation.name(), polygons)?;
            }
        }
        files.json("arrangement.json", || {
            let subdivision = &arrangement.subdivision;
            let edge = move |(at, piece): (u32, &crate::algorithm::overlay::Piece)| {
                let vertices = piece.ends.map(|node| arrangement.vertices[node as usize].to_string());
                let faces = [2 * at, 2 * at + 1].map(|half| subdivision.face(half));
                serde_json::json!({ "vertices": vertices, "left": faces[0], "right": faces[1] })
            };
            Arranged {
                broken: arrangement.broken.map(Contradiction::rule),
                edges: Each(move || (0..).zip(&arrangement.pieces).map(edge)),
                faces: subdivision.faces(),
                windings: &answer.overlay.windings,
            }
        })?;
        output::vertices(files, &shown, arrangement.vertices.iter().map(|&v| at(v)))
    }

    fn draw(
        &self,
        scene: &Scene,
        content: &Layered,
        answer: Option<&Overlaid>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        match &content.layers {
            Layers::Segments(segments) => {
                canvas.lines(scene, "segments", Role::Given, segments)?;
            }
            Layers::Polygons(operands, _) => {
                for (name, role, loops) in
                    [("first", Role::Given, &operands[0]), ("second", Role::Second, &operands[1])]
                {
                    canvas.areas(scene, name, role, [loops.clone()])?;
                }
            }
        }
        let Some(answer) = answer else { return Ok(()) };
        let (shown, at) = shown(scene, answer)?;
        if content.operands().is_some() {
            let ring = |one: &Vec<Edge>| one.iter().map(|edge| at(edge.from)).collect::<Vec<_>>();
            for (operation, made) in Operation::ALL.into_iter().zip(&answer.regions) {
                let areas = made.regions.iter().map(|region| region.loops().map(ring).collect());
                let layer = canvas.areas(&shown, operation.name(), Role::Found, areas)?;
                layer.is_shown = operation == Operation::Intersection;
            }
        }
        let nodes = answer.overlay.arrangement.vertices.iter().map(|&v| at(v));
        canvas.points(&shown, "vertices of the arrangement", Role::Mark, nodes)?;
        Ok(())
    }
}

/// The scene in which an answer is shown, and its vertices there: a session that rounds has its own points.
fn shown<'a>(scene: &Scene, answer: &'a Overlaid) -> std::io::Result<(Scene, impl Fn(Vertex) -> Vertex + use<'a>)> {
    let vertices = &answer.overlay.arrangement.vertices;
    let exact = answer.scene.clone().unwrap_or_else(|| scene.clone());
    let inputs = scene.len();
    let shown = match &answer.rounded {
        None => exact,
        Some(rounded) => {
            let coordinates = [scene.coordinates(), rounded.as_flattened()].concat();
            Scene::new(scene.dimension(), coordinates).map_err(std::io::Error::other)?
        }
    };
    let place = move |v: Vertex| {
        let is_rounded = answer.rounded.is_some() && v.is_constructed();
        let at = is_rounded.then(|| vertices.iter().position(|&other| other == v)).flatten();
        at.map_or(v, |at| Vertex::input(inputs + at))
    };
    Ok((shown, place))
}

fn told(found: &Overlaid) -> String {
    let arrangement = &found.overlay.arrangement;
    let [nodes, edges, faces] = [arrangement.vertices.len(), arrangement.pieces.len(), arrangement.subdivision.faces()];
    let regions: Vec<String> = Operation::ALL
        .into_iter()
        .zip(&found.regions)
        .filter(|(_, made)| !made.regions.is_empty())
        .map(|(operation, made)| format!("{} {}", operation.name(), made.regions.len()))
        .collect();
    let regions = if regions.is_empty() { String::new() } else { format!("; regions: {}", regions.join(", ")) };
    let broken = arrangement.broken.map_or(String::new(), |broken| format!("; broken: {broken}"));
    format!("{nodes} nodes, {edges} edges, {faces} faces{regions}{broken}")
}
