//! A shrunk scene as a test in Rust, C++, Python and JavaScript, to paste beside other predicates.
//!
//! Coordinates are exact: bits in Rust, hex floats in C++ (17) and Python, and in JavaScript the shortest decimals that
//! read back as the same doubles. A predicate is called by its name with the
//! points in the order of the query. For other tasks the test has the data, the call, and the message of the check.

use std::fmt::Write as _;

use predicament_corpus::{Items, Spelled};
use predicament_formats::hexfloat;
use predicament_predicates::{Query, Question, Sign, Vertex};
use predicament_tasks::Finding;

/// The content of a test.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The scene.
    pub spelled: &'a Spelled,
    /// The finding that it shows.
    pub finding: &'a Finding,
    /// The backend that shows it.
    pub backend: &'a str,
    /// The name of the scene.
    pub name: &'a str,
    /// The file of the suite that contains the scene.
    pub suite: &'a str,
}

/// A call of a predicate on points, and the true sign.
struct Call {
    function: &'static str,
    points: Vec<Vec<f64>>,
    truth: Option<Sign>,
    query: String,
}

impl Subject<'_> {
    fn identifier(&self) -> String {
        let letters = self.name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' });
        let name: String = letters.collect();
        let is_fine = name.starts_with(|c: char| c.is_ascii_alphabetic());
        if is_fine { name } else { format!("scene_{name}") }
    }

    fn what(&self) -> String {
        let finding = self.finding;
        let mut text = format!("{}: {} ({})", self.backend, finding.class.name(), finding.check);
        if !finding.got.is_empty() {
            let _ = write!(text, ", got {}", finding.got);
        }
        if !finding.truth.is_empty() {
            let _ = write!(text, ", truth {}", finding.truth);
        }
        text.replace('\n', " ")
    }

    /// The calls of the finding's queries; empty if a query is not a predicate of input points.
    fn calls(&self) -> Vec<Call> {
        let calls: Option<Vec<Call>> = self.finding.queries.iter().map(|query| self.call(query)).collect();
        calls.unwrap_or_default()
    }

    fn call(&self, query: &Query) -> Option<Call> {
        let (question, args) = query.question()?;
        let point = |v: &Vertex| self.spelled.points.get(v.index()).cloned();
        let points: Vec<Vec<f64>> = args.iter().map(point).collect::<Option<_>>()?;
        let (function, axes): (&'static str, &[usize]) = match question {
            Question::Derived(derived) => (derived.formula().name(), &[0, 1, 2, 3][..derived.formula().coordinates()]),
            other => (other.kind().name(), other.coordinates()),
        };
        let seen = |point: Vec<f64>| axes.iter().filter_map(|&axis| point.get(axis).copied()).collect();
        let truth = match self.finding.queries.as_slice() {
            [_] => self.finding.truth.chars().next().and_then(Sign::from_symbol),
            _ => None,
        };
        Some(Call { function, points: points.into_iter().map(seen).collect(), truth, query: query.to_string() })
    }

    /// The test in Rust.
    #[must_use]
    pub fn rust(&self) -> String {
        let mut text = format!("/// {}.\n#[test]\nfn {}() {{\n", self.what(), self.identifier());
        let calls = self.calls();
        for call in &calls {
            let _ = writeln!(text, "    // {}", call.query);
            let names: Vec<String> = call.points.iter().enumerate().map(|(at, _)| letter(at)).collect();
            for (name, point) in names.iter().zip(&call.points) {
                let bits: Vec<String> =
                    point.iter().map(|x| format!("f64::from_bits(0x{:016x})", x.to_bits())).collect();
                let _ = writeln!(text, "    let {name} = [{}]; // {point:?}", bits.join(", "));
            }
            let _ = writeln!(text, "    let sign = {}({});", call.function, names.join(", "));
            let assert = match call.truth {
                Some(Sign::Positive) => "    assert!(sign > 0.0);",
                Some(Sign::Negative) => "    assert!(sign < 0.0);",
                Some(Sign::Zero) => "    assert!(sign == 0.0);",
                None => "    println!(\"{sign:?}\"); // contradicts the other answers or the backend's promise",
            };
            let _ = writeln!(text, "{assert}");
        }
        if calls.is_empty() {
            let _ = writeln!(text, "    // `Mine` is your backend; the suite has the scene.");
            let _ = writeln!(text, "    predicament::conformance(Mine).only([{:?}]).assert();", self.suite);
        }
        text + "}\n"
    }

    /// The test in C++17.
    #[must_use]
    pub fn cpp(&self) -> String {
        let mut text = format!("// {}.\nvoid {}() {{\n", self.what(), self.identifier());
        let calls = self.calls();
        for call in &calls {
            let _ = writeln!(text, "    {{ // {}", call.query);
            let names: Vec<String> = call.points.iter().enumerate().map(|(at, _)| letter(at)).collect();
            for (name, point) in names.iter().zip(&call.points) {
                let _ = writeln!(text, "        const double {name}[] = {{{}}}; // {point:?}", hexes(point));
            }
            let _ = writeln!(text, "        const double sign = {}({});", call.function, names.join(", "));
            let _ = match truth(call) {
                Some(relation) => writeln!(text, "        assert(sign {relation} 0);"),
                None => writeln!(text, "        (void)sign; // contradicts the other answers or the backend's promise"),
            };
            let _ = writeln!(text, "    }}");
        }
        if calls.is_empty() {
            self.data(&mut text, "    ", &|name, rows, dimensions| {
                let brackets = "[]".to_owned() + dimensions;
                format!("const {} {name}{brackets} = {{{rows}}};", if name_is_data(name) { "double" } else { "int" })
            });
            let _ = writeln!(text, "    // {} of these", self.spelled.task);
            self.rest(&mut text, "    // ");
        }
        text + "}\n"
    }

    /// The test in Python.
    #[must_use]
    pub fn python(&self) -> String {
        let mut text = format!("# {}.\ndef test_{}():\n    h = float.fromhex\n", self.what(), self.identifier());
        let calls = self.calls();
        for call in &calls {
            let _ = writeln!(text, "    # {}", call.query);
            let names: Vec<String> = call.points.iter().enumerate().map(|(at, _)| letter(at)).collect();
            for (name, point) in names.iter().zip(&call.points) {
                let _ = writeln!(text, "    {name} = ({},)  # {point:?}", fromhexes(point));
            }
            let _ = writeln!(text, "    sign = {}({})", call.function, names.join(", "));
            let _ = match truth(call) {
                Some(relation) => writeln!(text, "    assert sign {relation} 0"),
                None => writeln!(text, "    print(sign)  # contradicts the other answers or the backend's promise"),
            };
        }
        if calls.is_empty() {
            let points = |rows: &[Vec<f64>]| -> String {
                let rows: Vec<String> = rows.iter().map(|row| format!("({},)", fromhexes(row))).collect();
                rows.join(", ")
            };
            let _ = writeln!(text, "    points = [{}]", points(&self.spelled.points));
            for list in &self.spelled.lists {
                let name = list.key.replace('.', "_");
                let _ = match &list.items {
                    Items::Rows(rows) => writeln!(text, "    {name} = [{}]", points(rows)),
                    Items::Polygons(polygons) => {
                        let ring = |ring: &Vec<Vec<f64>>| format!("[{}]", points(ring));
                        let polygon = |rings: &Vec<Vec<Vec<f64>>>| {
                            format!("[{}]", rings.iter().map(ring).collect::<Vec<_>>().join(", "))
                        };
                        writeln!(text, "    {name} = [{}]", polygons.iter().map(polygon).collect::<Vec<_>>().join(", "))
                    }
                    items => writeln!(text, "    {name} = {}", tuples(items, ['[', ']'], "\"")),
                };
            }
            let _ = writeln!(text, "    # {} of these", self.spelled.task);
            self.rest(&mut text, "    # ");
        }
        text
    }

    /// The test in JavaScript, for Node's `node --test`.
    #[must_use]
    pub fn javascript(&self) -> String {
        let head = "import assert from \"node:assert\";\nimport test from \"node:test\";\n";
        let mut text = format!("// {}.\n{head}\ntest(\"{}\", () => {{\n", self.what(), self.identifier());
        let calls = self.calls();
        for call in &calls {
            let _ = writeln!(text, "    {{\n        // {}", call.query);
            let names: Vec<String> = call.points.iter().enumerate().map(|(at, _)| letter(at)).collect();
            for (name, point) in names.iter().zip(&call.points) {
                let _ = writeln!(text, "        const {name} = {point:?};");
            }
            let _ = writeln!(text, "        const sign = {}({});", call.function, names.join(", "));
            let _ = match truth(call) {
                Some("==") => writeln!(text, "        assert.ok(sign === 0);"),
                Some(relation) => writeln!(text, "        assert.ok(sign {relation} 0);"),
                None => {
                    writeln!(
                        text,
                        "        console.log(sign); // contradicts the other answers or the backend's promise"
                    )
                }
            };
            text += "    }\n";
        }
        if calls.is_empty() {
            let _ = writeln!(text, "    const points = {:?};", self.spelled.points);
            for list in &self.spelled.lists {
                let name = list.key.replace('.', "_");
                let _ = match &list.items {
                    Items::Rows(rows) => writeln!(text, "    const {name} = {rows:?};"),
                    Items::Polygons(polygons) => writeln!(text, "    const {name} = {polygons:?};"),
                    items => writeln!(text, "    const {name} = {};", tuples(items, ['[', ']'], "\"")),
                };
            }
            let _ = writeln!(text, "    // {} of these", self.spelled.task);
            self.rest(&mut text, "    // ");
        }
        text + "});\n"
    }

    /// Writes the parts that are not lists of points or vertices as comments: options of the scene, and definitions of
    /// its constructed vertices.
    fn rest(&self, text: &mut String, comment: &str) {
        for (key, value) in &self.spelled.words {
            let _ = writeln!(text, "{comment}{key} = {value}");
        }
        for (at, construction) in self.spelled.constructions.iter().enumerate() {
            let _ = writeln!(text, "{comment}{} = {construction}", Vertex::constructed(at));
        }
    }

    /// Writes points and lists as declarations.
    fn data(&self, text: &mut String, indent: &str, declare: &dyn Fn(&str, &str, &str) -> String) {
        let rows = |rows: &[Vec<f64>]| {
            let rows: Vec<String> = rows.iter().map(|row| format!("{{{}}}", hexes(row))).collect();
            rows.join(", ")
        };
        let of = |rows: &[Vec<f64>]| format!("[{}]", rows.first().map_or(1, Vec::len));
        if !self.spelled.points.is_empty() {
            let points = &self.spelled.points;
            let _ = writeln!(text, "{indent}{}", declare("points", &rows(points), &of(points)));
        }
        let constructed = 0..self.spelled.constructions.len();
        if !constructed.is_empty() {
            let named = |at: usize| format!("{} = {}", Vertex::constructed(at), self.spelled.points.len() + at);
            let all: Vec<String> = constructed.map(named).collect();
            let _ = writeln!(text, "{indent}enum {{ {} }}; // constructed, after the points", all.join(", "));
        }
        for list in &self.spelled.lists {
            let name = list.key.replace('.', "_");
            match &list.items {
                Items::Rows(all) => {
                    let _ = writeln!(text, "{indent}{}", declare(&format!("{name}_data"), &rows(all), &of(all)));
                }
                Items::Polygons(polygons) => {
                    for (at, ring) in polygons.iter().flatten().enumerate() {
                        let name = format!("{name}_{at}_data");
                        let _ = writeln!(text, "{indent}{}", declare(&name, &rows(ring), &of(ring)));
                    }
                }
                items if items.is_empty() => {}
                items => {
                    let inner = tuples(items, ['{', '}'], "");
                    let inner = inner.trim_start_matches('{').trim_end_matches('}').to_owned();
                    let longest = (0..items.len()).map(|at| items.vertices(at).len()).max().unwrap_or(1);
                    let _ =
                        writeln!(text, "{indent}{}", declare(&name, &format!("{{{inner}}}"), &format!("[{longest}]")));
                }
            }
        }
    }
}

