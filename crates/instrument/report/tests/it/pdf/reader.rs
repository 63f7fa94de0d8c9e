//! A minimal reader of PDF, written from ISO 32000 alone, without knowledge of the writer.

use std::collections::BTreeMap;
use std::io::Read as _;

use flate2::read::ZlibDecoder;

/// A value, or a word between values: an operator, `obj`, `endobj`.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    Number(f64),
    Name(String),
    Text(Vec<u8>),
    Array(Vec<Value>),
    Dictionary(BTreeMap<String, Value>),
    Reference(usize),
    Word(String),
}

impl Value {
    pub fn number(&self) -> f64 {
        let Value::Number(x) = self else { panic!("a number: {self:?}") };
        *x
    }

    pub fn name(&self) -> &str {
        let Value::Name(name) = self else { panic!("a name: {self:?}") };
        name
    }

    pub fn array(&self) -> &[Value] {
        let Value::Array(values) = self else { panic!("an array: {self:?}") };
        values
    }

    pub fn dictionary(&self) -> &BTreeMap<String, Value> {
        let Value::Dictionary(entries) = self else { panic!("a dictionary: {self:?}") };
        entries
    }
}

/// A file, read from its end to the table of its objects, as PDF readers do.
pub struct File<'b> {
    bytes: &'b [u8],
    trailer: BTreeMap<String, Value>,
    /// The starts of the objects.
    places: BTreeMap<usize, usize>,
}

impl File<'_> {
    pub fn open(bytes: &[u8]) -> File<'_> {
        assert!(bytes.starts_with(b"%PDF-1.4\n") && bytes.ends_with(b"%%EOF"), "the ends of a file");
        let table = find(bytes, b"startxref");
        let start = whole(&values(&bytes[table + 9..bytes.len() - 5])[0]);
        let text = std::str::from_utf8(&bytes[start..table]).unwrap();
        let (entries, trailer) = text.split_once("trailer").unwrap();
        let mut lines = entries.lines();
        assert_eq!(lines.next(), Some("xref"));
        let count: usize = lines.next().unwrap().strip_prefix("0 ").unwrap().parse().unwrap();
        // Each entry has 20 bytes.
        assert!(entries.split_inclusive('\n').skip(2).all(|line| line.len() == 20 || line == "\n"), "{entries:?}");
        let used = lines.take(count).enumerate().filter(|(_, line)| line.contains(" n"));
        let places = used.map(|(number, line)| (number, line[..10].parse().unwrap())).collect();
        File { bytes, trailer: values(trailer.as_bytes())[0].dictionary().clone(), places }
    }

    /// The value that a reference stands for.
    pub fn get(&self, value: &Value) -> Value {
        let Value::Reference(number) = value else { return value.clone() };
        self.object(*number).0
    }

    /// An object, and the bytes after it.
    fn object(&self, number: usize) -> (Value, &[u8]) {
        let from = &self.bytes[self.places[&number]..];
        let head = format!("{number} 0 obj\n");
        assert!(from.starts_with(head.as_bytes()), "object {number} begins where the table says");
        let mut cursor = Cursor(&from[head.len()..]);
        (cursor.next(), cursor.0)
    }

    /// The only page.
    pub fn page(&self) -> BTreeMap<String, Value> {
        let pages = self.get(&self.get(&self.trailer["Root"]).dictionary()["Pages"]);
        assert_eq!(pages.dictionary()["Count"], Value::Number(1.0));
        self.get(&pages.dictionary()["Kids"].array()[0]).dictionary().clone()
    }

    /// The operators of a page with their operands.
    pub fn operations(&self, page: &BTreeMap<String, Value>) -> Vec<(String, Vec<Value>)> {
        let Value::Reference(number) = page["Contents"] else { panic!("a stream is an object of its own") };
        let (entries, rest) = self.object(number);
        assert_eq!(entries.dictionary()["Filter"].name(), "FlateDecode");
        let length = whole(&entries.dictionary()["Length"]);
        let packed = &rest[find(rest, b"stream\n") + 7..][..length];
        let mut content = Vec::new();
        ZlibDecoder::new(packed).read_to_end(&mut content).unwrap();
        let (mut operations, mut operands) = (Vec::new(), Vec::new());
        for value in values(&content) {
            match value {
                Value::Word(operator) => operations.push((operator, std::mem::take(&mut operands))),
                operand => operands.push(operand),
            }
        }
        assert_eq!(operands, [], "every operand has its operator");
        operations
    }
}

/// The position of the first occurrence of these bytes.
fn find(bytes: &[u8], what: &[u8]) -> usize {
    bytes.windows(what.len()).position(|window| window == what).unwrap()
}

fn whole(value: &Value) -> usize {
    value.number().to_string().parse().unwrap()
}

fn values(bytes: &[u8]) -> Vec<Value> {
    Cursor(bytes).until(b"")
}

/// The unread bytes.
struct Cursor<'b>(&'b [u8]);

impl Cursor<'_> {
    /// All values before this end, which is skipped.
    fn until(&mut self, end: &[u8]) -> Vec<Value> {
        let mut all = Vec::new();
        loop {
            self.0 = self.0.trim_ascii_start();
            if self.0.is_empty() || !end.is_empty() && self.0.starts_with(end) {
                self.0 = &self.0[end.len()..];
                return all;
            }
            all.push(self.next());
            // Two numbers and an R form a reference.
            if let [.., number, Value::Number(_), Value::Word(word)] = &all[..]
                && word == "R"
            {
                let number = whole(number);
                all.truncate(all.len() - 3);
                all.push(Value::Reference(number));
            }
        }
    }

    fn next(&mut self) -> Value {
        let all = self.0.trim_ascii_start();
        match all {
            [b'<', b'<', rest @ ..] => {
                self.0 = rest;
                let entries = self.until(b">>");
                Value::Dictionary(entries.chunks(2).map(|pair| (pair[0].name().to_owned(), pair[1].clone())).collect())
            }
            [b'[', rest @ ..] => {
                self.0 = rest;
                Value::Array(self.until(b"]"))
            }
            [b'(', rest @ ..] => {
                self.0 = rest;
                Value::Text(self.text())
            }
            [b'<', rest @ ..] => {
                let end = find(rest, b">");
                self.0 = &rest[end + 1..];
                let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).unwrap(), 16).unwrap();
                Value::Text(rest[..end].chunks(2).map(byte).collect())
            }
            [b'/', rest @ ..] => {
                self.0 = rest;
                Value::Name(self.word())
            }
            all => {
                self.0 = all;
                let word = self.word();
                word.parse().map_or_else(|_| Value::Word(word), Value::Number)
            }
        }
    }

    /// Letters up to a separator of words.
    fn word(&mut self) -> String {
        let is_end = |byte: &u8| byte.is_ascii_whitespace() || b"()<>[]/".contains(byte);
        let end = self.0.iter().position(is_end).unwrap_or(self.0.len());
        let (word, rest) = self.0.split_at(end);
        self.0 = rest;
        String::from_utf8(word.to_vec()).unwrap()
    }

    /// Text up to the closing bracket.
    fn text(&mut self) -> Vec<u8> {
        let (mut text, mut open) = (Vec::new(), 1);
        while let [first, rest @ ..] = self.0 {
            self.0 = rest;
            match first {
                b'\\' => {
                    assert!(b"()\\".contains(&rest[0]), "no other escape is known here");
                    text.push(rest[0]);
                    self.0 = &rest[1..];
                    continue;
                }
                b'(' => open += 1,
                b')' => open -= 1,
                _ => {}
            }
            if open == 0 {
                break;
            }
            text.push(*first);
        }
        text
    }
}
