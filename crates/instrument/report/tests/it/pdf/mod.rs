//! Plots as PDF, read back by a separate reader and compared with their SVG.

mod reader;

use predicament_report::{Bar, Bars, Curve, Curves, Picture, curves, histogram, ranges};
use reader::{File, Value};

/// A plot of each kind that does not need a run.
fn plots() -> [Picture; 3] {
    let curve = |name: &str, points: &[(f64, f64)]| Curve::new(name, points);
    let lines = Curves {
        x: "angle (between edges), \\ and /".into(),
        y: "error".into(),
        curves: vec![
            curve("exact", &[(1e-2, 1e-5), (0.1, 1e-4), (0.2, 2e-3)]),
            curve("sos", &[(1e-2, 0.5), (1.0, 0.1)]),
        ],
        ..Curves::default()
    };
    let bars = Bars {
        x: "place".into(),
        y: "count".into(),
        places: vec!["first".into(), "second".into()],
        series: vec![("one".into(), vec![10.0, 0.0]), ("two".into(), vec![1.0, 200.0])],
    };
    let bar = |name: &str, to| Bar { name: name.into(), backend: "tolerance".into(), from: Some(1e-8), to };
    let sizes = [bar("2D gap (τ)", Some(1e-6)), bar("3D gap ≤ ½ × σ", None), bar("a tip 日", Some(1e-3))];
    [
        curves(&lines).unwrap().unwrap(),
        histogram(&bars).unwrap().unwrap(),
        ranges(&sizes, "size over L", [-9, 0]).unwrap(),
    ]
}

/// An element of an SVG with the text in it.
struct Element<'s> {
    attributes: &'s str,
    text: &'s str,
}

impl Element<'_> {
    fn of<'s>(svg: &'s str, name: &str) -> Vec<Element<'s>> {
        let open = format!("<{name}");
        let parts = svg.split(open.as_str()).skip(1);
        parts
            .map(|part| {
                let (attributes, rest) = part.split_once('>').unwrap();
                Element { attributes, text: rest.split('<').next().unwrap().trim_matches('\n') }
            })
            .collect()
    }

    fn get(&self, key: &str) -> &str {
        let (_, rest) = self.attributes.split_once(&format!(" {key}=\"")).unwrap();
        rest.split('"').next().unwrap()
    }

    fn number(&self, key: &str) -> f64 {
        self.get(key).parse().unwrap()
    }
}

/// Nonempty texts: some ticks have no name.
fn named(svg: &str) -> Vec<Element<'_>> {
    Element::of(svg, "text").into_iter().filter(|text| !text.text.is_empty()).collect()
}

/// Text on a page: its start, its direction, its size, and its codes font by font.
struct Text {
    matrix: Vec<f64>,
    size: f64,
    runs: Vec<(String, Vec<u8>)>,
}

impl Text {
    /// The text with Latin letters unchanged, and the few used letters of Symbol.
    fn letters(&self) -> String {
        let letter = |font: &str, code: u8| match (font, code) {
            ("Symbol", b't') => 'τ',
            ("Symbol", b's') => 'σ',
            ("Symbol", 0xa3) => '≤',
            ("Symbol", _) => panic!("{code} of Symbol"),
            _ => char::from(code),
        };
        self.runs.iter().flat_map(|(font, codes)| codes.iter().map(move |&code| letter(font, code))).collect()
    }
}

struct Page {
    size: [f64; 2],
    operations: Vec<(String, Vec<Value>)>,
    texts: Vec<Text>,
    opacities: Vec<f64>,
}

