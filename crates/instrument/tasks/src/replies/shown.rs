//! Files and drawings of a program's answer, by the forms of its parts. Lists, labels and numbers are not drawn.

use predicament_predicates::{Scene, Vertex};
use predicament_report::drawing::{Role, Shape};
use serde_json::json;

use super::shape::{Mesh, Rings, scene_of};
use super::{Arrays, Form, Malformed, Part, Replies, Reply};
use crate::Task;
use crate::output::{self, Canvas, Files};

fn parts<T: Task>(judge: Option<&'static dyn Replies<T>>) -> &'static [Part] {
    judge.map_or(&[], |judge| judge.parts())
}

/// Offers the files of a program's answer: polygons as SVG and GeoJSON, meshes as OFF, OBJ and PLY, all other
/// forms as JSON. A part with a wrong form is left out with a remark.
pub(crate) fn write<T: Task>(
    judge: Option<&'static dyn Replies<T>>,
    reply: &Reply,
    files: &mut Files,
) -> Result<(), output::Error> {
    for part in parts(judge) {
        match write_part(part, &reply.arrays, files)? {
            Ok(()) => {}
            Err(malformed) if part.is_required => files.note(format!("{} is not written: {malformed}", part.name)),
            Err(_) => {}
        }
    }
    Ok(())
}

fn write_part(part: &Part, arrays: &Arrays, files: &mut Files) -> Result<Result<(), Malformed>, output::Error> {
    match part.form {
        Form::Triangles | Form::Loop | Form::Labels => match arrays.ids(part.name) {
            Ok(ids) => files.json(&format!("{}.json", part.name), || json!(ids))?,
            Err(malformed) => return Ok(Err(malformed)),
        },
        Form::Polygons => match arrays.polygons(part.name) {
            Ok(polygons) => {
                let (scene, polygons) = numbered(&polygons)?;
                output::plane(files, &scene, part.name, polygons.into_iter())?;
            }
            Err(malformed) => return Ok(Err(malformed)),
        },
        Form::Mesh => match arrays.mesh(part.name) {
            Ok(mesh) => write_mesh(part.name, &mesh, files)?,
            Err(malformed) => return Ok(Err(malformed)),
        },
        Form::Meshes => match arrays.meshes(part.name) {
            Ok(meshes) => {
                for (at, mesh) in meshes.iter().enumerate() {
                    write_mesh(&format!("{}-{at}", part.name), mesh, files)?;
                }
            }
            Err(malformed) => return Ok(Err(malformed)),
        },
        Form::Lines => match arrays.lines(part.name) {
            Ok(lines) => files.json(&format!("{}.json", part.name), || json!(lines))?,
            Err(malformed) => return Ok(Err(malformed)),
        },
        Form::Lists(_) => match arrays.lists(part.name, usize::MAX) {
            Ok(lists) => files.json(&format!("{}.json", part.name), || json!(lists))?,
            Err(malformed) => return Ok(Err(malformed)),
        },
        Form::Number => match arrays.number(part.name) {
            Ok(number) => files.json(&format!("{}.json", part.name), || json!(number))?,
            Err(malformed) => return Ok(Err(malformed)),
        },
    }
    Ok(Ok(()))
}

fn write_mesh(name: &str, mesh: &Mesh, files: &mut Files) -> Result<(), output::Error> {
    let of = scene_of(&mesh.points)?;
    let faces = mesh.triangles.iter().map(|triangle| triangle.map(|v| Vertex::input(v as usize)).to_vec());
    output::mesh(files, &of, name, faces)
}

/// Polygons with numbered points, in a scene of these.
fn numbered(polygons: &Rings) -> std::io::Result<(Scene, Vec<Vec<Vec<Vertex>>>)> {
    let points: Vec<[f64; 2]> = polygons.iter().flatten().flatten().copied().collect();
    let mut next = 0..;
    let mut ring = |ring: &Vec<[f64; 2]>| -> Vec<Vertex> {
        ring.iter().map(|_| Vertex::input(next.next().unwrap_or_default())).collect()
    };
    let polygons = polygons.iter().map(|rings| rings.iter().map(&mut ring).collect()).collect();
    Ok((scene_of(&points)?, polygons))
}

/// Adds a program's answer to a drawing. Parts with a wrong form are not drawn.
pub(crate) fn draw<T: Task>(
    judge: Option<&'static dyn Replies<T>>,
    scene: &Scene,
    reply: &Reply,
    canvas: &mut Canvas,
) -> std::io::Result<()> {
    for part in parts(judge) {
        let arrays = &reply.arrays;
        match part.form {
            Form::Triangles => {
                if let Ok(triangles) = arrays.tuples::<3>(part.name, scene.len()) {
                    canvas.faces(scene, part.name, Role::Found, &triangles)?;
                }
            }
            Form::Loop => {
                if let Ok(corners) = arrays.tuples::<1>(part.name, scene.len()) {
                    canvas.faces(scene, part.name, Role::Found, [corners.as_flattened()])?;
                }
            }
            Form::Labels | Form::Lists(_) | Form::Number => {}
            Form::Lines => {
                if let Ok(lines) = arrays.lines(part.name) {
                    let line = |line: &[[f64; 2]]| vec![line.iter().map(|&[x, y]| [x, y, 0.0]).collect()];
                    canvas.places(part.name, Role::Found, Shape::Lines, lines.into_iter().map(line));
                }
            }
            Form::Polygons => {
                if let Ok(polygons) = arrays.polygons(part.name) {
                    let rings = |rings: &Vec<Vec<[f64; 2]>>| {
                        rings.iter().map(|ring| ring.iter().map(|&[x, y]| [x, y, 0.0]).collect()).collect()
                    };
                    canvas.places(part.name, Role::Found, Shape::Areas, polygons.iter().map(rings));
                }
            }
            Form::Mesh | Form::Meshes => {
                if let Ok(mesh) = arrays.mesh(part.name) {
                    let corners = mesh.corners().into_iter().map(|corners| vec![corners.to_vec()]);
                    canvas.places(part.name, Role::Found, Shape::Areas, corners);
                }
            }
        }
    }
    Ok(())
}
