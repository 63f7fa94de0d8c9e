//! Which registers the machine has, found out when the program runs.
//!
//! The default target of x86-64 knows registers of two doubles; most machines
//! have four or eight. A [`Kernel`] is compiled once for each width, from the
//! same source, and the widest that the machine has is taken. No operation is
//! fused or reordered by that: the compiler may only do several at a time.

#![allow(unsafe_code)]

/// Work that is worth a register width of its own.
///
/// `run` has to be `#[inline(always)]`: it takes on the features of its caller.
pub trait Kernel {
    /// What it gives.
    type Output;

    /// Does the work.
    ///
    /// # Safety
    /// With `WIDE` the processor must have AVX-512F.
    unsafe fn run<const WIDE: bool>(self) -> Self::Output;
}

/// How many doubles a register holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Width {
    /// As many as all processors of the target have.
    Any,
    /// Four: AVX2.
    Four,
    /// Eight: AVX-512.
    Eight,
}

impl Width {
    /// All of them, widest first.
    pub const ALL: [Width; 3] = [Width::Eight, Width::Four, Width::Any];

    /// Whether this machine has them.
    #[inline]
    pub fn is_available(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        match self {
            Width::Any => true,
            Width::Four => std::is_x86_feature_detected!("avx2"),
            Width::Eight => {
                std::is_x86_feature_detected!("avx512f")
                    && std::is_x86_feature_detected!("avx512bw")
                    && std::is_x86_feature_detected!("avx512dq")
                    && std::is_x86_feature_detected!("avx512vl")
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        return self == Width::Any;
    }
}

/// Does the work with the widest registers.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    let width = Width::ALL.into_iter().find(|width| width.is_available());
    run_on(width.unwrap_or(Width::Any), kernel)
}

/// Does the work with registers of this width, or of any if the machine has no such ones.
#[inline]
pub fn run_on<K: Kernel>(width: Width, kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if width.is_available() {
        match width {
            // SAFETY: the machine has the features that the functions are compiled for.
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
