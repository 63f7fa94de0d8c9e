//! Files with the answer of another program, read into the arrays that its task's judge takes.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use predicament_formats::{CorpusError, Decimals, geometry, mesh as meshes, read_bytes, text_of};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::AnyTask;
use predicament_tasks::replies::{Array, Arrays, Form, Mesh, Part, Rings};
use serde_json::Value;

use crate::exit::Failure;

/// The extensions of files with meshes.
const MESHES: [&str; 4] = ["off", "obj", "ply", "stl"];
/// The extensions of files with polygons.
const POLYGONS: [&str; 3] = ["geojson", "json", "wkt"];

/// The arrays of an answer, and the number of decimals that were rounded.
///
/// Each file is `FILE` or `PART=FILE`. Without a part, the file's name without its extension is the part if the task
/// has such a part; otherwise the task's only or first part.
pub fn read(task: &dyn AnyTask, scene: &Scene, files: &[String]) -> Result<(Arrays, usize), Failure> {
    let parts = task
        .parts_of_replies()
        .ok_or_else(|| Failure::usage(format!("{} has no judge of other programs' answers", task.name())))?;
    let decimals = Decimals::new(true);
    let mut arrays = Arrays::default();
    for file in files {
        let (part, path) = part_of(task, parts, file)?;
        add(part, scene, &path, &decimals, &mut arrays)?;
    }
    Ok((arrays, decimals.rounded()))
}

/// The part that a file holds.
fn part_of<'p>(task: &dyn AnyTask, parts: &'p [Part], file: &str) -> Result<(&'p Part, PathBuf), Failure> {
    let named = |name: &str| parts.iter().find(|part| part.name == name);
    if let Some((name, path)) = file.split_once('=')
        && let Some(part) = named(name)
    {
        return Ok((part, PathBuf::from(path)));
    }
    let path = PathBuf::from(file);
    let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    if let Some(part) = named(stem) {
        return Ok((part, path));
    }
    let mut required = parts.iter().filter(|part| part.is_required);
    match (required.next(), parts) {
        (Some(part), _) | (None, [part]) => Ok((part, path)),
        _ => {
            let names: Vec<&str> = parts.iter().map(|part| part.name).collect();
            Err(Failure::usage(format!(
                "--answer {file}: {} has the parts {}; write PART=FILE",
                task.name(),
                names.join(", ")
            )))
        }
    }
}

fn add(part: &Part, scene: &Scene, path: &Path, decimals: &Decimals, arrays: &mut Arrays) -> Result<(), Failure> {
    let name = path.display().to_string();
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default().to_lowercase();
    let bytes = read_bytes(path).map_err(Failure::usage)?;
    let is = |known: &[&str]| known.contains(&extension.as_str());
    match part.form {
        Form::Mesh if is(&MESHES) => arrays.add_mesh(part.name, &mesh(&name, bytes, decimals).map_err(Failure::usage)?),
        Form::Polygons if is(&POLYGONS) => {
            arrays.add_polygons(part.name, &polygons(&name, bytes, decimals).map_err(Failure::usage)?)
        }
        Form::Triangles if is(&MESHES) => {
            let mesh = mesh(&name, bytes, decimals).map_err(Failure::usage)?;
            let at = places(scene);
            let corners = mesh.triangles.iter().flatten().map(|&v| at(&mesh.points[v as usize])).collect();
            arrays.add(part.name, Array::Ids(corners));
        }
        Form::Triangles | Form::Loop if is(&["geojson", "wkt"]) => {
            let rings = polygons(&name, bytes, decimals).map_err(Failure::usage)?;
            let at = places(scene);
            let corners = rings.iter().flatten().flatten().map(|point| at(point)).collect();
            arrays.add(part.name, Array::Ids(corners));
        }
        Form::Triangles | Form::Loop | Form::Labels if is(&["json"]) => {
            let text = text_of(&name, bytes).map_err(Failure::usage)?;
            let value: Value = serde_json::from_str(&text)
                .map_err(|error| CorpusError::file(&name, error.to_string(), "write an array of whole numbers"))
                .map_err(Failure::usage)?;
            let mut ids = Vec::new();
            numbers(&value, &mut ids).map_err(|what| Failure::usage(wrong(&name, &what, None)))?;
            arrays.add(part.name, Array::Ids(ids));
        }
        Form::Triangles | Form::Loop | Form::Labels if is(&["csv", "txt"]) => {
            let text = text_of(&name, bytes).map_err(Failure::usage)?;
            arrays.add(part.name, Array::Ids(columns(&name, &text, part.form).map_err(Failure::usage)?));
        }
        form => {
            let takes = match form {
                Form::Mesh => "OFF, OBJ, PLY or STL",
                Form::Polygons => "GeoJSON or WKT",
                Form::Triangles => "OFF, OBJ, PLY, STL, GeoJSON, WKT, JSON or CSV",
                Form::Loop => "GeoJSON, WKT, JSON or CSV",
                Form::Labels => "JSON or CSV",
            };
            let of = part.name;
            return Err(Failure::usage(format!("{name}: `{of}` is read from {takes}, by the file's extension")));
        }
    }
    Ok(())
}

