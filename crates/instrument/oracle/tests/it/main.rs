//! Tests of the oracle through its public interface: backends on scenes of the corpora, and the findings about them.

mod common;
mod constructed;
mod contacts;
mod crossings;
mod decimals;
mod expect;
mod faults;
mod guards;
mod judge;
mod lines_and_cubes;
mod locate;
mod locate_special;
mod pattern;
mod rational;
mod roster;
mod run;
mod sphere;
mod verdicts;
