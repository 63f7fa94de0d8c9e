//! Runs that are ended at any moment, and folders that were damaged: what is left is gone on with, byte for byte, or refused.
//!
//! What an undisturbed run leaves is compared file by file, but for `env.json`, which tells of the machine and the command line.
//! A few of all cases are tried by default, all of them in the nightly. Every case is of a seed, which is printed;
//! `PREDICAMENT_SEED` chooses another one.

mod clock;
mod damage;
mod disk;
mod driver;
#[cfg(target_os = "linux")]
mod power;
mod random;
mod syscalls;
mod writers;
