//! Messages of the protocol: keys and values behind a length.

use std::io::{Error, ErrorKind, Read};

/// The longest body of a message, in bytes.
pub const MOST_BYTES: u32 = 1 << 30;

/// One message: keys and values, the first of which is its type.
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

    /// The same message with one entry more.
    #[must_use]
    pub fn with(mut self, key: &str, value: impl Into<Vec<u8>>) -> Message {
        self.entries.push((key.to_owned(), value.into()));
        self
    }

    /// The value of a key as bytes; none if the message lacks it.
    #[must_use]
    pub fn bytes(&self, key: &str) -> Option<&[u8]> {
        self.entries.iter().find(|(of, _)| of == key).map(|(_, value)| value.as_slice())
    }

    /// The value of a key as text, with bytes that are none replaced; none if the message lacks it.
    #[must_use]
    pub fn text(&self, key: &str) -> Option<String> {
        self.bytes(key).map(|value| String::from_utf8_lossy(value).into_owned())
    }

    /// The value of a key as text.
    ///
    /// # Errors
    /// A sentence that names the message and the key.
    pub fn required(&self, key: &str) -> Result<String, String> {
        self.text(key).ok_or_else(|| format!("a message `{}` without `{key}`", self.kind()))
    }

    /// The value of a key that is a decimal integer.
    ///
    /// # Errors
    /// A sentence that names the message and the key.
    pub fn number(&self, key: &str) -> Result<u64, String> {
        let text = self.required(key)?;
        text.trim().parse().map_err(|_| format!("`{key}` of `{}` is `{text}`, which is no number", self.kind()))
    }

    /// The type of the message, the value of its first key.
    #[must_use]
    pub fn kind(&self) -> String {
        self.text("type").unwrap_or_default()
    }

    /// The bytes to send, length first.
    ///
    /// # Errors
    /// Where a key has more than 255 bytes or the body more than [`MOST_BYTES`].
    pub fn encode(&self) -> Result<Vec<u8>, String> {
        self.encode_within(MOST_BYTES)
    }

    fn encode_within(&self, most: u32) -> Result<Vec<u8>, String> {
        let size: usize = self.entries.iter().map(|(key, value)| 1 + key.len() + 4 + value.len()).sum();
        let length = u32::try_from(size).ok().filter(|&length| length <= most);
        let length = length.ok_or_else(|| format!("a message of {size} bytes; the protocol has up to {most}"))?;
        let mut bytes = Vec::with_capacity(4 + size);
        bytes.extend(length.to_le_bytes());
        for (key, value) in &self.entries {
            bytes.push(u8::try_from(key.len()).map_err(|_| format!("the key `{key}` is too long"))?);
            bytes.extend(key.as_bytes());
            // Shorter than the body, which fits.
            let length = u32::try_from(value.len()).map_err(|error| error.to_string())?;
            bytes.extend(length.to_le_bytes());
            bytes.extend(value);
        }
        Ok(bytes)
    }

    /// Reads one message; none at the end of the stream.
    ///
    /// # Errors
    /// That of the reader; [`ErrorKind::InvalidData`] where the bytes are no message.
    pub fn read(from: &mut impl Read) -> Result<Option<Message>, Error> {
        let mut length = [0; 4];
        if !read_or_end(from, &mut length)? {
            return Ok(None);
        }
        let size = u32::from_le_bytes(length);
        if size > MOST_BYTES {
            // Most often text that was printed to stdout.
            let shown = String::from_utf8_lossy(&length).escape_default().to_string();
            return Err(invalid(format!("no message: it begins with the bytes `{shown}`")));
        }
        // Not taken on trust: memory grows with the bytes that come.
        let mut body = Vec::new();
        from.take(u64::from(size)).read_to_end(&mut body)?;
        if body.len() < size as usize {
            return Err(invalid(format!("a message that ends after {} of its {size} bytes", body.len())));
        }
        Message::decode(&body).map(Some).map_err(invalid)
    }

    fn decode(mut body: &[u8]) -> Result<Message, String> {
        let cut = || "a message whose last entry is cut off".to_owned();
        let mut entries = Vec::new();
        while let Some((&length, rest)) = body.split_first() {
            let (key, rest) = rest.split_at_checked(usize::from(length)).ok_or_else(cut)?;
            let key = std::str::from_utf8(key).ok().filter(|key| key.is_ascii() && !key.is_empty());
            let key = key.ok_or("a message with a key that is no ASCII word")?;
            let (length, rest) = rest.split_first_chunk::<4>().ok_or_else(cut)?;
            let (value, rest) = rest.split_at_checked(u32::from_le_bytes(*length) as usize).ok_or_else(cut)?;
            entries.push((key.to_owned(), value.to_vec()));
            body = rest;
        }
        match entries.first() {
            Some((key, _)) if key == "type" => Ok(Message { entries }),
            _ => Err("a message that does not begin with its `type`".to_owned()),
        }
    }
}

