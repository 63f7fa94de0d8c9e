//! Messages of the protocol: a length, then keys and values.

use std::io::{Error, ErrorKind, Read};

use crate::ProtocolError;

/// The maximum size of a message's body, in bytes.
pub const MOST_BYTES: u32 = 1 << 30;
/// The maximum number of entries of a message; messages of the protocol have up to eight.
pub const MOST_ENTRIES: usize = 64;
/// The maximum size of an answer without its signs, in bytes.
pub const MOST_TEXT: u32 = 1 << 16;

/// The maximum size of the next message's body. Messages have at most [`MOST_ENTRIES`] entries.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bound(u32);

impl Bound {
    /// The bound for messages that the tool sends.
    pub const QUESTION: Bound = Bound(MOST_BYTES);

    /// The bound for an answer to a task whose scene has this number of bytes. The overlay of n edges can have n²
    /// crossings, and a triangulation has fewer bytes than its points: 256 times the scene and 16 MiB leave room for
    /// both, and an answer out of all proportion is refused before it takes memory.
    #[must_use]
    pub fn task(scene: usize) -> Bound {
        let bytes = u32::try_from(scene).unwrap_or(MOST_BYTES).saturating_mul(256).saturating_add(1 << 24);
        Bound(bytes.min(MOST_BYTES))
    }

    /// The bound for an answer with this number of signs: a byte each, and [`MOST_TEXT`] for everything else.
    #[must_use]
    pub fn answer(signs: usize) -> Bound {
        Bound(u32::try_from(signs).unwrap_or(MOST_BYTES).saturating_add(MOST_TEXT).min(MOST_BYTES))
    }
}

/// A message: keys and values; the first value is the message's type.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Message {
    entries: Vec<(String, Vec<u8>)>,
}

impl Message {
    /// A message of this type.
    #[must_use]
    pub fn new(kind: &str) -> Message {
        Message { entries: vec![("type".to_owned(), kind.as_bytes().to_vec())] }
    }

    /// Adds an entry to the message.
    #[must_use]
    pub fn with(mut self, key: &str, value: impl Into<Vec<u8>>) -> Message {
        self.entries.push((key.to_owned(), value.into()));
        self
    }

    /// The number of bytes of all values.
    #[must_use]
    pub fn size(&self) -> usize {
        self.entries.iter().map(|(_, value)| value.len()).sum()
    }

    /// All keys with their values; the first is the type.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.entries()
    }

    /// The value of a key as bytes; `None` if the message lacks it.
    #[must_use]
    pub fn bytes(&self, key: &str) -> Option<&[u8]> {
        self.entries.iter().find(|(of, _)| of == key).map(|(_, value)| value.as_slice())
    }

    /// The value of a key as text, with invalid UTF-8 replaced; `None` if the message lacks it.
    #[must_use]
    pub fn text(&self, key: &str) -> Option<String> {
        self.bytes(key).map(|value| String::from_utf8_lossy(value).into_owned())
    }

    /// The value of a key as text.
    ///
    /// # Errors
    /// [`ProtocolError`] with the message and the key.
    pub fn required(&self, key: &str) -> Result<String, ProtocolError> {
        self.text(key).ok_or_else(|| ProtocolError::Missing { message: self.kind(), key: key.to_owned() })
    }

    /// The value of a key as a decimal integer.
    ///
    /// # Errors
    /// [`ProtocolError`] with the message and the key.
    pub fn number(&self, key: &str) -> Result<u64, ProtocolError> {
        let text = self.required(key)?;
        let number = text.trim().parse();
        number.map_err(|_| ProtocolError::NotANumber { message: self.kind(), key: key.to_owned(), text })
    }

    /// The type of the message, the value of its first key.
    #[must_use]
    pub fn kind(&self) -> String {
        self.text("type").unwrap_or_default()
    }

    /// The bytes to send, length first.
    ///
    /// # Errors
    /// If a key has more than 255 bytes, or the body has more than [`MOST_BYTES`].
    pub fn encode(&self) -> Result<Vec<u8>, ProtocolError> {
        encode_within(MOST_BYTES, self.entries())
    }

    /// The bytes to send, with the number of the question as the last entry. This avoids a copy of the message.
    ///
    /// # Errors
    /// If a key has more than 255 bytes, or the body has more than [`MOST_BYTES`].
    pub fn encode_as(&self, id: u64) -> Result<Vec<u8>, ProtocolError> {
        let id = id.to_string();
        encode_within(MOST_BYTES, self.entries().chain([("id", id.as_bytes())]))
    }

    fn entries(&self) -> impl Iterator<Item = (&str, &[u8])> + Clone {
        self.entries.iter().map(|(key, value)| (key.as_str(), value.as_slice()))
    }

    /// Reads one message; returns `None` at the end of the stream.
    ///
    /// A message that is longer than its bound is refused before its body is read. A message with more entries than
    /// [`MOST_ENTRIES`] is refused before they are copied.
    ///
    /// # Errors
    /// The reader's own error, or [`ErrorKind::InvalidData`] if the bytes are not a message or exceed the bound.
    pub fn read(from: &mut impl Read, Bound(most): Bound) -> Result<Option<Message>, Error> {
        let mut length = [0; 4];
        if !read_or_end(from, &mut length)? {
            return Ok(None);
        }
        let size = u32::from_le_bytes(length);
        if size > most {
            return Err(invalid(too_long(length, most)));
        }
        // The claimed length is not trusted: memory grows with the bytes received.
        let mut body = Vec::new();
        from.take(u64::from(size)).read_to_end(&mut body)?;
        if body.len() < size as usize {
            return Err(invalid(ProtocolError::EndsInBody { have: body.len(), size }));
        }
        Message::decode(&body).map(Some).map_err(invalid)
    }

    fn decode(body: &[u8]) -> Result<Message, ProtocolError> {
        let entries = split(body)?.into_iter().map(|(key, value)| (key.to_owned(), value.to_vec())).collect();
        Ok(Message { entries })
    }
}

