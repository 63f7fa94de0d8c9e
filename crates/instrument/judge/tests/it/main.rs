//! Tests of the judge: against known results, against second computations, and against the algorithms that it judges.

mod boxes;
mod contacts;
mod cubes;
mod dependencies;
mod hull;
mod interval;
mod locate;
mod nearest;
mod portable;
mod random;
mod rational_solids;
mod sample;
mod second;
mod session;
mod solids;
mod within;
