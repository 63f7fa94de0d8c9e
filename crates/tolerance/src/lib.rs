//! The tolerance backend of Wang, Jiang, Schroeder and Teran.
