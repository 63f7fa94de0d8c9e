//! Runs backends on scenes, classifies their answers and measures error.
