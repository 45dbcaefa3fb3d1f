//! Declaration of models: one list gives struct, table and documentation.

use std::fmt;

use super::Columns;
use super::row::{row_of, view};

/// Declares an enumeration whose choices a column may take, numbered from 1 as in FMI.
///
/// ```
/// stribeck::choices! {
///     /// Mode of the test bench.
///     pub enum Bench {
///         /// Pulls at constant velocity.
///         Pull,
///         /// Moves to and fro.
///         Reciprocate,
///     }
/// }
/// assert_eq!(Bench::of(2.0), Bench::Reciprocate);
/// assert_eq!(Bench::CHOICES.items[0].help, "Pulls at constant velocity.");
/// ```
#[macro_export]
macro_rules! choices {
    ($(#[doc = $doc:literal])+ $vis:vis enum $Name:ident { $($(#[doc = $help:literal])+ $Item:ident,)+ }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        #[allow(dead_code, reason = "a column may hold a choice that no code names")]
        $vis enum $Name { $($(#[doc = $help])+ $Item,)+ }

        #[allow(dead_code, reason = "not every enumeration needs all of it")]
        impl $Name {
            /// The choices, as a column declares them.
            pub const CHOICES: &'static $crate::model::Enumeration = &$crate::model::Enumeration {
                name: stringify!($Name),
                items: &[$($crate::model::Item {
                    name: stringify!($Item),
                    help: concat!($($help),+).trim_ascii(),
                },)+],
            };

            /// The column with this choice as its start value.
            pub const fn start(self) -> $crate::model::Column {
                $crate::model::choice(Self::CHOICES, self as i32 + 1)
            }

            /// The number that stands for this choice.
            pub fn number(self) -> f64 {
                f64::from(self as i32 + 1)
            }

            /// Whether a column holds this choice.
            #[inline(always)]
            pub fn is<T: $crate::number::Real>(self, column: T) -> T::Mask {
                column.equals(T::from(self.number()))
            }

            /// The choice that a number stands for; numbers outside the bound of the column never get here.
            pub fn of(number: f64) -> $Name {
                const ALL: &[$Name] = &[$($Name::$Item),+];
                ALL[(number as usize).clamp(1, ALL.len()) - 1]
            }
        }
    };
}

/// Declares a part: columns that a model contains once (`stop: BumpStop`), several times (`element: [Element; 4]`), or
/// once and under the names of the part itself (`time_stepping: (TimeStepping)`). A part may have its own start values,
/// `rear: Axle = &[("stiffness", 2.0)]`, and so may the first parts of an array, `element: [Element; 4] =
/// &[("stiffness", &[3.0, 2.0])]`. Parameters and states may be arrays of numbers: `point: [tunable; 3] = [real("m",
/// 0.0); 3]`. The syntax of the fields is that of [`model!`](crate::model!).
#[macro_export]
macro_rules! part {
    ($(#[doc = $doc:expr])+ $Name:ident { $($(#[doc = $help:literal])* $field:ident: $what:tt $(= $column:expr)?,)+ }) => {
        $(#[doc = $doc])+
        #[repr(C)]
        #[allow(non_snake_case, reason = "a symbol such as V0 is a name as well")]
        pub struct $Name<T = f64> {
            $(
                #[doc = $crate::part!(@doc [$($help)*] $($column)?)]
                pub $field: $crate::part!(@type $what T),
            )+
        }

        impl<T: Copy> Clone for $Name<T> {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<T: Copy> Copy for $Name<T> {}

        // SAFETY: `#[repr(C)]`, and every field is a number of this type or a part of such numbers.
        unsafe impl<T: Copy> $crate::model::Numbers for $Name<T> {
            type Number = T;
        }

        impl<T: Copy> $Name<T> {
            /// The same columns in another number type.
            #[allow(dead_code, reason = "not every model needs it")]
            pub fn map<U: Copy>(&self, convert: &impl Fn(T) -> U) -> $Name<U> {
                $Name { $($field: $crate::part!(@map $what (self.$field) convert),)+ }
            }
        }

        impl std::fmt::Debug for $Name {
            fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                $crate::model::list(self, f)
            }
        }

        impl $crate::model::Width for $Name {
            const WIDTH: usize = 0 $(+ <$crate::part!(@type $what f64) as $crate::model::Width>::WIDTH)+;
        }

        // SAFETY: `#[repr(C)]`, and every field is a number or a part, so the struct is a run of numbers; the table has
        // one entry for each because both are written from the same list.
        unsafe impl $crate::model::Columns for $Name {
            const TABLE: &'static [$crate::model::Variable] = &const {
                let mut table = [$crate::model::BLANK; <$Name as $crate::model::Width>::WIDTH];
                let mut at = 0;
                $(at = $crate::part!(@place table at $field $what $(= $column)?, concat!($($help),*));)+
                assert!(at == table.len());
                table
            };
        }
    };

    (@doc [] $column:expr) => { concat!("Declared as `", stringify!($column), "`.") };
    (@doc [$($help:literal)+] $($column:expr)?) => { concat!($($help, "\n"),+) };

    (@type input $T:ident) => { $T };
    (@type fixed $T:ident) => { $T };
    (@type tunable $T:ident) => { $T };
    (@type state $T:ident) => { $T };
    (@type state_output $T:ident) => { $T };
    (@type output $T:ident) => { $T };
    (@type [fixed; $n:expr] $T:ident) => { [$T; $n] };
    (@type [tunable; $n:expr] $T:ident) => { [$T; $n] };
    (@type [state; $n:expr] $T:ident) => { [$T; $n] };
    (@type [$Part:ident; $n:expr] $T:ident) => { [$Part<$T>; $n] };
    (@type ($Part:ident) $T:ident) => { $Part<$T> };
    (@type $Part:ident $T:ident) => { $Part<$T> };

    (@map input $value:tt $convert:ident) => { $convert($value) };
    (@map fixed $value:tt $convert:ident) => { $convert($value) };
    (@map tunable $value:tt $convert:ident) => { $convert($value) };
    (@map state $value:tt $convert:ident) => { $convert($value) };
    (@map state_output $value:tt $convert:ident) => { $convert($value) };
    (@map output $value:tt $convert:ident) => { $convert($value) };
    (@map [fixed; $n:expr] $value:tt $convert:ident) => { $value.map($convert) };
    (@map [tunable; $n:expr] $value:tt $convert:ident) => { $value.map($convert) };
    (@map [state; $n:expr] $value:tt $convert:ident) => { $value.map($convert) };
    (@map [$Part:ident; $n:expr] $value:tt $convert:ident) => { $value.map(|part| part.map($convert)) };
    (@map ($Part:ident) $value:tt $convert:ident) => { $value.map($convert) };
    (@map $Part:ident $value:tt $convert:ident) => { $value.map($convert) };

    (@place $table:ident $at:ident $field:ident [fixed; $n:expr] = $columns:expr, $help:expr) => {
        $crate::model::place_all(&mut $table, $at, stringify!($field), $crate::model::Role::Fixed, &$columns, $help)
    };
    (@place $table:ident $at:ident $field:ident [tunable; $n:expr] = $columns:expr, $help:expr) => {
        $crate::model::place_all(&mut $table, $at, stringify!($field), $crate::model::Role::Tunable, &$columns, $help)
    };
    (@place $table:ident $at:ident $field:ident [state; $n:expr] = $columns:expr, $help:expr) => {
        $crate::model::place_all(&mut $table, $at, stringify!($field), $crate::model::Role::State, &$columns, $help)
    };
    (@place $table:ident $at:ident $field:ident [$Part:ident; $n:expr], $help:expr) => {
        $crate::model::graft_all(&mut $table, $at, stringify!($field), $n, <$Part as $crate::model::Columns>::TABLE)
    };
    (@place $table:ident $at:ident $field:ident [$Part:ident; $n:expr] = $starts:expr, $help:expr) => {
        $crate::model::graft_with(
            &mut $table, $at, stringify!($field), $n, <$Part as $crate::model::Columns>::TABLE, $starts)
    };
    (@place $table:ident $at:ident $field:ident ($Part:ident), $help:expr) => {
        $crate::model::inline(&mut $table, $at, <$Part as $crate::model::Columns>::TABLE)
    };
    (@place $table:ident $at:ident $field:ident $Part:ident, $help:expr) => {
        $crate::model::graft(
            &mut $table,
            $at,
            $crate::model::Segment { name: stringify!($field), index: 0 },
            <$Part as $crate::model::Columns>::TABLE,
        )
    };
    (@place $table:ident $at:ident $field:ident input = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Input $column, $help)
    };
    (@place $table:ident $at:ident $field:ident fixed = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Fixed $column, $help)
    };
    (@place $table:ident $at:ident $field:ident tunable = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Tunable $column, $help)
    };
    (@place $table:ident $at:ident $field:ident state = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field State $column, $help)
    };
    (@place $table:ident $at:ident $field:ident state_output = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field StateOutput $column, $help)
    };
    (@place $table:ident $at:ident $field:ident output = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Output $column, $help)
    };
    (@place $table:ident $at:ident $field:ident $Part:ident = $starts:expr, $help:expr) => {
        $crate::model::graft_one_with(
            &mut $table, $at, stringify!($field), <$Part as $crate::model::Columns>::TABLE, $starts)
    };

    (@column $table:ident $at:ident $field:ident $Role:ident $column:expr, $help:expr) => {
        $crate::model::place(&mut $table, $at, $column.named(
            $crate::model::Path::root(stringify!($field)), $crate::model::Role::$Role, $help))
    };
}

