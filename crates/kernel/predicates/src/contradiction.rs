//! A macro for the errors of algorithms that stop when signs contradict each other.

/// Declares an enum of the rules that an algorithm relies on.
///
/// Each case has the statement that should hold and a description of the failure.
///
/// The enum is `Copy`. Its `rule` is the statement, which is the name of the check in stored findings. `RULES` are the
/// statements of its own cases. It displays the description of the failure. After `or` come the contradictions of
/// algorithms that this algorithm calls.
///
/// ```
/// use predicament_predicates::contradiction;
///
/// contradiction! {
///     /// A rule of walks that does not hold.
///     pub enum InWalk {
///         Endless: "a walk ends", "a walk does not end";
///     }
/// }
/// contradiction! {
///     /// A rule of insertion that does not hold.
///     pub enum InInsertion {
///         Torn: "a hole is a disc", "a hole is not a disc";
///     }
///     or {
///         /// A walk stopped.
///         Walk(InWalk);
///     }
/// }
///
/// let stopped = InInsertion::from(InWalk::Endless);
/// assert_eq!((stopped.rule(), stopped.to_string()), ("a walk ends", "a walk does not end".to_owned()));
/// assert_eq!(InInsertion::RULES, ["a hole is a disc"]);
/// ```
#[macro_export]
macro_rules! contradiction {
    (
        $(#[$of_all:meta])*
        $visibility:vis enum $name:ident {
            $($case:ident: $rule:literal, $failure:literal;)+
        }
        $(or { $($(#[$of_one:meta])* $from:ident($inner:ty);)+ })?
    ) => {
        $(#[$of_all])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        #[non_exhaustive]
        $visibility enum $name {
            $(#[doc = concat!("It fails where ", $failure, ".")] $case,)+
            $($($(#[$of_one])* $from($inner),)+)?
        }

        impl $name {
            /// The statements that should hold, without the statements of called algorithms.
            pub const RULES: &'static [&'static str] = &[$($rule),+];

            /// The statement that should hold: the name of the check in stored findings.
            #[must_use]
            pub const fn rule(self) -> &'static str {
                match self {
                    $($name::$case => $rule,)+
                    $($($name::$from(inner) => inner.rule(),)+)?
                }
            }
        }

        $($(impl From<$inner> for $name {
            fn from(inner: $inner) -> $name {
                $name::$from(inner)
            }
        })+)?

        /// Writes the description of the failure.
        impl ::core::fmt::Display for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                match self {
                    $($name::$case => f.write_str($failure),)+
                    $($($name::$from(inner) => ::core::fmt::Display::fmt(inner, f),)+)?
                }
            }
        }

        impl ::core::error::Error for $name {}
    };
}