impl Page {
    fn of(bytes: &[u8]) -> Page {
        let file = File::open(bytes);
        let page = file.page();
        let resources = page["Resources"].dictionary();
        let font = |name: &Value| {
            let font = file.get(&resources["Font"].dictionary()[name.name()]).dictionary().clone();
            assert_eq!(font["Subtype"].name(), "Type1");
            let base = font["BaseFont"].name().to_owned();
            let encoding = font.get("Encoding").map(Value::name);
            assert_eq!(encoding, (base != "Symbol").then_some("WinAnsiEncoding"));
            base
        };
        let operations = file.operations(&page);
        let (mut texts, mut current, mut is_open) = (Vec::<Text>::new(), String::new(), false);
        for (operator, operands) in &operations {
            match operator.as_str() {
                "BT" => texts.push(Text { matrix: Vec::new(), size: 0.0, runs: Vec::new() }),
                "Tm" => texts.last_mut().unwrap().matrix = operands.iter().map(Value::number).collect(),
                "Tf" => {
                    current = font(&operands[0]);
                    texts.last_mut().unwrap().size = operands[1].number();
                }
                "Tj" => {
                    let Value::Text(codes) = &operands[0] else { panic!("text") };
                    assert!(is_open);
                    texts.last_mut().unwrap().runs.push((current.clone(), codes.clone()));
                }
                _ => {}
            }
            is_open = operator == "BT" || is_open && operator != "ET";
        }
        let states = resources["ExtGState"].dictionary().values().map(|state| {
            let [line, fill] = ["CA", "ca"].map(|key| state.dictionary()[key].number());
            assert_eq!(line.to_bits(), fill.to_bits());
            fill
        });
        let opacities = states.collect();
        let media: Vec<f64> = page["MediaBox"].array().iter().map(Value::number).collect();
        assert_eq!(media[..2], [0.0, 0.0]);
        Page { size: [media[2], media[3]], operations, texts, opacities }
    }

    fn count(&self, operators: &[&str]) -> usize {
        self.operations.iter().filter(|(operator, _)| operators.contains(&operator.as_str())).count()
    }
}

#[test]
fn a_pdf_has_what_its_svg_has() {
    for Picture { svg, pdf } in plots() {
        let page = Page::of(&pdf.unwrap());
        let all = |name: &str| Element::of(&svg, name);
        let root = &all("svg")[0];
        assert_eq!(page.size, [root.number("width"), root.number("height")]);
        let flip = [1.0, 0.0, 0.0, -1.0, 0.0, page.size[1]].map(Value::Number).to_vec();
        assert_eq!(page.operations[0], ("cm".to_owned(), flip), "coordinates are those of the SVG");

        let expected: Vec<String> = named(&svg).iter().map(|text| text.text.replace('日', "?")).collect();
        assert_eq!(page.texts.iter().map(Text::letters).collect::<Vec<_>>(), expected);
        let [lines, circles] = [all("line").len() + all("polyline").len(), all("circle").len()];
        assert_eq!(page.count(&["re"]), all("rect").len());
        assert_eq!(page.count(&["c"]), 4 * circles, "a quarter of a circle each");
        assert_eq!(page.count(&["m"]), lines + circles + all("polygon").len());
        let painted = page.count(&["S", "f"]);
        assert_eq!(painted, lines + circles + all("rect").len() + all("polygon").len());

        let mut seen: Vec<f64> = svg
            .split(" opacity=\"")
            .skip(1)
            .map(|x| x.split('"').next().unwrap())
            .map(|x| x.parse().unwrap())
            .collect();
        seen.sort_by(f64::total_cmp);
        seen.dedup();
        let mut opacities = page.opacities;
        opacities.sort_by(f64::total_cmp);
        assert_eq!(opacities, seen);
    }
}

