//! An engine for tests that answers by plain doubles, or fails in the way that its argument names.
//!
//! It repeats the numbers of questions, unless its argument begins with `without id, `.

use std::io::{Error, Write, stdin, stdout};

use predicament_engines::{Bound, Message};

fn main() {
    let way = std::env::args().nth(1).unwrap_or_default();
    if way == "version" {
        println!("library 7.1");
        return;
    }
    if way == "fails" {
        eprintln!("for a reason");
        std::process::exit(3);
    }
    #[cfg(target_os = "linux")]
    if way.starts_with("left ") {
        return leave::play(&way);
    }
    let without_id = way.strip_prefix("without id, ");
    let (way, repeats) = (without_id.unwrap_or(&way), without_id.is_none());
    let mut before: Option<Vec<u8>> = None;
    let (mut input, mut output) = (stdin().lock(), stdout().lock());
    let (mut points, mut dimension) = (Vec::new(), 2);
    while let Ok(Some(message)) = Message::read(&mut input, Bound::QUESTION) {
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
        #[cfg(target_os = "linux")]
        if kind == "hello" && way.starts_with("leaves ") {
            leave::start(way);
        }
        let flood = match way {
            "many entries" => Some(b"\x01k\0\0\0\0".as_slice()),
            "long value" => Some([7; 1 << 16].as_slice()),
            _ => None,
        };
        if let Some(piece) = flood.filter(|_| kind == "batch") {
            let _ = pour(&mut output, piece);
            continue;
        }
        if way == "hungry" && kind == "batch" {
            // Uses up to a GiB.
            let food: Vec<Vec<u8>> = (0..64).map(|_| vec![1; 1 << 24]).collect();
            assert!(food.iter().all(|piece| piece[1 << 20] == 1));
        }
        #[cfg(target_os = "linux")]
        if way == "ends and leaves its pipe" && kind == "task" {
            leave::the_pipe();
            std::process::exit(0);
        }
        let answer = match kind.as_str() {
            _ if way == format!("decline {kind}") => Message::new("declined").with("reason", "not today"),
            "hello" if way == "one greeting" && before.replace(Vec::new()).is_some() => {
                Message::new("error").with("message", "was greeted before")
            }
            _ if way == format!("error on {kind}") => Message::new("error").with("message", "out of triangles"),
            "hello" => Message::new("hello")
                .with("protocol", if way == "old" { "0" } else { "1" })
                .with("name", if way == "long name" { "x".repeat(1 << 12) } else { "tests".to_owned() })
                .with("version", if way == "two lines" { "1.2\n\u{1b}[2J" } else { "1.2" })
                .with(
                    "predicates",
                    match way {
                        "odd" => "orient2d sidedness".to_owned(),
                        "long predicate" => "x".repeat(1 << 12),
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
            "task" => task(&message),
            _ => batch(&message, &points, dimension, way),
        };
        let id = message.text("id").filter(|_| repeats && (way != "forgets" || kind != "batch"));
        let answer = id.into_iter().fold(answer, |answer, id| answer.with("id", id));
        let many = if way == "crumbs" && kind == "batch" { 100 } else { 0 };
        let answer = (0..many).fold(answer, |answer, _| answer.with("crumb", ""));
        let mut bytes = answer.encode().expect("a short message");
        if way == "half an answer" && kind == "task" {
            let _ = output.write_all(&bytes[..bytes.len() / 2]).and_then(|()| output.flush());
            return;
        }
        if way == "twice" && kind == "batch" {
            bytes.extend_from_within(..);
        }
        if way == "again" && kind == "batch" {
            // Repeats the previous batch's answer, as late as possible.
            let late = before.replace(bytes.clone()).unwrap_or_default();
            bytes.splice(..0, late);
        }
        if output.write_all(&bytes).and_then(|()| output.flush()).is_err() {
            return;
        }
    }
}

/// Writes a message of nearly 2^30 bytes in pieces: entries without a value, or one long value.
fn pour(output: &mut impl Write, piece: &[u8]) -> Result<(), Error> {
    let many = piece.repeat((1 << 16) / piece.len());
    let times = (1 << 30) / many.len() - 1;
    let mut head = Message::new("signs").encode().map_err(Error::other)?.split_off(4);
    if piece.len() == 1 << 16 {
        head.extend(b"\x05signs");
        head.extend(u32::try_from(times * many.len()).map_err(Error::other)?.to_le_bytes());
    }
    output.write_all(&u32::try_from(head.len() + times * many.len()).map_err(Error::other)?.to_le_bytes())?;
    output.write_all(&head)?;
    (0..times).try_for_each(|_| output.write_all(&many))?;
    output.flush()
}

/// An answer whose body has as many bytes as the question wants, with the number of the question.
fn task(message: &Message) -> Message {
    let wanted: usize = message.text("word:wanted").and_then(|wanted| wanted.parse().ok()).unwrap_or(0);
    let answer = |zeros: usize| Message::new("answer").with("ns", "1").with("ids:triangles", vec![0; zeros]);
    let with_id = message.text("id").into_iter().fold(answer(0), |answer, id| answer.with("id", id));
    let empty = with_id.encode().expect("a short message").len() - 4;
    answer(wanted.saturating_sub(empty))
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
        return Message::new("signs").with("signs", signs).with("ns", "x".repeat(1 << 12));
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

/// Processes that the engine leaves behind: each writes its process id into the file named by the environment.
#[cfg(target_os = "linux")]
mod leave {
    use std::process::Command;
    use std::time::Duration;

    const FILE: &str = "LEFT_BEHIND";

    /// Starts a process in its own session, and waits until it has one: a child, a child without the engine's
    /// environment, or an orphan.
    pub fn start(way: &str) {
        let file = std::env::var_os(FILE).expect("a file for its number");
        let _ = match way {
            "leaves an orphan" => again("left to nobody").status().map(|_| ()),
            "leaves a stranger" => again("left alone").env_clear().env(FILE, &file).spawn().map(|_| ()),
            _ => again("left alone").spawn().map(|_| ()),
        };
        while !std::fs::read(&file).is_ok_and(|text| text.ends_with(b"\n")) {
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Starts a process that keeps the engine's stdout.
    pub fn the_pipe() {
        let _ = again("left alone").spawn();
    }

    /// Runs one of the roles of the processes that are left behind.
    pub fn play(part: &str) {
        if part == "left to nobody" {
            let _ = again("left alone").spawn();
            return;
        }
        let _ = rustix::process::setsid();
        if let Some(file) = std::env::var_os(FILE) {
            let _ = std::fs::write(file, format!("{}\n", std::process::id()));
        }
        std::thread::sleep(Duration::from_secs(3600));
    }

    fn again(part: &str) -> Command {
        let mut command = Command::new(std::env::current_exe().expect("this program"));
        command.arg(part).stdin(std::process::Stdio::null());
        command
    }
}