/// Declares a model: its struct, its table and its documentation, from one list.
///
/// A line reads `name: role = column` where the role is `input`, `fixed`, `tunable`, `state`, `state_output` or
/// `output`, and the column is made by `real`, `integer`, `boolean` or a choice; or it reads
/// `name: Part`, `name: [Part; count]` or `name: (Part)` for a [`part!`](crate::part!). The comment above a line is the
/// help text; a column with a help text of its own, such as those of the [dictionary](crate::contact::quantities), has
/// no comment.
///
/// ```
/// use stribeck::model::{CoSimulation, Columns, Law, Model, real};
/// use stribeck::number::Real;
///
/// stribeck::model! {
///     /// Coulomb friction without stiction, for the sake of the example.
///     Slider: "Coulomb friction" {
///         /// Sliding velocity.
///         velocity: input = real("m/s", 0.0),
///         /// Sliding friction force.
///         level: tunable = real("N", 1.0).at_least(0.0),
///         /// Friction force; has the sign of the velocity.
///         friction_force: output = real("N", 0.0),
///     }
/// }
///
/// impl<T: Real> Law for Slider<T> {
///     type Interface = CoSimulation;
///
///     fn output(&mut self) {
///         self.friction_force = self.level * self.velocity.sign();
///     }
/// }
///
/// impl Model for Slider {
///     fn step(&mut self, _dt: f64) {}
/// }
///
/// let mut slider = Slider { velocity: -0.1, ..Slider::default() };
/// slider.output();
/// assert_eq!(slider.friction_force, -1.0);
/// assert_eq!(Slider::TABLE[1].path.to_string(), "level");
/// ```
#[macro_export]
macro_rules! model {
    ($(#[doc = $doc:expr])+ $Name:ident: $summary:literal { $($fields:tt)+ }) => {
        $crate::part! { $(#[doc = $doc])+ $Name { $($fields)+ } }

        // SAFETY: `In<T>` is the same generic struct, for which `part!` makes the promise of `Columns`.
        unsafe impl $crate::model::Described for $Name {
            const NAME: &'static str = stringify!($Name);
            const C_NAME: &'static std::ffi::CStr = match std::ffi::CStr::from_bytes_with_nul(
                concat!(stringify!($Name), "\0").as_bytes(),
            ) {
                Ok(name) => name,
                Err(_) => panic!("a Rust name holds no zero byte"),
            };
            const SUMMARY: &'static str = $summary;
            const DOCUMENTATION: &'static str = concat!($($doc, "\n"),+);
            const COLUMNS: $crate::model::Table = $crate::packed!(<$Name as $crate::model::Columns>::TABLE);
            const PORTS: $crate::model::Ports = {
                const TABLE: &[$crate::model::Variable] = <$Name as $crate::model::Columns>::TABLE;
                const PORTS: &[$crate::model::Port] = &$crate::model::ports::<{ TABLE.len() }>(TABLE);
                const RANGES: &[$crate::model::Range] =
                    &$crate::model::ranges::<{ $crate::model::range_count(TABLE) }>(TABLE);
                $crate::model::Ports::new(PORTS, RANGES)
            };
            const REFERENCES: $crate::reference::References = {
                const TABLE: &[$crate::model::Variable] = <$Name as $crate::model::Columns>::TABLE;
                const STATES: usize = $crate::reference::state_count(TABLE);
                const PLACES: &[$crate::reference::Reference] =
                    &$crate::reference::places::<{ TABLE.len() + 1 + STATES }>(TABLE);
                const SLOTS: &[u16] = &$crate::reference::slots::<{ $crate::reference::slot_count(PLACES) }>(TABLE, PLACES);
                const STATE_COLUMNS: &[u16] = &$crate::reference::states::<STATES>(TABLE);
                $crate::reference::References::new(SLOTS, PLACES, STATE_COLUMNS)
            };
            type In<T: $crate::model::Evaluate> = $Name<T>;
        }

        impl Default for $Name {
            fn default() -> $Name {
                $crate::model::start()
            }
        }
    };
}

/// Writes a row as `name: value` pairs.
pub fn list<M: Columns>(model: &M, f: &mut fmt::Formatter) -> fmt::Result {
    let names = M::TABLE.iter().map(|variable| variable.path.to_string());
    f.debug_map().entries(names.zip(row_of(model))).finish()
}

/// A row of start values, as the struct.
pub fn start<M: Columns>() -> M {
    // A row of the right length is needed before it can be viewed; models are small, and this code is not critical for
    // speed.
    let row: Vec<f64> = M::TABLE.iter().map(|variable| variable.start).collect();
    *view::<M, f64>(&row)
}
