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
pub(crate) trait Kernel {
    /// What it gives.
    type Output;

    /// Does the work.
    fn run(self) -> Self::Output;
}

/// Does the work with the widest registers.
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if std::is_x86_feature_detected!("avx512f")
            && std::is_x86_feature_detected!("avx512bw")
            && std::is_x86_feature_detected!("avx512dq")
            && std::is_x86_feature_detected!("avx512vl")
        {
            // SAFETY: the machine has the features that the function is compiled for.
            return unsafe { wide(kernel) };
        }
        if std::is_x86_feature_detected!("avx2") {
            // SAFETY: the machine has the feature that the function is compiled for.
            return unsafe { medium(kernel) };
        }
    }
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
fn wide<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn medium<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}
