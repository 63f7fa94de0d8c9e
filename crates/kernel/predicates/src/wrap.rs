//! Macros for sessions that answer through one method, or through another session.
//!
//! Both write methods inside an `impl Predicates`. Batches keep their defaults, which ask the single predicates.

/// Writes the five predicates of a session that answers all of them by one method.
///
/// The method is `fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign`.
///
/// ```
/// use predicament_predicates::{Predicates, Question, Scene, Sign, Vertex, answer_by};
///
/// struct Undecided<'s>(&'s Scene);
///
/// impl Undecided<'_> {
///     fn ask<const N: usize>(&self, _: Question, _: [Vertex; N]) -> Sign {
///         Sign::Zero
///     }
/// }
///
/// impl Predicates for Undecided<'_> {
///     fn scene(&self) -> &Scene {
///         self.0
///     }
///     answer_by!(ask);
/// }
/// ```
#[macro_export]
macro_rules! answer_by {
    ($ask:ident) => {
        #[inline]
        fn compare(&self, axis: $crate::Axis, a: $crate::Vertex, b: $crate::Vertex) -> $crate::Sign {
            self.$ask($crate::Question::Compare(axis), [a, b])
        }

        #[inline]
        fn orient2d(
            &self,
            plane: $crate::Plane,
            a: $crate::Vertex,
            b: $crate::Vertex,
            c: $crate::Vertex,
        ) -> $crate::Sign {
            self.$ask($crate::Question::Orient2d(plane), [a, b, c])
        }

        #[inline]
        fn orient3d(&self, a: $crate::Vertex, b: $crate::Vertex, c: $crate::Vertex, d: $crate::Vertex) -> $crate::Sign {
            self.$ask($crate::Question::Orient3d, [a, b, c, d])
        }

        #[inline]
        fn incircle(&self, a: $crate::Vertex, b: $crate::Vertex, c: $crate::Vertex, d: $crate::Vertex) -> $crate::Sign {
            self.$ask($crate::Question::Incircle, [a, b, c, d])
        }

        #[inline]
        fn insphere(
            &self,
            a: $crate::Vertex,
            b: $crate::Vertex,
            c: $crate::Vertex,
            d: $crate::Vertex,
            e: $crate::Vertex,
        ) -> $crate::Sign {
            self.$ask($crate::Question::Insphere, [a, b, c, d, e])
        }
    };
}

/// Writes the named predicates of a session that forwards them to another session that it holds.
///
/// The name `predicates` stands for the five predicates; formulas are forwarded by `sign`.
///
/// ```
/// use predicament_predicates::{Predicates, Plane, Scene, Sign, Vertex, forward_to};
///
/// struct Mirrored<P> {
///     inner: P,
/// }
///
/// impl<P: Predicates> Predicates for Mirrored<P> {
///     fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
///         -self.inner.orient2d(plane, a, b, c)
///     }
///     forward_to!(inner: scene, compare, orient3d, incircle, insphere);
/// }
/// ```
#[macro_export]
macro_rules! forward_to {
    ($inner:tt: $($method:ident),+ $(,)?) => {
        $($crate::forward_to!(@ $inner $method);)+
    };
    (@ $inner:tt predicates) => {
        $crate::forward_to!($inner: compare, orient2d, orient3d, incircle, insphere);
    };
    (@ $inner:tt scene) => {
        fn scene(&self) -> &$crate::Scene {
            self.$inner.scene()
        }
    };
    (@ $inner:tt compare) => {
        fn compare(&self, axis: $crate::Axis, a: $crate::Vertex, b: $crate::Vertex) -> $crate::Sign {
            self.$inner.compare(axis, a, b)
        }
    };
    (@ $inner:tt orient2d) => {
        fn orient2d(
            &self,
            plane: $crate::Plane,
            a: $crate::Vertex,
            b: $crate::Vertex,
            c: $crate::Vertex,
        ) -> $crate::Sign {
            self.$inner.orient2d(plane, a, b, c)
        }
    };
    (@ $inner:tt orient3d) => {
        fn orient3d(
            &self,
            a: $crate::Vertex,
            b: $crate::Vertex,
            c: $crate::Vertex,
            d: $crate::Vertex,
        ) -> $crate::Sign {
            self.$inner.orient3d(a, b, c, d)
        }
    };
    (@ $inner:tt incircle) => {
        fn incircle(
            &self,
            a: $crate::Vertex,
            b: $crate::Vertex,
            c: $crate::Vertex,
            d: $crate::Vertex,
        ) -> $crate::Sign {
            self.$inner.incircle(a, b, c, d)
        }
    };
    (@ $inner:tt sign) => {
        fn sign(&self, predicate: $crate::Derived, vertices: &[$crate::Vertex]) -> $crate::Sign {
            self.$inner.sign(predicate, vertices)
        }
    };
    (@ $inner:tt insphere) => {
        fn insphere(
            &self,
            a: $crate::Vertex,
            b: $crate::Vertex,
            c: $crate::Vertex,
            d: $crate::Vertex,
            e: $crate::Vertex,
        ) -> $crate::Sign {
            self.$inner.insphere(a, b, c, d, e)
        }
    };
}

/// Writes [`Backend::boxed`](crate::Backend::boxed), so that the backend's own crate compiles its sessions.
#[macro_export]
macro_rules! boxed_here {
    () => {
        fn boxed<'s>(
            &'s self,
            scene: &'s $crate::Scene,
            counts: Option<&'s $crate::Counts>,
        ) -> Result<$crate::alloc_of_macros::Box<dyn $crate::Predicates + 's>, $crate::Declined> {
            Ok(match counts {
                Some(counts) => $crate::alloc_of_macros::Box::new($crate::Backend::prepare(self, scene, counts)?),
                None => $crate::alloc_of_macros::Box::new($crate::Backend::prepare(self, scene, $crate::Off)?),
            })
        }
    };
}
