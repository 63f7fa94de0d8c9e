//! The judges of other programs' convex hulls.
//!
//! A program may list a hull from any vertex on and in either direction, keep points in the middle of an edge or a
//! face, and use any of several points at one place.

mod plane;
mod space;

pub(super) use plane::JudgeInPlane;
pub(super) use space::JudgeInSpace;
