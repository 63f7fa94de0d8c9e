//! What `bounds` prints: the same rows as a page and as a CSV table.

mod page;
mod table;

pub use page::page;
pub use table::csv;
