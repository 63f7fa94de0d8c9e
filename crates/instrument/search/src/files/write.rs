//! Writers of files as pieces, in the format that was read.

use super::sketch::{Encoding, Form, Kind, Outer, Shape, Sketch};

impl Sketch {
    /// The contents of the file: points that items name, in their order, and items.
    #[must_use]
    pub fn written(&self) -> Vec<u8> {
        match &self.form {
            Form::Stl(encoding) => self.triangles(*encoding),
            Form::Ply(encoding) => self.ply(*encoding),
            Form::Off | Form::Obj => self.text_mesh().into_bytes(),
            Form::GeoJson(outer) => self.geojson(*outer).into_bytes(),
            Form::Wkt => {
                self.items.iter().map(|item| geometry(item, &self.points, false) + "\n").collect::<String>().into()
            }
            Form::Csv(head, separator) => {
                let head = if head.is_empty() { String::new() } else { format!("{head}\n") };
                let rows = self.places().into_iter().map(|at| self.points[at].join(separator) + "\n");
                (head + &rows.collect::<String>()).into_bytes()
            }
        }
    }

    /// The loops of a mesh of this kind.
    fn loops(&self, kind: Kind) -> impl Iterator<Item = &Vec<usize>> {
        self.items.iter().flat_map(|item| item.iter()).filter(move |shape| shape.kind == kind).flat_map(|s| &s.loops)
    }

    /// The points that items name, and the new index of each point.
    fn renumbered(&self) -> (Vec<usize>, Vec<usize>) {
        let places = self.places();
        let mut numbers = vec![0; self.points.len()];
        places.iter().enumerate().for_each(|(number, &at)| numbers[at] = number);
        (places, numbers)
    }

    fn text_mesh(&self) -> String {
        let (places, numbers) = self.renumbered();
        let is_obj = self.form == Form::Obj;
        let (start, first) = if is_obj { ("v ", 1) } else { ("", 0) };
        let corners = |one: &Vec<usize>| {
            one.iter().map(|&corner| (numbers[corner] + first).to_string()).collect::<Vec<_>>().join(" ")
        };
        let points: String = places.iter().map(|&at| format!("{start}{}\n", self.points[at].join(" "))).collect();
        let faces = self.loops(Kind::Area);
        if is_obj {
            let lines = self.loops(Kind::Line).map(|one| format!("l {}\n", corners(one)));
            return points + &lines.chain(faces.map(|one| format!("f {}\n", corners(one)))).collect::<String>();
        }
        let faces: Vec<String> = faces.map(|one| format!("{} {}\n", one.len(), corners(one))).collect();
        format!("OFF\n{} {} 0\n{points}{}", places.len(), faces.len(), faces.concat())
    }

    fn ply(&self, encoding: Encoding) -> Vec<u8> {
        let (places, numbers) = self.renumbered();
        let faces: Vec<&Vec<usize>> = self.loops(Kind::Area).collect();
        let is_short = faces.iter().all(|face| u8::try_from(face.len()).is_ok());
        let name = match encoding {
            Encoding::Text => "ascii",
            Encoding::Little => "binary_little_endian",
            Encoding::Big => "binary_big_endian",
        };
        let length = if is_short { "uchar" } else { "uint" };
        let mut bytes = format!(
            "ply\nformat {name} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
             element face {}\nproperty list {length} int vertex_indices\nend_header\n",
            places.len(),
            faces.len()
        )
        .into_bytes();
        if encoding == Encoding::Text {
            let points = places.iter().map(|&at| self.points[at].join(" ") + "\n");
            let corners = |face: &Vec<usize>| face.iter().map(|&at| format!(" {}", numbers[at])).collect::<String>();
            let faces = faces.iter().map(|face| format!("{}{}\n", face.len(), corners(face)));
            bytes.extend(points.chain(faces).flat_map(String::into_bytes));
            return bytes;
        }
        let mut push = |mut number: Vec<u8>| {
            if encoding == Encoding::Big {
                number.reverse();
            }
            bytes.extend(number);
        };
        for text in places.iter().flat_map(|&at| &self.points[at]) {
            push(text.parse().unwrap_or(0.0_f64).to_le_bytes().to_vec());
        }
        let integer = |number: usize| u32::try_from(number).unwrap_or(u32::MAX).to_le_bytes().to_vec();
        for face in faces {
            let length = integer(face.len());
            push(if is_short { length[..1].to_vec() } else { length });
            face.iter().for_each(|&corner| push(integer(numbers[corner])));
        }
        bytes
    }

