//! Drawings of one query: the shape that its vertices span, with a letter for each vertex.

use predicament_corpus::LoadedScene;
use predicament_predicates::{Dimension, Query, Question, Scene, Vertex};
use predicament_report::drawing::{Drawing, Look, Role, Shape, Window};
use predicament_tasks::output::Canvas;
use serde_json::Value;

use super::apart::sphere;

/// The 3D drawing of a query in space, or `None` for a query in the plane or with a vertex that is not a point.
pub fn view(loaded: &LoadedScene, query: &Query) -> Option<(String, Value)> {
    let is_space = loaded.scene.dimension() == Dimension::Three;
    is_space.then(|| drawing(loaded, query)).flatten().map(|of| (format!("{query}"), of.json()))
}

/// A picture of a query in the plane, if the query does not ask for a sign.
pub fn picture(loaded: &LoadedScene, query: &Query) -> Option<(String, String)> {
    if loaded.scene.dimension() == Dimension::Three || query.question().is_some() {
        return None;
    }
    drawing(loaded, query).map(|of| (format!("{query}, to scale"), of.svg(Look::default(), Window::Whole)))
}

fn drawing(loaded: &LoadedScene, query: &Query) -> Option<Drawing> {
    let scene = &loaded.scene;
    let all: Vec<Vertex> = query.vertices().collect();
    let mut canvas = Canvas::new(scene, all.first().copied()).ok()?;
    let groups: Vec<&[Vertex]> = match query.question() {
        // The shape of all vertices but the last, which is the query point.
        Some((_, args)) => vec![&args[..args.len() - 1]],
        None => query.args.iter().map(Vec::as_slice).collect(),
    };
    for (group, role) in groups.into_iter().zip([Role::Given, Role::Second]) {
        spanned(scene, group, role, &mut canvas).ok()?;
    }
    if let Some((Question::Insphere, args)) = query.question() {
        round(scene, args, &mut canvas);
    }
    let letters = ('a'..='z').map(String::from);
    let names = all.iter().zip(letters).map(|(v, letter)| format!("{letter} = {v}")).collect::<Vec<_>>();
    canvas.points(scene, "vertices", Role::Mark, all).ok()?.label(names);
    let drawing = canvas.finish();
    let mut places = drawing.layers.iter().flat_map(|layer| layer.parts.iter().flatten().flatten().flatten());
    places.all(|x| x.is_finite()).then_some(drawing)
}

/// A line, a triangle or a tetrahedron.
fn spanned(scene: &Scene, group: &[Vertex], role: Role, canvas: &mut Canvas) -> std::io::Result<()> {
    match *group {
        [a, b] => canvas.lines(scene, "line", role, [[a, b]]).map(|_| ()),
        [a, b, c] => canvas.faces(scene, "triangle", role, [[a, b, c]]).map(|_| ()),
        [a, b, c, d] => {
            let faces = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
            canvas.faces(scene, "tetrahedron", Role::Faint, faces).map(|_| ())
        }
        _ => Ok(()),
    }
}

/// Three great circles of the sphere through the first four vertices.
fn round(scene: &Scene, args: &[Vertex], canvas: &mut Canvas) {
    const STEPS: u32 = 64;
    let [a, b, c, d, _] = *args else { return };
    if args.iter().any(|v| v.is_constructed()) {
        return;
    }
    let points = [a, b, c, d].map(|v| scene.point3(v));
    let Some((from_a, radius)) = sphere(points) else { return };
    let circle = |axis: usize| {
        let at = |step: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / f64::from(STEPS)).sin_cos();
            let mut place = [0, 1, 2].map(|axis: usize| points[0][axis] + from_a[axis]);
            place[(axis + 1) % 3] += radius * cos;
            place[(axis + 2) % 3] += radius * sin;
            place
        };
        vec![(0..=STEPS).map(at).collect()]
    };
    canvas.places("sphere", Role::Faint, Shape::Lines, (0..3).map(circle));
}