/// Splits a body into keys and values, at most [`MOST_ENTRIES`]; the first entry is the type.
fn split(mut body: &[u8]) -> Result<Vec<(&str, &[u8])>, ProtocolError> {
    let cut = || ProtocolError::CutOff;
    let mut entries: Vec<(&str, &[u8])> = Vec::new();
    while let Some((&length, rest)) = body.split_first() {
        if entries.len() == MOST_ENTRIES {
            return Err(ProtocolError::TooManyEntries);
        }
        let (key, rest) = rest.split_at_checked(usize::from(length)).ok_or_else(cut)?;
        let key = std::str::from_utf8(key).ok().filter(|key| key.is_ascii() && !key.is_empty());
        let key = key.ok_or(ProtocolError::BadKey)?;
        let (length, rest) = rest.split_first_chunk::<4>().ok_or_else(cut)?;
        let (value, rest) = rest.split_at_checked(u32::from_le_bytes(*length) as usize).ok_or_else(cut)?;
        entries.push((key, value));
        body = rest;
    }
    match entries.first() {
        Some(("type", _)) => Ok(entries),
        _ => Err(ProtocolError::NoType),
    }
}

/// The error for a length above its bound: usually it is text that was printed to stdout.
fn too_long(length: [u8; 4], most: u32) -> ProtocolError {
    let size = u32::from_le_bytes(length);
    if size > MOST_BYTES || length.iter().all(|byte| byte.is_ascii_graphic() || byte.is_ascii_whitespace()) {
        return ProtocolError::NotALength(length);
    }
    ProtocolError::TooLong { size, most }
}

fn encode_within<'m>(
    most: u32,
    entries: impl Iterator<Item = (&'m str, &'m [u8])> + Clone,
) -> Result<Vec<u8>, ProtocolError> {
    let size: usize = entries.clone().map(|(key, value)| 1 + key.len() + 4 + value.len()).sum();
    let length = u32::try_from(size).ok().filter(|&length| length <= most);
    let length = length.ok_or(ProtocolError::TooLongToSend { size, most })?;
    let mut bytes = Vec::with_capacity(4 + size);
    bytes.extend(length.to_le_bytes());
    for (key, value) in entries {
        bytes.push(u8::try_from(key.len()).map_err(|_| ProtocolError::LongKey(key.to_owned()))?);
        bytes.extend(key.as_bytes());
        let length = u32::try_from(value.len()).expect("shorter than the body, which fits");
        bytes.extend(length.to_le_bytes());
        bytes.extend(value);
    }
    Ok(bytes)
}

