//! Messages: a length, and a body of keys and values.

use std::io::{ErrorKind, Read, Write};
use std::ops::Range;

/// The maximum size of a message's body, in bytes.
const LONGEST: u32 = 1 << 30;

/// The byte ranges of a key and its value.
type Entry = (Range<usize>, Range<usize>);

/// A received message.
pub struct Message {
    body: Vec<u8>,
    entries: Vec<Entry>,
}

impl Message {
    /// Reads the next message; returns `None` if the input ends before its first byte.
    ///
    /// # Errors
    /// If the input is not a message of the protocol.
    pub fn read(input: &mut impl Read) -> Result<Option<Message>, String> {
        let failed = |error: std::io::Error| format!("stdin can't be read: {error}");
        let mut length = Vec::new();
        input.by_ref().take(4).read_to_end(&mut length).map_err(failed)?;
        let Ok(length) = <[u8; 4]>::try_from(length.as_slice()) else {
            let within = !length.is_empty();
            return if within { Err("stdin ends within the length of a message".to_owned()) } else { Ok(None) };
        };
        let size = u32::from_le_bytes(length);
        if size > LONGEST {
            return Err(format!("a message of {size} bytes; the longest has 2^30"));
        }
        let mut body = Vec::new();
        // Memory grows with the bytes that arrive.
        if input.by_ref().take(u64::from(size)).read_to_end(&mut body).map_err(failed)? < size as usize {
            return Err("stdin ends within a message".to_owned());
        }
        let entries = split(&body)?;
        Ok(Some(Message { body, entries }))
    }

    /// The value of a key.
    pub fn bytes(&self, key: &str) -> Option<&[u8]> {
        let found = self.entries.iter().find(|(name, _)| &self.body[name.clone()] == key.as_bytes());
        found.map(|(_, value)| &self.body[value.clone()])
    }

    /// The value of a key, as text.
    pub fn text(&self, key: &str) -> Option<String> {
        self.bytes(key).map(|value| String::from_utf8_lossy(value).into_owned())
    }

    /// The value of a required key.
    pub fn need(&self, key: &str) -> Result<&[u8], String> {
        self.bytes(key).ok_or_else(|| format!("a message `{}` without `{key}`", self.kind()))
    }

    /// The type of the message.
    pub fn kind(&self) -> String {
        self.text("type").unwrap_or_default()
    }
}

/// The byte ranges of a body's keys and values.
fn split(body: &[u8]) -> Result<Vec<Entry>, String> {
    let mut entries = Vec::new();
    let mut at = 0;
    while at < body.len() {
        let key = at + 1..at + 1 + usize::from(body[at]);
        let length = body.get(key.end..key.end + 4).and_then(|bytes| bytes.try_into().ok());
        let length = length.ok_or("a key runs over the end of its message")?;
        let value = key.end + 4..key.end + 4 + u32::from_le_bytes(length) as usize;
        if body.len() < value.end {
            return Err("a value runs over the end of its message".to_owned());
        }
        at = value.end;
        entries.push((key, value));
    }
    match entries.first() {
        Some((first, _)) if &body[first.clone()] == b"type" => Ok(entries),
        _ => Err("a message whose first key is not `type`".to_owned()),
    }
}

/// A message to send.
#[derive(PartialEq, Eq, Debug)]
pub struct Reply(Vec<u8>);

impl Reply {
    /// A message of this type.
    pub fn new(kind: &str) -> Reply {
        Reply(Vec::new()).with("type", kind)
    }

    /// Adds a key and its value to the message.
    pub fn with(mut self, key: &str, value: impl AsRef<[u8]>) -> Reply {
        let value = value.as_ref();
        // Keys are chosen by this crate, and values are shorter than the message that they answer.
        self.0.push(u8::try_from(key.len()).expect("a short key"));
        self.0.extend(key.as_bytes());
        self.0.extend(u32::try_from(value.len()).expect("a value of less than 4 GiB").to_le_bytes());
        self.0.extend(value);
        self
    }

    /// Writes the message.
    pub fn send(&self, output: &mut impl Write) -> Result<(), String> {
        let length = u32::try_from(self.0.len()).expect("a message of less than 4 GiB");
        let whole = [&length.to_le_bytes(), self.0.as_slice()].concat();
        let written = output.write_all(&whole).and_then(|()| output.flush());
        written.map_err(|error| match error.kind() {
            ErrorKind::BrokenPipe => "stdout was closed".to_owned(),
            _ => format!("stdout can't be written: {error}"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> Result<Option<Message>, String> {
        Message::read(&mut &*bytes)
    }

    fn why(bytes: &[u8]) -> String {
        read(bytes).err().expect("not the protocol")
    }

    #[test]
    fn what_is_sent_is_read() {
        let mut sent = Vec::new();
        Reply::new("hello").with("name", "a").with("points", [1, 2, 3]).send(&mut sent).unwrap();
        Reply::new("bye").send(&mut sent).unwrap();
        let mut input = &*sent;
        let first = Message::read(&mut input).unwrap().unwrap();
        assert_eq!(first.kind(), "hello");
        assert_eq!((first.text("name").as_deref(), first.bytes("points")), (Some("a"), Some(&[1, 2, 3][..])));
        assert_eq!(first.need("other"), Err("a message `hello` without `other`".to_owned()));
        assert_eq!(Message::read(&mut input).unwrap().unwrap().kind(), "bye");
        assert!(Message::read(&mut input).unwrap().is_none());
    }

    #[test]
    fn what_is_no_message_is_refused() {
        assert!(read(&[]).unwrap().is_none());
        assert_eq!(why(&[1, 0]), "stdin ends within the length of a message");
        assert_eq!(why(&[9, 0, 0, 0, 4]), "stdin ends within a message");
        assert_eq!(why(&[1, 0, 0, 64]), "a message of 1073741825 bytes; the longest has 2^30");
        assert_eq!(why(&[0, 0, 0, 0]), "a message whose first key is not `type`");
        assert_eq!(why(&[2, 0, 0, 0, 4, b't']), "a key runs over the end of its message");
        assert_eq!(why(&[6, 0, 0, 0, 1, b't', 9, 0, 0, 0]), "a value runs over the end of its message");
        assert_eq!(why(&[6, 0, 0, 0, 1, b't', 0, 0, 0, 0]), "a message whose first key is not `type`");
    }
}