#[test]
fn points_and_colours_are_those_of_the_svg() {
    let [Picture { svg, pdf }, ..] = plots();
    let page = Page::of(&pdf.unwrap());
    let circles = Element::of(&svg, "circle");
    let numbers = |operation: &(String, Vec<Value>)| operation.1.iter().map(Value::number).collect::<Vec<_>>();
    let mut curves = page.operations.windows(5).filter(|operations| operations[0].0 == "m" && operations[1].0 == "c");
    for circle in &circles {
        let operations: Vec<Vec<f64>> = curves.next().unwrap().iter().map(numbers).collect();
        let [x, y, r] = ["cx", "cy", "r"].map(|key| circle.number(key));
        assert_eq!(operations[0], [x + r, y]);
        for pair in operations.windows(2) {
            let (start, curve) = (&pair[0][pair[0].len() - 2..], &pair[1]);
            // The middle of a Bézier curve that is a quarter turn long.
            let middle = |axis: usize| (start[axis] + 3.0 * (curve[axis] + curve[axis + 2]) + curve[axis + 4]) / 8.0;
            assert!(((middle(0) - x).hypot(middle(1) - y) - r).abs() < 1e-3 * r, "{operations:?}");
            let ends = [[start[0] - x, start[1] - y], [curve[4] - x, curve[5] - y]];
            assert!(((ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]) - r * r).abs() < 1e-3, "{operations:?}");
        }
    }
    assert!(curves.next().is_none() && !circles.is_empty());
    let colours: Vec<Vec<f64>> = page
        .operations
        .iter()
        .filter(|(operator, _)| operator == "rg")
        .map(|(_, parts)| parts.iter().map(|part| (part.number() * 255.0).round()).collect())
        .collect();
    // The ink of the page around the SVG is nearly black on paper; the first curve is blue.
    assert!(colours.contains(&vec![34.0; 3]) && colours.contains(&vec![46.0, 134.0, 204.0]), "{colours:?}");
    assert!(!colours.contains(&vec![1.0, 2.0, 3.0]));
}

/// Digits are 0.556 wide in Helvetica, an x is 0.523 high.
#[test]
fn text_is_anchored_as_in_the_svg() {
    let mut anchors = Vec::new();
    for Picture { svg, pdf } in plots() {
        let page = Page::of(&pdf.unwrap());
        for (text, element) in page.texts.iter().zip(named(&svg)) {
            assert!((text.size - element.number("font-size")).abs() < 1e-5);
            let width: f64 = match element.text {
                digits if digits.bytes().all(|byte| byte.is_ascii_digit()) => digits.bytes().map(|_| 0.556).sum(),
                // 2, D, a blank, g, a, p, a blank, a bracket, τ in Symbol, a bracket.
                "2D gap (τ)" => 0.556 + 0.722 + 0.278 + 3.0 * 0.556 + 0.278 + 0.333 + 0.439 + 0.333,
                "count" => 0.5 + 0.556 + 0.556 + 0.556 + 0.278,
                _ => continue,
            };
            let (is_upright, anchor) = (!element.attributes.contains("transform"), element.get("text-anchor"));
            let [along, down] = [
                match anchor {
                    "start" => 0.0,
                    "middle" => width / 2.0,
                    _ => width,
                },
                match element.get("dy") {
                    "0.76em" => 0.76,
                    "0.5ex" => 0.2615,
                    "-0.5ex" => -0.2615,
                    other => panic!("{other}"),
                },
            ];
            let (direction, start) = text.matrix.split_at(4);
            // Back from the start of the baseline to the anchor; in upward text, a point below the anchor is on its
            // right.
            let (dx, dy) = if is_upright { (along, -down) } else { (-down, -along) };
            assert_eq!(direction, if is_upright { [1.0, 0.0, 0.0, -1.0] } else { [0.0, -1.0, -1.0, 0.0] });
            assert!(is_upright || element.get("transform").starts_with("rotate(270"));
            let off =
                [start[0] + text.size * dx - element.number("x"), start[1] + text.size * dy - element.number("y")];
            assert!(off.iter().all(|off| off.abs() < 1e-3), "{}: {off:?}", element.text);
            anchors.push((anchor.to_owned(), is_upright));
        }
    }
    for kind in [("end", true), ("middle", true), ("middle", false)] {
        let expected = (kind.0.to_owned(), kind.1);
        assert!(anchors.contains(&expected), "{kind:?} is tried: {anchors:?}");
    }
}

#[test]
fn the_same_plot_gives_the_same_bytes() {
    assert_eq!(plots(), plots());
}