fn mesh(name: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<Mesh, CorpusError> {
    let read = meshes::read(name, bytes, decimals)?;
    let number = |v: Vertex| u32::try_from(v.index()).expect("an index of 32 bits");
    Ok(Mesh { points: read.points, triangles: read.triangles.into_iter().map(|one| one.map(number)).collect() })
}

fn polygons(name: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<Rings, CorpusError> {
    Ok(geometry::read(name, bytes, decimals)?.polygons())
}

/// A function that finds the first point of a scene with these coordinates; `u32::MAX` stands for none.
fn places(scene: &Scene) -> impl Fn(&[f64]) -> u32 {
    let key = |point: &[f64]| point.iter().map(|x| (x + 0.0).to_bits()).collect::<Vec<u64>>();
    let mut at: HashMap<Vec<u64>, u32> = HashMap::new();
    for v in scene.vertices() {
        at.entry(key(scene.point(v))).or_insert(u32::try_from(v.index()).unwrap_or(u32::MAX));
    }
    let dimension = scene.dimension().count();
    move |point: &[f64]| at.get(&key(&point[..dimension.min(point.len())])).copied().unwrap_or(u32::MAX)
}

/// All whole numbers of nested arrays; −1 and −2 are the labels of `u32::MAX` and the number before it.
fn numbers(value: &Value, to: &mut Vec<u32>) -> Result<(), String> {
    match value {
        Value::Array(values) => values.iter().try_for_each(|value| numbers(value, to)),
        Value::Number(number) => match number.as_i64().and_then(label) {
            Some(id) => {
                to.push(id);
                Ok(())
            }
            None => Err(number.to_string()),
        },
        other => Err(other.to_string()),
    }
}

/// A number of 32 bits, or one of the labels −1 and −2.
fn label(number: i64) -> Option<u32> {
    match number {
        -1 => Some(u32::MAX),
        -2 => Some(u32::MAX - 1),
        number => u32::try_from(number).ok(),
    }
}

/// The numbers of a CSV file: of labels, those of the last column. A first line without a number is a header.
fn columns(name: &str, text: &str, form: Form) -> Result<Vec<u32>, CorpusError> {
    let mut ids = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let cells: Vec<&str> =
            line.split([',', ';', ' ', '\t']).map(str::trim).filter(|cell| !cell.is_empty()).collect();
        let read = |cell: &&str| cell.parse::<i64>().ok().and_then(label);
        let used = if form == Form::Labels { &cells[cells.len().saturating_sub(1)..] } else { &cells[..] };
        match used.iter().find(|cell| read(cell).is_none()) {
            Some(_) if at == 0 => {}
            Some(cell) => return Err(wrong(name, cell, Some(at + 1))),
            None => ids.extend(used.iter().filter_map(read)),
        }
    }
    Ok(ids)
}

fn wrong(name: &str, what: &str, line: Option<usize>) -> CorpusError {
    let error = CorpusError::file(
        name,
        format!("`{what}` is neither an index nor a label"),
        "write whole numbers from 0 on, −1 for outside, or −2 for a border",
    );
    match line {
        Some(line) => error.at_line(line),
        None => error,
    }
}
