//! What a case is, and the macro that makes a table of cases, and of each a test.

use crate::trial::Trial;

/// One fact about numbers.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// What the catalogue calls it: `S3`.
    pub id: &'static str,
    /// The fact, as a sentence in the form of an identifier.
    pub fact: &'static str,
    /// How it is found out.
    pub check: Check,
}

/// How a fact is found out.
#[derive(Clone, Copy, Debug)]
pub enum Check {
    /// Inputs that are written down; once is enough.
    Exact(fn(&mut Trial)),
    /// Random inputs: `check` takes [`Trial::rays`] of them, each as costly as `cost` plain rays.
    Random {
        /// Tries what it is asked to.
        check: fn(&mut Trial),
        /// By what the number of rays is divided.
        cost: u64,
    },
    /// A test of a chapter shows it, on whole scenes.
    Elsewhere {
        /// The file, seen from the workspace's root.
        file: &'static str,
        /// The name of the test in it.
        test: &'static str,
    },
    /// It says nothing about this course, yet or at all.
    Absent {
        /// Why.
        reason: &'static str,
    },
}

/// A table of cases, `CASES`, and a test of each.
///
/// ```text
/// catalogue! {
///     S1 exact a_ray_through_the_centre_meets_the_sphere_in_front;
///     S3 random/1 a_distant_sphere_is_hit_to_the_last_place;
///     E1 elsewhere "chapters/06-path-tracing/tests/paths/furnace.rs" every_bounce_adds_its_share;
///     M11 absent stratified_points_fill_every_interval "there are none before chapter 8";
/// }
/// ```
///
/// A name is that of a function below the table, `fn(&mut Trial)`, whose doc comment gives the inputs
/// and why the tolerance is what it is. The number after `random/` is the cost of one try, in plain
/// rays.
#[macro_export]
macro_rules! catalogue {
    ($($id:ident $kind:ident $(/ $cost:literal)? $($file:literal)? $fact:ident $($reason:literal)?;)*) => {
        /// The cases of this component.
        pub const CASES: &[$crate::Case] = &[$($crate::Case {
            id: stringify!($id),
            fact: stringify!($fact),
            check: $crate::catalogue!(@check $kind $($cost)? $($file)? $fact $($reason)?),
        }),*];

        #[cfg(test)]
        #[allow(non_snake_case, reason = "an id is a module, so that the test's name shows it")]
        mod cases {
            $(
                mod $id {
                    #[test]
                    fn $fact() {
                        $crate::laboratory::assert(super::super::CASES, stringify!($id));
                    }
                }
            )*
        }
    };
    (@check exact $fact:ident) => { $crate::Check::Exact($fact) };
    (@check random $cost:literal $fact:ident) => {
        $crate::Check::Random { check: $fact, cost: $cost }
    };
    (@check elsewhere $file:literal $fact:ident) => {
        $crate::Check::Elsewhere { file: $file, test: stringify!($fact) }
    };
    (@check absent $fact:ident $reason:literal) => { $crate::Check::Absent { reason: $reason } };
}
