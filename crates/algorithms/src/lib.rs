//! The algorithms under test, generic over Predicates.
