//! Files with the answer of another program, read into the arrays that its task's judge takes.

use std::collections::{HashMap, HashSet};
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
/// has such a part; otherwise the task's only or first part. Points of a file are found by the coordinates of the scene
/// and of the probes of the question.
pub fn read(
    task: &dyn AnyTask,
    scene: &Scene,
    question: &Arrays,
    files: &[String],
) -> Result<(Arrays, usize), Failure> {
    let parts = task
        .parts_of_replies()
        .ok_or_else(|| Failure::usage(format!("{} has no judge of other programs' answers", task.name())))?;
    let decimals = Decimals::new(true);
    let mut arrays = Arrays::default();
    for file in files {
        let (part, path) = part_of(task, parts, file)?;
        add((part, parts), (scene, question), &path, &decimals, &mut arrays)?;
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

fn add(
    (part, parts): (&Part, &[Part]),
    (scene, question): (&Scene, &Arrays),
    path: &Path,
    decimals: &Decimals,
    arrays: &mut Arrays,
) -> Result<(), Failure> {
    let name = path.display().to_string();
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default().to_lowercase();
    let bytes = read_bytes(path).map_err(Failure::usage)?;
    let is = |known: &[&str]| known.contains(&extension.as_str());
    match part.form {
        Form::Mesh if is(&MESHES) => arrays.add_mesh(part.name, &mesh(&name, bytes, decimals).map_err(Failure::usage)?),
        Form::Meshes if is(&MESHES) => {
            // Each file is one of the meshes.
            let mut all = arrays.meshes(part.name).unwrap_or_default();
            all.push(mesh(&name, bytes, decimals).map_err(Failure::usage)?);
            arrays.remove(part.name);
            arrays.add_meshes(part.name, &all);
        }
        Form::Lines if is(&["geojson", "wkt"]) => {
            let lines = geometry::read(&name, bytes, decimals).map_err(Failure::usage)?.lines();
            arrays.add_lines(part.name, &lines);
        }
        Form::Lines if is(&["json"]) => {
            let lines = json(&name, bytes, |value| lines(value, decimals), "a list of lists of two coordinates");
            arrays.add_lines(part.name, &lines.map_err(Failure::usage)?);
        }
        Form::Lists(keys) if is(&["json"]) => {
            let lists = json(&name, bytes, |value| lists(value, keys), "a list of lists of whole numbers");
            arrays.add_lists(part.name, &lists.map_err(Failure::usage)?);
        }
        Form::Lists(_) if is(&["csv", "txt"]) => {
            let text = text_of(&name, bytes).map_err(Failure::usage)?;
            arrays.add_lists(part.name, &rows(&name, &text).map_err(Failure::usage)?);
        }
        Form::Number if is(&["json", "txt"]) => {
            let found = json(&name, bytes, |value| Ok(value.clone()), "a number").map_err(Failure::usage)?;
            numbers_of(&name, part, parts, &found, decimals, arrays).map_err(Failure::usage)?;
        }
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
        Form::Labels if is(&["geojson"]) => {
            let labelled = json(&name, bytes, |value| labelled(value, decimals), "points with a property `label`");
            let labels = of_probes(&name, (scene, question), &labelled.map_err(Failure::usage)?);
            arrays.add(part.name, Array::Ids(labels.map_err(Failure::usage)?));
        }
        Form::Triangles | Form::Loop | Form::Labels if is(&["json"]) => {
            let ids =
                json(&name, bytes, numbers, "an array of whole numbers from 0 on, −1 for outside, or −2 for a border")
                    .map_err(Failure::usage)?;
            arrays.add(part.name, Array::Ids(ids));
        }
        Form::Triangles | Form::Loop | Form::Labels if is(&["csv", "txt"]) => {
            let text = text_of(&name, bytes).map_err(Failure::usage)?;
            arrays.add(part.name, Array::Ids(columns(&name, &text, part.form).map_err(Failure::usage)?));
        }
        form => {
            let takes = match form {
                Form::Mesh | Form::Meshes => "OFF, OBJ, PLY or STL",
                Form::Lines => "GeoJSON, WKT or JSON",
                Form::Lists(_) => "JSON or CSV",
                Form::Number => "JSON",
                Form::Polygons => "GeoJSON or WKT",
                Form::Triangles => "OFF, OBJ, PLY, STL, GeoJSON, WKT, JSON or CSV",
                Form::Loop => "GeoJSON, WKT, JSON or CSV",
                Form::Labels => "GeoJSON, JSON or CSV",
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

/// A point as a key: equal for equal coordinates.
fn key(point: &[f64]) -> Vec<u64> {
    point.iter().map(|x| (x + 0.0).to_bits()).collect()
}

/// A function that finds the first point of a scene with these coordinates; `u32::MAX` stands for none.
fn places(scene: &Scene) -> impl Fn(&[f64]) -> u32 {
    let mut at: HashMap<Vec<u64>, u32> = HashMap::new();
    for v in scene.vertices() {
        at.entry(key(scene.point(v))).or_insert(u32::try_from(v.index()).unwrap_or(u32::MAX));
    }
    let dimension = scene.dimension().count();
    move |point: &[f64]| at.get(&key(&point[..dimension.min(point.len())])).copied().unwrap_or(u32::MAX)
}

/// A value read from a JSON file, by a function that returns the part of it that is wrong.
fn json<T>(
    name: &str,
    bytes: Vec<u8>,
    read: impl FnOnce(&Value) -> Result<T, String>,
    wanted: &str,
) -> Result<T, CorpusError> {
    let text = text_of(name, bytes)?;
    let cure = || format!("write {wanted}");
    let value: Value =
        serde_json::from_str(&text).map_err(|error| CorpusError::file(name, error.to_string(), cure()))?;
    read(&value).map_err(|what| CorpusError::file(name, format!("`{what}` is not a part of {wanted}"), cure()))
}

/// All whole numbers of nested arrays; −1 and −2 are the labels of `u32::MAX` and the number before it. A number may be
/// text, as the vertices of `solve` are.
fn numbers(value: &Value) -> Result<Vec<u32>, String> {
    let number = match value {
        Value::Array(values) => {
            return values.iter().map(numbers).collect::<Result<Vec<_>, _>>().map(|all| all.concat());
        }
        Value::Number(number) => number.as_i64(),
        Value::String(text) => text.parse().ok(),
        _ => None,
    };
    number.and_then(label).map(|id| vec![id]).ok_or_else(|| value.to_string())
}

/// The points of a GeoJSON collection, each with its property `label`.
fn labelled(value: &Value, decimals: &Decimals) -> Result<Vec<(Vec<f64>, u32)>, String> {
    let feature = |value: &Value| {
        let place = &value["geometry"]["coordinates"];
        let place: Vec<f64> = match place.as_array() {
            Some(place) => place.iter().map(|x| coordinate(x, decimals)).collect::<Result<_, _>>()?,
            None => return Err(value.to_string()),
        };
        match numbers(&value["properties"]["label"])?.as_slice() {
            [label] => Ok((place, *label)),
            _ => Err(value.to_string()),
        }
    };
    value["features"].as_array().ok_or_else(|| value.to_string())?.iter().map(feature).collect()
}

/// The label of each probe, by its coordinates: a program may list its points in another order. Probes that the program
/// left out have no label, so that the judge counts them.
fn of_probes(
    name: &str,
    (scene, question): (&Scene, &Arrays),
    labelled: &[(Vec<f64>, u32)],
) -> Result<Vec<u32>, CorpusError> {
    let wrong = |what: String, cure: &str| CorpusError::file(name, what, cure);
    let dimension = scene.dimension().count();
    let Some(Array::Numbers(probes)) = question.get("probes") else {
        return Err(wrong("the probes of this task have no coordinates".to_owned(), "write JSON or CSV"));
    };
    let probes: Vec<Vec<u64>> = probes.chunks_exact(dimension).map(key).collect();
    let known: HashSet<&Vec<u64>> = probes.iter().collect();
    let mut of = HashMap::new();
    for (place, label) in labelled {
        let at = key(place.get(..dimension).unwrap_or_default());
        if !known.contains(&at) {
            return Err(wrong(format!("{place:?} is not a probe of this scene"), "write the probes alone"));
        }
        of.insert(at, *label);
    }
    Ok(probes.iter().filter_map(|probe| of.get(probe)).copied().collect())
}

/// Lists of whole numbers; of an object, the values of these keys together.
fn lists(value: &Value, keys: &[&str]) -> Result<Vec<Vec<u32>>, String> {
    let list = |value: &Value| match value {
        Value::Object(object) => {
            let of = |key: &&str| object.get(*key).ok_or_else(|| value.to_string()).and_then(numbers);
            keys.iter().map(of).collect::<Result<Vec<_>, _>>().map(|all| all.concat())
        }
        Value::Array(_) => numbers(value),
        _ => Err(value.to_string()),
    };
    value.as_array().ok_or_else(|| value.to_string())?.iter().map(list).collect()
}

/// Lists of points.
fn lines(value: &Value, decimals: &Decimals) -> Result<Vec<Vec<[f64; 2]>>, String> {
    let point = |value: &Value| match value.as_array().map(Vec::as_slice) {
        Some([x, y]) => Ok([coordinate(x, decimals)?, coordinate(y, decimals)?]),
        _ => Err(value.to_string()),
    };
    let line = |value: &Value| value.as_array().ok_or_else(|| value.to_string())?.iter().map(point).collect();
    value.as_array().ok_or_else(|| value.to_string())?.iter().map(line).collect()
}

/// A number; decimals that are not doubles are rounded and counted.
fn coordinate(value: &Value, decimals: &Decimals) -> Result<f64, String> {
    let text = match value {
        Value::Number(number) => number.to_string(),
        other => return Err(other.to_string()),
    };
    decimals.read(&text).map_err(|_| text)
}

/// The number of a part, or all numbers of an object with the parts' names.
fn numbers_of(
    name: &str,
    part: &Part,
    parts: &[Part],
    value: &Value,
    decimals: &Decimals,
    arrays: &mut Arrays,
) -> Result<(), CorpusError> {
    let number = |value: &Value| {
        coordinate(value, decimals)
            .map(|x| Array::Numbers(vec![x]))
            .map_err(|what| CorpusError::file(name, format!("`{what}` is not a number"), "write a number"))
    };
    let Value::Object(object) = value else {
        arrays.add(part.name, number(value)?);
        return Ok(());
    };
    for of in parts.iter().filter(|of| of.form == Form::Number) {
        if let Some(value) = object.get(of.name) {
            arrays.add(of.name, number(value)?);
        }
    }
    Ok(())
}

/// The lists of a CSV file, one a line. A first line without a number is a header.
fn rows(name: &str, text: &str) -> Result<Vec<Vec<u32>>, CorpusError> {
    let mut lists = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let mut cells = line.split([',', ';', ' ', '\t']).map(str::trim).filter(|cell| !cell.is_empty());
        match cells.clone().find(|cell| cell.parse::<u32>().is_err()) {
            Some(_) if at == 0 => {}
            Some(cell) => return Err(wrong(name, cell, Some(at + 1))),
            None => lists.push(cells.by_ref().filter_map(|cell| cell.parse().ok()).collect()),
        }
    }
    Ok(lists)
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
