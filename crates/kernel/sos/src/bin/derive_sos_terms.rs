//! Prints the term lists: redirect the output to `crates/kernel/sos/src/tables.rs`.

fn main() {
    print!("{}", predicament_sos::derive::tables());
}
