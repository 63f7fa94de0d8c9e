//! Runs that are killed at any moment, and folders that were damaged: each is resumed with byte-identical results, or
//! refused.
//!
//! Every file of an undisturbed run is compared except `env.json`, which has the machine and the command line. By
//! default a few cases are tried, and the nightly job tries all. Every case is derived from a seed, which is printed;
//! `PREDICAMENT_SEED` sets another seed.

mod clock;
mod damage;
mod disk;
mod driver;
#[cfg(target_os = "linux")]
mod power;
mod random;
mod syscalls;
mod writers;