fn name_is_data(name: &str) -> bool {
    name == "points" || name.ends_with("_data")
}

fn truth(call: &Call) -> Option<&'static str> {
    call.truth.map(|sign| match sign {
        Sign::Positive => ">",
        Sign::Negative => "<",
        Sign::Zero => "==",
    })
}

fn letter(at: usize) -> String {
    ["a", "b", "c", "d", "e"].get(at).map_or_else(|| format!("p{at}"), |name| (*name).to_owned())
}

fn hexes(row: &[f64]) -> String {
    row.iter().map(|&x| hexfloat::format(x)).collect::<Vec<_>>().join(", ")
}

fn fromhexes(row: &[f64]) -> String {
    row.iter().map(|&x| format!("h(\"{}\")", hexfloat::format(x))).collect::<Vec<_>>().join(", ")
}

/// Lists of vertices as text; constructed vertices as their names between these quotes.
fn tuples(items: &Items, [open, close]: [char; 2], quote: &str) -> String {
    let name = |v: &Vertex| if v.is_constructed() { format!("{quote}{v}{quote}") } else { v.to_string() };
    let tuple = |at: usize| {
        let names: Vec<String> = items.vertices(at).iter().map(name).collect();
        format!("{open}{}{close}", names.join(", "))
    };
    let all: Vec<String> = (0..items.len()).map(tuple).collect();
    format!("{open}{}{close}", all.join(", "))
}

