//! One file per command: its arguments, its help, its work.

pub mod audit;
pub mod bench;
pub mod bounds;
pub mod corpus;
pub mod doctor;
pub mod gate;
pub mod laws;
pub mod map;
pub mod parity;
pub mod replay;
pub mod report;
pub mod resolution;
pub mod run;
pub mod selftest;
