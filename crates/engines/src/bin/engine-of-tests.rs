//! An engine that answers by plain doubles, or goes wrong in the way that its argument names: for tests.

use std::io::{Write, stdin, stdout};

use predicament_engines::Message;

fn main() {
    let way = std::env::args().nth(1).unwrap_or_default();
    if way == "version" {
        println!("library 7.1");
        return;
    }
    let (mut input, mut output) = (stdin().lock(), stdout().lock());
    let (mut points, mut dimension) = (Vec::new(), 2);
    while let Ok(Some(message)) = Message::read(&mut input) {
        let kind = message.kind();
        if way == format!("crash on {kind}") {
            eprintln!("about to end\nthis is the reason");
            std::process::exit(3);
        }
        if way == format!("abort on {kind}") {
            std::process::abort();
        }
        if way == format!("silent on {kind}") {
            std::thread::sleep(std::time::Duration::from_secs(3600));
        }
        if way == format!("garbage on {kind}") {
            let _ = output.write_all(b"orient2d of 3 points is 1\n").and_then(|()| output.flush());
            continue;
        }
        let answer = match kind.as_str() {
            _ if way == format!("decline {kind}") => Message::new("declined").with("reason", "not today"),
            _ if way == format!("error on {kind}") => Message::new("error").with("message", "out of triangles"),
            "hello" => Message::new("hello")
                .with("protocol", if way == "old" { "0" } else { "1" })
                .with("name", if way == "long name" { "x".repeat(1 << 20) } else { "tests".to_owned() })
                .with("version", if way == "two lines" { "1.2\n\u{1b}[2J" } else { "1.2" })
                .with(
                    "predicates",
                    match way.as_str() {
                        "odd" => "orient2d sidedness".to_owned(),
                        "long predicate" => "x".repeat(1 << 20),
                        _ => "compare orient2d".to_owned(),
                    },
                )
                .with("zero", "exact")
                .with("precision", if way == "single" { "f32" } else { "f64" }),
            "scene" => {
                dimension = if message.text("dimension").as_deref() == Some("3") { 3 } else { 2 };
                let bytes = message.bytes("points").unwrap_or_default();
                points = bytes.as_chunks().0.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
                Message::new("ready").with("ns", "5")
            }
            _ => batch(&message, &points, dimension, &way),
        };
        let mut bytes = answer.encode().expect("a short message");
        if way == "twice" && kind == "batch" {
            bytes.extend_from_within(..);
        }
        if output.write_all(&bytes).and_then(|()| output.flush()).is_err() {
            return;
        }
    }
}

fn batch(message: &Message, points: &[f64], dimension: usize, way: &str) -> Message {
    let ids = message.bytes("ids").unwrap_or_default().as_chunks().0.iter().map(|&id| u32::from_le_bytes(id) as usize);
    let ids: Vec<usize> = ids.collect();
    let empty = message.bytes("empty").is_some();
    let at = |id: usize, axis: usize| points[id * dimension + axis];
    let mut signs: Vec<u8> = match message.text("predicate").as_deref() {
        Some("orient2d") => ids
            .as_chunks()
            .0
            .iter()
            .map(|&[a, b, c]| {
                let [a, b, c] = [a, b, c].map(|id| [at(id, 0), at(id, 1)]);
                byte((a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]))
            })
            .collect(),
        _ => ids.as_chunks().0.iter().map(|&[a, b]| byte(at(a, 0) - at(b, 0))).collect(),
    };
    match way {
        _ if empty => signs.fill(0),
        "short" => {
            eprintln!("one sign is missing");
            signs.truncate(signs.len() - 1);
        }
        "nan" => signs[0] = 3,
        "declines a query" => signs[0] = 2,
        "odd byte" => signs[0] = 9,
        _ => {}
    }
    if way == "long number" {
        return Message::new("signs").with("signs", signs).with("ns", "x".repeat(1 << 20));
    }
    let nanoseconds = match way {
        "slow clock" => "18446744073709551615",
        _ if empty => "10",
        _ => "1000",
    };
    Message::new("signs").with("signs", signs).with("ns", nanoseconds)
}

fn byte(x: f64) -> u8 {
    if x > 0.0 {
        1
    } else if x < 0.0 {
        255
    } else {
        0
    }
}