/// Fills the buffer; false where the stream ends before its first byte.
fn read_or_end(from: &mut impl Read, buffer: &mut [u8]) -> Result<bool, Error> {
    let mut have = 0;
    while have < buffer.len() {
        match from.read(&mut buffer[have..]) {
            Ok(0) if have == 0 => return Ok(false),
            Ok(0) => return Err(invalid(format!("a message that ends after {have} bytes"))),
            Ok(more) => have += more,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(true)
}

fn invalid(message: impl Into<String>) -> Error {
    Error::new(ErrorKind::InvalidData, message.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(mut bytes: &[u8]) -> Result<Option<Message>, String> {
        Message::read(&mut bytes).map_err(|error| error.to_string())
    }

    #[test]
    fn messages_round_trip() {
        let message = Message::new("batch").with("ids", [1, 0, 0, 0]).with("ns", "17").with("empty", "");
        let bytes = message.encode().unwrap();
        assert_eq!(bytes.len(), 4 + (1 + 4 + 4 + 5) + (1 + 3 + 4 + 4) + (1 + 2 + 4 + 2) + (1 + 5 + 4));
        assert_eq!(read(&bytes), Ok(Some(message.clone())));
        assert_eq!(message.number("ns"), Ok(17));
        assert_eq!(message.number("nss"), Err("a message `batch` without `nss`".to_owned()));
        assert_eq!(read(&[]), Ok(None));
        for cut in 1..bytes.len() {
            assert!(read(&bytes[..cut]).is_err(), "{cut}");
        }
    }

    #[test]
    fn what_is_sent_is_bounded() {
        let message = Message::new("batch").with("ids", [1, 0, 0, 0]);
        let body = u32::try_from(message.encode().unwrap().len()).unwrap() - 4;
        assert_eq!(message.encode_within(body), message.encode());
        let said = format!("a message of {body} bytes; the protocol has up to {}", body - 1);
        assert_eq!(message.encode_within(body - 1), Err(said));
        let long = Message::new("batch").with(&"k".repeat(256), "");
        assert!(long.encode().unwrap_err().ends_with("is too long"));
    }

    #[test]
    fn garbage_is_an_error_in_words() {
        for (bytes, said) in [
            (b"hello\n".as_slice(), "no message: it begins with the bytes `hell`"),
            (&[2, 0, 0, 0, 9, b't'], "a message whose last entry is cut off"),
            (&[7, 0, 0, 0, 1, b'x', 1, 0, 0, 0, 7], "a message that does not begin with its `type`"),
            (&[0, 0, 0, 0], "a message that does not begin with its `type`"),
            (&[6, 0, 0, 0, 1, 0xff, 0, 0, 0, 0], "a message with a key that is no ASCII word"),
            (&[9, 0, 0, 0, 4, b't', b'y'], "a message that ends after 3 of its 9 bytes"),
        ] {
            assert_eq!(read(bytes), Err(said.to_owned()));
        }
    }
}
