//! Drawings as data for the view in a browser, and as a page with the view.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::{Drawing, Layer, Offset, Window};
use crate::Error;
use crate::page::fill;

/// The scripts of the view: a library for WebGL, then the view's own script.
pub const SCRIPTS: [&str; 2] = [include_str!("../../web/vendor/ogl.js"), include_str!("../../web/view.js")];

/// The maximum of a coordinate in the data, a whole number: finer than the pixels of any screen.
const STEPS: f64 = 1e6;

impl Drawing {
    /// The drawing as data for the view. Coordinates are whole millionths of half the longest side, from the centre;
    /// `unit` is that half side.
    ///
    /// ```text
    /// { "space": true, "unit": 0.5, "layers": [
    ///     { "name": "faces", "role": "given", "shape": "areas", "labels": [], "parts": 1, "shown": true,
    ///       "points": [-1000000, 0, 0, 1000000, 0, 0, 0, 1000000, 0], "lengths": [3], "at": [0, 1, 2] } ] }
    /// ```
    #[must_use]
    pub fn json(&self) -> Value {
        let (middle, unit) = self.extent(Window::Whole);
        let layers: Vec<Value> = self.layers.iter().map(|layer| layer_json(layer, middle, unit)).collect();
        json!({ "space": self.is_space, "unit": unit, "layers": layers })
    }

    /// A self-contained page with the view of the drawing, under a title.
    ///
    /// # Errors
    /// If the page can't be filled in.
    pub fn page(&self, title: &str) -> Result<String, Error> {
        // The data must not contain the end tag of their element.
        let data = self.json().to_string().replace('<', "\\u003c");
        fill(
            "view.html",
            minijinja::context! {
                title => title,
                data => minijinja::Value::from_safe_string(data),
                style => minijinja::Value::from_safe_string(crate::web::STYLE.to_owned()),
                scripts => minijinja::Value::from_safe_string(SCRIPTS.concat()),
                licences => minijinja::Value::from_safe_string(crate::licences::comment()),
            },
        )
    }
}

fn layer_json(layer: &Layer, middle: Offset, unit: f64) -> Value {
    let (mut places, mut points): (BTreeMap<[i32; 3], u32>, Vec<i32>) = (BTreeMap::new(), Vec::new());
    let (mut at, mut lengths): (Vec<u32>, Vec<usize>) = (Vec::new(), Vec::new());
    for path in layer.parts.iter().flatten() {
        lengths.push(path.len());
        for point in path {
            #[allow(clippy::cast_possible_truncation)]
            // a hidden layer may be outside of the box: the conversion then gives the largest whole number
            let place =
                [0, 1, 2].map(|axis: usize| ((point[axis] / unit - middle[axis] / unit) * STEPS).round() as i32);
            let next = u32::try_from(places.len()).unwrap_or(u32::MAX);
            at.push(*places.entry(place).or_insert_with(|| {
                points.extend(place);
                next
            }));
        }
    }
    // For a drawing of only triangles, the length is written once.
    lengths.dedup();
    let lengths = if lengths.len() == 1 { lengths } else { layer.parts.iter().flatten().map(Vec::len).collect() };
    json!({
        "name": layer.name, "role": layer.role.name(), "shape": layer.shape.name(), "labels": layer.labels,
        "parts": layer.parts.len(), "shown": layer.is_shown, "points": points, "lengths": lengths, "at": at,
    })
}

#[cfg(test)]
mod tests {
    use super::super::{Role, Shape};
    use super::*;

    #[test]
    fn points_are_kept_once_and_equal_lengths_too() {
        let triangle = |x: f64| vec![vec![[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [0.0, 4.0, 0.0]]];
        let layer = Layer {
            name: "t".into(),
            role: Role::Given,
            shape: Shape::Areas,
            parts: vec![triangle(0.0), triangle(1.0)],
            labels: vec![],
            is_shown: true,
        };
        let drawing = Drawing { is_space: true, layers: vec![layer] };
        let data = drawing.json();
        let layer = &data["layers"][0];
        assert_eq!((&layer["lengths"], &layer["at"]), (&json!([3]), &json!([0, 1, 2, 1, 3, 2])));
        assert_eq!((&data["unit"], layer["points"].as_array().unwrap().len()), (&json!(2.0), 12));
        assert_eq!(layer["points"][1], json!(-1_000_000));
    }

    #[test]
    fn names_don_t_end_the_script_they_are_in() {
        let layer = Layer {
            name: "</script><b>".into(),
            role: Role::Mark,
            shape: Shape::Points,
            parts: vec![],
            labels: vec![],
            is_shown: true,
        };
        let page = Drawing { is_space: false, layers: vec![layer] }.page("a <title>").unwrap();
        assert!(!page.contains("</script><b>") && page.contains("a &lt;title&gt;"));
    }
}
