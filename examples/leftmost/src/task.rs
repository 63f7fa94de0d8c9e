//! The task: the vertices with the smallest x, by the comparisons of any backend.

use predicament::corpus::LoadedScene;
use predicament::predicates::{Axis, PredicateKind, Predicates, Query, Scene, Sign, Vertex};
use predicament::records::{self, RunDir, TableSpec};
use predicament::report::Section;
use predicament::tasks::output::{self, Files};
use predicament::tasks::{
    Answer, Asked, Case, Check, Class, Contestant, ExplainError, Explanation, Halt, How, Outcome, Spoiled, Stop, Task,
    Watch, digest,
};

use crate::{Among, LeftmostRow, judge, section};

/// The number of vertices between two checks of the watch.
const CHUNK: usize = 4096;

/// The task.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Leftmost;

/// The vertices that a backend finds no other left of, ascending.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Found(pub Vec<Vertex>);

impl Answer for Found {
    fn digest(&self) -> u64 {
        digest(self.0.iter().flat_map(|vertex| vertex.index().to_le_bytes()))
    }
}

impl Task for Leftmost {
    type Content = Among;
    type Truth = Vec<Vertex>;
    type Answer = Found;

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Compare]
    }

    fn looks_at_watch(&self) -> bool {
        true
    }

    fn truth(&self, scene: &Scene, content: &Among, watch: &Watch) -> Result<Vec<Vertex>, Stop> {
        judge::truth(scene, content, watch)
    }

    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Among,
        how: &How<'_>,
        answer: &mut Found,
    ) -> Result<(), Halt> {
        let found = &mut answer.0;
        found.clear();
        for chunk in content.0.chunks(CHUNK) {
            for &vertex in chunk {
                match found.first().map_or(Sign::Negative, |&best| session.compare(Axis::X, vertex, best)) {
                    Sign::Negative => {
                        found.clear();
                        found.push(vertex);
                    }
                    Sign::Zero => found.push(vertex),
                    Sign::Positive => {}
                }
            }
            how.watch.done(chunk.len() as u64)?;
        }
        Ok(())
    }

    fn judge(
        &self,
        case: &Case<'_, Leftmost>,
        asked: &Asked<'_>,
        answer: &Found,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        judge::judge(case, asked, &answer.0, outcome);
        Ok(())
    }

    fn describe(&self, _: &LoadedScene, content: &Among, _: &Watch) -> Result<String, Stop> {
        Ok(format!("{} vertices to choose from\n", content.0.len()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Among,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let vertex = query.vertices().next().ok_or_else(|| ExplainError::not_of_task(query, "names no vertex"))?;
        let says = |leftmost: &[Vertex]| judge::says(leftmost.contains(&vertex)).to_owned();
        let truth = judge::exactly(scene, content);
        let about = Explanation {
            vertices: vec![vertex],
            truth: vec![format!("exactly: {}", says(&truth))],
            ..Explanation::default()
        };
        Ok(about.with_answers(backends, |backend| backend.answer(self, scene, content).map(|found| says(&found.0))))
    }

    fn write(&self, scene: &Scene, _: &Among, answer: &Found, files: &mut Files) -> Result<(), output::Error> {
        files.write("leftmost.csv", |out| {
            writeln!(out, "vertex,x")?;
            answer.0.iter().try_for_each(|&v| writeln!(out, "{v},{:e}", scene.coordinate(Axis::X, v)))
        })
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::new(Class::MissedZero, "smallest x", "each leftmost vertex is found"),
                Check::new(Class::Overreach, "smallest x", "a vertex that is found is leftmost"),
                Check::new(Class::SignFlip, "smallest x", "one of the leftmost vertices is found"),
                Check::new(Class::Inconsistent, "smallest x", "where ties are broken one vertex is found"),
            ]
        }
    }

    fn spoiled(&self) -> Vec<Spoiled<Leftmost>> {
        vec![Spoiled::new(
            "leftmost-first-only",
            "of several leftmost vertices only the first is found",
            "exact",
            &[(Class::MissedZero, "smallest x")],
            |_, _, answer: &mut Found| answer.0.truncate(1),
        )]
    }

    fn tables(&self) -> Vec<TableSpec> {
        vec![TableSpec::of::<LeftmostRow>()]
    }

    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, records::Error> {
        section::section(runs)
    }
}
