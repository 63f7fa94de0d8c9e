//! One file per command: its arguments, its help, its work. [`study`] runs several.

pub mod ask;
pub mod bench;
pub mod bounds;
pub mod corpus;
pub mod diff;
pub mod doctor;
pub mod engines;
pub mod expect;
pub mod export;
pub mod gate;
pub mod hunt;
pub mod map;
pub mod merge;
pub mod new;
pub mod plan;
pub mod replay;
pub mod report;
pub mod resolve;
pub mod run;
pub mod schema;
pub mod selftest;
pub mod shell;
pub mod show;
pub mod shrink;
pub mod solve;
pub mod study;
