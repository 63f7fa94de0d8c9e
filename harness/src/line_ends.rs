//! Line ends of files that are edited in place; a file with the line ends of Windows keeps them.

/// True if a text has lines and all of them end with CR LF.
pub fn is_crlf(text: &str) -> bool {
    text.contains('\n') && text.matches('\n').count() == text.matches("\r\n").count()
}

/// The text with CR LF at the end of each line.
pub fn to_crlf(text: &str) -> String {
    to_lf(text).replace('\n', "\r\n")
}

/// The text with LF alone at the end of each line.
pub fn to_lf(text: &str) -> String {
    text.replace("\r\n", "\n")
}
