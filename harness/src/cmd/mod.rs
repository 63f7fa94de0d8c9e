//! The commands, one file each, with arguments, help and code. A group of commands is a folder.

pub mod ask;
pub mod bench;
pub mod corpus;
pub mod data;
pub mod derive;
pub mod draw;
pub mod engines;
pub mod gate;
pub mod hunt;
pub mod judge;
pub mod replay;
pub mod report;
pub mod run;
pub mod scoreboard;
pub mod setup;
pub mod shard;
pub mod shrink;
pub mod solve;
pub mod study;
