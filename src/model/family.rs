//! Declaration of a family of models: its files and its list.

use super::{InLanes, Model};

/// Work on every model, each in its own type.
pub trait Visitor {
    /// Called once for each model.
    fn visit<M: Model>(&mut self);

    /// Called instead for a model that also runs in lanes.
    fn visit_in_lanes<M: InLanes>(&mut self) {
        self.visit::<M>();
    }
}

/// Declares the files of a family and lists their models: the only line that a new model adds outside its own file.
macro_rules! family {
    ($($file:ident::$Model:ident,)+) => {
        $(
            mod $file;
            pub use $file::$Model;
        )+

        /// The models of this family.
        pub(crate) static MODELS: &[$crate::model::ModelType] = &[$($crate::model::ModelType::of::<$Model>(),)+];

        /// Their tables as declared, for constants: at run time each model has its packed one.
        #[allow(dead_code, reason = "only laws are choices of other models")]
        pub(crate) const TABLES: &[&[$crate::model::Variable]] =
            &[$(<$Model as $crate::model::Columns>::TABLE,)+];

        /// The record of the model of this name, apart from the list: who uses it does not carry the others.
        #[allow(dead_code, reason = "only laws are choices of other models")]
        pub(crate) const fn record(name: &str) -> $crate::model::ModelType {
            $(
                if $crate::unit::same(name, <$Model as $crate::model::Described>::NAME) {
                    return $crate::model::ModelType::of::<$Model>();
                }
            )+
            panic!("no model of the family has this name")
        }

        /// Shows each of them to a visitor.
        pub(crate) fn visit(visitor: &mut impl $crate::model::Visitor) {
            $(<$Model as $crate::model::Model>::accept(visitor);)+
        }

        /// Their documentation pages. Kept apart from the models, so that the library in an FMU does not carry them.
        pub(crate) static PAGES: &[&str] = &[$(<$Model as $crate::model::Described>::DOCUMENTATION,)+];
    };
}
pub(crate) use family;