/// Fills the buffer; returns false if the stream ends before its first byte.
fn read_or_end(from: &mut impl Read, buffer: &mut [u8]) -> Result<bool, Error> {
    let mut have = 0;
    while have < buffer.len() {
        match from.read(&mut buffer[have..]) {
            Ok(0) if have == 0 => return Ok(false),
            Ok(0) => return Err(invalid(ProtocolError::EndsInLength(have))),
            Ok(more) => have += more,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(true)
}

fn invalid(error: ProtocolError) -> Error {
    Error::new(ErrorKind::InvalidData, error)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(mut bytes: &[u8]) -> Result<Option<Message>, String> {
        Message::read(&mut bytes, Bound::QUESTION).map_err(|error| error.to_string())
    }

    #[test]
    fn messages_round_trip() {
        let message = Message::new("batch").with("ids", [1, 0, 0, 0]).with("ns", "17").with("empty", "");
        let bytes = message.encode().unwrap();
        assert_eq!(bytes.len(), 4 + (1 + 4 + 4 + 5) + (1 + 3 + 4 + 4) + (1 + 2 + 4 + 2) + (1 + 5 + 4));
        assert_eq!(read(&bytes), Ok(Some(message.clone())));
        assert_eq!(message.number("ns"), Ok(17));
        let missing = ProtocolError::Missing { message: "batch".to_owned(), key: "nss".to_owned() };
        assert_eq!(missing.to_string(), "a message `batch` without `nss`");
        assert_eq!(message.number("nss"), Err(missing));
        assert_eq!(read(&[]), Ok(None));
        for cut in 1..bytes.len() {
            assert!(read(&bytes[..cut]).is_err(), "{cut}");
        }
    }

    #[test]
    fn what_is_sent_is_bounded() {
        let message = Message::new("batch").with("ids", [1, 0, 0, 0]);
        let body = u32::try_from(message.encode().unwrap().len()).unwrap() - 4;
        assert_eq!(encode_within(body, message.entries()), message.encode());
        let (size, most) = (body as usize, body - 1);
        assert_eq!(encode_within(most, message.entries()), Err(ProtocolError::TooLongToSend { size, most }));
        let long = Message::new("batch").with(&"k".repeat(256), "");
        assert!(long.encode().unwrap_err().to_string().ends_with("is too long"));
    }

    #[test]
    fn the_number_of_a_question_is_its_last_entry() {
        let message = Message::new("batch").with("ids", [1, 0, 0, 0]);
        assert_eq!(message.encode_as(17), message.clone().with("id", "17").encode());
    }

    /// A reader that counts the bytes read from it.
    struct Counted<'b>(&'b [u8], usize);

    impl Read for Counted<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Error> {
            let read = self.0.read(buffer)?;
            self.1 += read;
            Ok(read)
        }
    }

    #[test]
    fn a_body_past_its_bound_is_not_read() {
        let most = Bound::answer(7).0;
        assert_eq!(most, MOST_TEXT + 7);
        assert_eq!(Bound::answer(usize::MAX), Bound::QUESTION);
        let empty = Message::new("signs").with("signs", "").encode().unwrap().len() - 4;
        for (over, fits) in [(0, true), (1, false)] {
            let signs = vec![0; most as usize - empty + over];
            let bytes = Message::new("signs").with("signs", signs).encode().unwrap();
            let mut from = Counted(&bytes, 0);
            let read = Message::read(&mut from, Bound::answer(7)).map_err(|error| error.to_string());
            let said = format!("an answer of {} bytes; at most {most} are allowed", most + 1);
            assert_eq!((read.is_ok(), from.1), (fits, if fits { bytes.len() } else { 4 }));
            assert!(fits || read == Err(said));
        }
        // Read as a length, digits are below 2^30.
        let read = Message::read(&mut b"0.25\n".as_slice(), Bound::answer(7)).map_err(|error| error.to_string());
        assert_eq!(
            read,
            Err("no message: it begins with the bytes `0.25`; an engine prints to stderr, not to stdout".to_owned())
        );
    }

    #[test]
    fn entries_are_counted_before_they_are_kept() {
        let with = |entries: usize| (1..entries).fold(Message::new("ready"), |message, _| message.with("k", ""));
        assert_eq!(read(&with(MOST_ENTRIES).encode().unwrap()), Ok(Some(with(MOST_ENTRIES))));
        let said = "a message of more than 64 entries".to_owned();
        assert_eq!(read(&with(MOST_ENTRIES + 1).encode().unwrap()), Err(said));
    }

    #[test]
    fn garbage_is_an_error_in_words() {
        for (bytes, said) in [
            (
                b"hello\n".as_slice(),
                "no message: it begins with the bytes `hell`; an engine prints to stderr, not to stdout",
            ),
            (&[2, 0, 0, 0, 9, b't'], "a message whose last entry is cut off"),
            (&[7, 0, 0, 0, 1, b'x', 1, 0, 0, 0, 7], "a message that does not begin with its `type`"),
            (&[0, 0, 0, 0], "a message that does not begin with its `type`"),
            (&[6, 0, 0, 0, 1, 0xff, 0, 0, 0, 0], "a message with a key that is not an ASCII word"),
            (&[9, 0, 0, 0, 4, b't', b'y'], "a message that ends after 3 of its 9 bytes"),
        ] {
            assert_eq!(read(bytes), Err(said.to_owned()));
        }
    }
}