#[cfg(test)]
mod tests {
    use predicament_tasks::Class;

    use super::*;

    #[test]
    fn javascript_has_the_shortest_decimals_and_the_truth() {
        let spelled = Spelled { points: vec![vec![0.1, -0.0], vec![5e-324, 1e300]], ..Spelled::default() };
        let queries = vec!["orient2d(xy; 0 1 1)".parse().unwrap()];
        let finding = Finding::plain(Class::MissedZero, "sign", queries, "+".to_owned(), "0".to_owned());
        let subject = Subject { spelled: &spelled, finding: &finding, backend: "mine", name: "1", suite: "one.toml" };
        let text = subject.javascript();
        for part in [
            "test(\"scene_1\", () => {\n",
            "const a = [0.1, -0.0];\n",
            "const b = [5e-324, 1e300];\n",
            "const sign = orient2d(a, b, c);\n        assert.ok(sign === 0);\n",
        ] {
            assert!(text.contains(part), "{text}");
        }
        let whole = Finding { queries: Vec::new(), ..finding.clone() };
        let text = Subject { finding: &whole, ..subject }.javascript();
        assert!(text.contains("    const points = [[0.1, -0.0], [5e-324, 1e300]];\n"), "{text}");
    }

    #[test]
    fn a_point_in_python_is_a_tuple_even_of_one_number() {
        let spelled = Spelled { points: vec![vec![0.0, 1.0], vec![2.0, 1.0]], ..Spelled::default() };
        for (query, truth, points) in [
            ("compare(x; 0 1)", "-", ["    a = (h(\"0x0p+0\"),)  # [0.0]\n", "    b = (h(\"0x1p+1\"),)  # [2.0]\n"]),
            ("orient2d(xy; 0 1 1)", "0", ["    a = (h(\"0x0p+0\"), h(\"0x1p+0\"),)  # ", "    b = (h(\"0x1p+1\"), "]),
        ] {
            let queries = vec![query.parse().unwrap()];
            let finding = Finding::plain(Class::SignFlip, "sign", queries, "+".to_owned(), truth.to_owned());
            let subject =
                Subject { spelled: &spelled, finding: &finding, backend: "mine", name: "one", suite: "one.toml" };
            let text = subject.python();
            assert!(points.iter().all(|point| text.contains(point)), "{text}");
        }
    }
}
