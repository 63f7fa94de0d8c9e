//! Topology checks and axioms, decided exactly.