    fn triangles(&self, encoding: Encoding) -> Vec<u8> {
        let triangles: Vec<&Vec<usize>> = self.loops(Kind::Area).collect();
        if encoding == Encoding::Text {
            let vertex = |&at: &usize| format!("vertex {}\n", self.points[at].join(" "));
            let facet = |corners: &&Vec<usize>| {
                let corners: String = corners.iter().map(vertex).collect();
                format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
            };
            return format!("solid\n{}endsolid\n", triangles.iter().map(facet).collect::<String>()).into_bytes();
        }
        let mut bytes = vec![b' '; 80];
        bytes.extend(u32::try_from(triangles.len()).unwrap_or(u32::MAX).to_le_bytes());
        for corners in triangles {
            bytes.extend([0; 12]);
            for text in corners.iter().flat_map(|&at| &self.points[at]) {
                bytes.extend(text.parse().unwrap_or(0.0_f32).to_le_bytes());
            }
            bytes.extend([0; 2]);
        }
        bytes
    }

    fn geojson(&self, outer: Outer) -> String {
        let geometries: Vec<String> = self.items.iter().map(|item| geometry(item, &self.points, true)).collect();
        let feature =
            |geometry: &String| format!("{{\"type\":\"Feature\",\"properties\":{{}},\"geometry\":{geometry}}}");
        let features: Vec<String> = geometries.iter().map(feature).collect();
        match outer {
            Outer::Collection => {
                format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n]}}\n", features.join(",\n"))
            }
            Outer::Feature => features.concat() + "\n",
            Outer::Geometry => geometries.concat() + "\n",
            Outer::Rings => {
                let rings = self.loops(Kind::Area).map(|ring| positions(ring, &self.points, true));
                format!("[{}]\n", rings.collect::<Vec<_>>().join(","))
            }
        }
    }
}

/// The positions of a loop as an array of JSON, or as a list of WKT.
fn positions(corners: &[usize], points: &[Vec<String>], is_json: bool) -> String {
    let one = |&at: &usize| if is_json { format!("[{}]", points[at].join(",")) } else { points[at].join(" ") };
    listed(corners.iter().map(one), is_json)
}

fn listed(all: impl Iterator<Item = String>, is_json: bool) -> String {
    let all: Vec<String> = all.collect();
    if is_json { format!("[{}]", all.join(",")) } else { format!("({})", all.join(", ")) }
}

/// A geometry of JSON or WKT: one shape, several of a kind, or a collection.
fn geometry(shapes: &[Shape], points: &[Vec<String>], is_json: bool) -> String {
    let body = |shape: &Shape| match shape.kind {
        Kind::Point if is_json => format!("[{}]", points[shape.loops[0][0]].join(",")),
        Kind::Point | Kind::Line => positions(&shape.loops[0], points, is_json),
        Kind::Area => {
            let closed = |ring: &Vec<usize>| ring.iter().chain(ring.first()).copied().collect::<Vec<_>>();
            listed(shape.loops.iter().map(|ring| positions(&closed(ring), points, is_json)), is_json)
        }
    };
    let named = |kind: &str, member: &str, body: &str| {
        if is_json { format!("{{\"type\":\"{kind}\",\"{member}\":{body}}}") } else { kind.to_uppercase() + " " + body }
    };
    let [first, rest @ ..] = shapes else { return (if is_json { "null" } else { "POINT EMPTY" }).to_owned() };
    let kind = match first.kind {
        Kind::Point => "Point",
        Kind::Line => "LineString",
        Kind::Area => "Polygon",
    };
    let is_solid = shapes.iter().flat_map(|shape| shape.loops.iter().flatten()).any(|&at| points[at].len() > 2);
    let kind = if is_solid && !is_json { format!("{kind} Z") } else { kind.to_owned() };
    if rest.is_empty() {
        named(&kind, "coordinates", &body(first))
    } else if rest.iter().all(|shape| shape.kind == first.kind) {
        named(&format!("Multi{kind}"), "coordinates", &listed(shapes.iter().map(body), is_json))
    } else {
        let all = shapes.iter().map(|shape| geometry(std::slice::from_ref(shape), points, is_json));
        named("GeometryCollection", "geometries", &listed(all, is_json))
    }
}
