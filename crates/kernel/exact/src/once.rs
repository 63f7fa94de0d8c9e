//! A cell that is written once, also where there is no standard library.

#[cfg(feature = "std")]
pub(crate) use std::sync::OnceLock as Once;

#[cfg(not(feature = "std"))]
pub(crate) use race::Once;

/// A cell in which the first of several values stays.
#[cfg(not(feature = "std"))]
#[allow(unsafe_code)] // a pointer that is shared between threads
mod race {
    use alloc::boxed::Box;
    use core::fmt;
    use core::marker::PhantomData;
    use core::ptr::null_mut;
    use core::sync::atomic::{AtomicPtr, Ordering};

    /// A cell that is written once and then shared.
    ///
    /// Without an operating system a thread cannot wait for another one. So each thread that finds the cell empty
    /// computes the value, the first one stores it, and the others drop theirs.
    ///
    /// # Safety
    /// The pointer is null, or came from [`Box::into_raw`] and is never written again until the cell is dropped, which
    /// takes the cell mutably. The value is published with release and read with acquire.
    pub(crate) struct Once<T> {
        value: AtomicPtr<T>,
        owned: PhantomData<Box<T>>,
    }

    // SAFETY: as for a standard `OnceLock`: a reference to the cell gives references to the value, and can move a value
    // from one thread to another.
    unsafe impl<T: Send + Sync> Sync for Once<T> {}
    // SAFETY: the cell owns its value as a box does.
    unsafe impl<T: Send> Send for Once<T> {}

    impl<T> Once<T> {
        /// An empty cell.
        pub(crate) const fn new() -> Once<T> {
            Once { value: AtomicPtr::new(null_mut()), owned: PhantomData }
        }

        /// The value, if it is written.
        pub(crate) fn get(&self) -> Option<&T> {
            // SAFETY: the pointer is null, or the value lives as long as the cell.
            unsafe { self.value.load(Ordering::Acquire).as_ref() }
        }

        /// The value, if it is written.
        pub(crate) fn get_mut(&mut self) -> Option<&mut T> {
            // SAFETY: as in `get`, and nobody else refers to the cell.
            unsafe { self.value.get_mut().as_mut() }
        }

        /// The value, computed by this function unless it is written.
        pub(crate) fn get_or_init(&self, compute: impl FnOnce() -> T) -> &T {
            if let Some(value) = self.get() {
                return value;
            }
            let own = Box::into_raw(Box::new(compute()));
            match self.value.compare_exchange(null_mut(), own, Ordering::AcqRel, Ordering::Acquire) {
                // SAFETY: the cell owns the pointer from now on.
                Ok(_) => unsafe { &*own },
                Err(first) => {
                    // SAFETY: nobody else has seen the pointer.
                    drop(unsafe { Box::from_raw(own) });
                    // SAFETY: the pointer that was found is not null.
                    unsafe { &*first }
                }
            }
        }
    }

    impl<T> Drop for Once<T> {
        fn drop(&mut self) {
            let value = *self.value.get_mut();
            if !value.is_null() {
                // SAFETY: the cell owns the value, and nobody refers to it any more.
                drop(unsafe { Box::from_raw(value) });
            }
        }
    }

    impl<T> Default for Once<T> {
        fn default() -> Once<T> {
            Once::new()
        }
    }

    impl<T: Clone> Clone for Once<T> {
        fn clone(&self) -> Once<T> {
            let value = self.get().map_or(null_mut(), |value| Box::into_raw(Box::new(value.clone())));
            Once { value: AtomicPtr::new(value), owned: PhantomData }
        }
    }

    impl<T: fmt::Debug> fmt::Debug for Once<T> {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.debug_tuple("Once").field(&self.get()).finish()
        }
    }
}
