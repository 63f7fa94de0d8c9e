//! Drawings of sign scenes: the points, and the queries about them.

use predicament_predicates::{PredicateKind, QuerySet, Scene, Vertex};
use predicament_report::drawing::Role;

use crate::output::Canvas;

/// The maximum number of queries drawn; the lines of more would cover each other.
const MOST_QUERIES: usize = 50;
/// The maximum number of points with names.
const MOST_NAMES: usize = 50;

/// Draws the points, with queried points in a different colour, and the figures of the first queries: the line, the
/// triangle or the tetrahedron of all vertices except the last.
pub(super) fn draw(scene: &Scene, queries: &QuerySet, canvas: &mut Canvas) -> std::io::Result<()> {
    let few = 0..queries.len().min(MOST_QUERIES);
    let bases: Vec<&[Vertex]> = few.map(|query| queries.args(query)).map(|args| &args[..args.len() - 1]).collect();
    match queries.kind() {
        PredicateKind::Compare | PredicateKind::Derived(_) => {}
        PredicateKind::Orient2d => {
            canvas.lines(scene, "lines", Role::Faint, &bases)?;
        }
        PredicateKind::Orient3d | PredicateKind::Incircle => {
            canvas.faces(scene, "triangles", Role::Faint, &bases)?;
        }
        PredicateKind::Insphere => {
            let faces = |base: &&[Vertex]| {
                (0..4).map(|left: usize| [0, 1, 2].map(|at| base[(left + 1 + at) % 4])).collect::<Vec<_>>()
            };
            canvas.faces(scene, "tetrahedra", Role::Faint, bases.iter().flat_map(faces))?;
        }
    }
    let constructed = (0..scene.constructions().len()).map(Vertex::constructed);
    // Three planes that should meet may have no point in common.
    let constructed: Vec<Vertex> = constructed.filter(|&v| predicament_judge::point(scene, v).is_some()).collect();
    for (name, role, vertices) in
        [("points", Role::Given, scene.vertices().collect()), ("constructed", Role::Mark, constructed)]
    {
        let is_few = vertices.len() <= MOST_NAMES;
        let names: Vec<String> = vertices.iter().filter(|_| is_few).map(ToString::to_string).collect();
        canvas.points(scene, name, role, vertices)?.label(names);
    }
    Ok(())
}
