//! The version and the meaning of result codes.

use std::ffi::{CStr, c_char};

use super::predicament_result;

const VERSION: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
    Ok(text) => text,
    Err(_) => panic!("a version has no NUL"),
};

/// The version of the library, such as "0.1.0". PREDICAMENT_VERSION is the version of the header.
///
/// @return a string that is never freed
#[unsafe(no_mangle)]
pub extern "C" fn predicament_version() -> *const c_char {
    VERSION.as_ptr()
}

/// The meaning of a result code, in a few words of English.
///
/// @param result  a value of predicament_result, or any other number
/// @return a string that is never freed
#[unsafe(no_mangle)]
pub extern "C" fn predicament_result_text(result: i32) -> *const c_char {
    let at = usize::try_from(result).ok();
    let known = at.and_then(|at| predicament_result::ALL.get(at));
    known.map_or(c"not a result code", |result| result.text()).as_ptr()
}
