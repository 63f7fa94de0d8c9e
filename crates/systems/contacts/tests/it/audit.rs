//! The audit of contacts by exact distances: whole sets of contacts, and distances by another method.

mod counts;
mod oracle;
mod published;
mod sets;
