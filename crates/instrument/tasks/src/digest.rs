//! Digests of answers: equal answers have equal digests.

/// The 64-bit FNV-1a hash of bytes. Not cryptographic.
#[must_use]
pub fn digest(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
