//! Backends to compare with: naive, epsilon, shewchuk.
