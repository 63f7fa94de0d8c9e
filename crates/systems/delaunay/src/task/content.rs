//! The keys `points` and `constraints`: the content of a scene.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Parts, PointSource, Source, Spelled, spelled_points,
};
use predicament_formats::{Cache, CorpusError, Fields};
use predicament_predicates::{Dimension, Scene, Vertex};

/// The content of a scene: all its vertices, and the constraints.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sites {
    /// The number of vertices.
    pub points: usize,
    /// The ends of each constraint.
    pub constraints: Vec<[Vertex; 2]>,
}

impl Content for Sites {
    fn count(&self) -> usize {
        self.points
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("delaunay2d");
        if !self.constraints.is_empty() {
            canon.vertices(self.constraints.as_flattened());
        }
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        Some(Spelled {
            lists: vec![List::new("constraints", Items::tuples(&self.constraints))],
            ..spelled_points(scene)
        })
    }
}

/// Reads `points` and `constraints`.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
    let constraints = match fields.get("constraints") {
        None => Vec::new(),
        Some(listed) => {
            let items = listed.items("constraints: arrays with the indices of two points")?;
            let constraint = items.map(|item| {
                let ends: Vec<Vertex> =
                    item.items("the indices of two points")?.map(|end| end.point()).collect::<Result<_, _>>()?;
                let &[a, b] = ends.as_slice() else {
                    let message = format!("a constraint with {} ends", ends.len());
                    return Err(item.error(message, "write the indices of two points"));
                };
                if a == b {
                    return Err(item.error(format!("both ends are point {a}"), "name two points"));
                }
                Ok((item.line(), [a, b]))
            });
            constraint.collect::<Result<Vec<_>, _>>()?
        }
    };
    let asked = Asked { points, constraints, file: fields.file().to_owned() };
    if asked.points.is_written() {
        // Nothing comes from the cache: everything is written out.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// The source of a scene: points, written out or in a data file beside the suite, and constraints.
struct Asked {
    points: PointSource,
    /// Each constraint with its line in the suite.
    constraints: Vec<(usize, [Vertex; 2])>,
    file: String,
}

impl Elsewhere for Asked {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, notes) = self.points.scene(cache)?;
        if scene.dimension() != Dimension::Two {
            let message = "delaunay2d takes points with 2 coordinates, not 3";
            return Err(self.points.error(message, "give every point 2 coordinates"));
        }
        for (line, ends) in &self.constraints {
            if let Some(end) = ends.iter().find(|end| end.index() >= scene.len()) {
                let message = format!("the end {end} is out of range: the scene has {} points", scene.len());
                return Err(CorpusError::file(&self.file, message, "indices count from 0").at_line(*line));
            }
        }
        let constraints = self.constraints.iter().map(|(_, ends)| *ends).collect();
        let sites = Sites { points: scene.len(), constraints };
        Ok(Parts { notes, ..Parts::new(scene, sites) })
    }
}
