//! Detection of the machine's vector registers at run time.
//!
//! The default target of x86-64 has registers of two doubles; most machines have four or eight. A [`Kernel`] is
//! compiled once for each width, from the same source, and the widest available version runs. The compiler neither
//! fuses nor reorders operations for that; it only executes several at a time.

#![allow(unsafe_code)]

/// Work that benefits from wide registers.
///
/// `run` must be `#[inline(always)]`: it inherits the target features of its caller.
pub trait Kernel {
    /// The result of the work.
    type Output;

    /// Does the work.
    ///
    /// # Safety
    /// If `WIDE` is true, the processor must have AVX-512F.
    unsafe fn run<const WIDE: bool>(self) -> Self::Output;
}

/// The number of doubles in a register.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Width {
    /// The width that all processors of the target have.
    Any,
    /// Four doubles: AVX2.
    Four,
    /// Eight doubles: AVX-512.
    Eight,
}

/// True if the machine has these instructions, as far as the build can know.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
macro_rules! has {
    ($feature:tt) => {
        std::is_x86_feature_detected!($feature)
    };
}

/// True if the build is for machines with these instructions.
#[cfg(all(target_arch = "x86_64", not(feature = "std")))]
macro_rules! has {
    ($feature:tt) => {
        cfg!(target_feature = $feature)
    };
}

impl Width {
    /// All widths, widest first.
    pub const ALL: [Width; 3] = [Width::Eight, Width::Four, Width::Any];

    /// Returns true if this machine has registers of this width.
    #[inline]
    pub fn is_available(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        match self {
            Width::Any => true,
            Width::Four => has!("avx2"),
            Width::Eight => has!("avx512f") && has!("avx512bw") && has!("avx512dq") && has!("avx512vl"),
        }
        #[cfg(not(target_arch = "x86_64"))]
        return self == Width::Any;
    }
}

/// Runs the kernel with the widest registers.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    let width = Width::ALL.into_iter().find(|width| width.is_available());
    run_on(width.unwrap_or(Width::Any), kernel)
}

/// Runs the kernel with registers of this width, or of any width if the machine lacks them.
#[inline]
pub fn run_on<K: Kernel>(width: Width, kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if width.is_available() {
        match width {
            // SAFETY: the machine has the features that the function is compiled for.
            Width::Eight => return unsafe { eight(kernel) },
            // SAFETY: as above.
            Width::Four => return unsafe { four(kernel) },
            Width::Any => {}
        }
    }
    // SAFETY: it does not run wide.
    unsafe { kernel.run::<false>() }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
fn eight<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: this function has AVX-512F.
    unsafe { kernel.run::<true>() }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn four<K: Kernel>(kernel: K) -> K::Output {
    // SAFETY: it does not run wide.
    unsafe { kernel.run::<false>() }
}
