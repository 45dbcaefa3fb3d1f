//! The variables of FMI 3.0: what a value reference stands for. Variables that differ by an index are one array there.

use std::fmt;

use super::types::fmi3ValueReference;
use stribeck::arrays;
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::{Kind, ModelType};
use stribeck::reference::{self, Place};

/// Element of a variable: a scalar has one, an array several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Item {
    /// A column of the row.
    Column(usize),
    /// The time derivative of the state in this column.
    Derivative(usize),
    /// The independent variable.
    Time,
    /// An event indicator.
    Indicator(usize),
    /// The size of arrays.
    Size(usize),
}

/// A type of variables that models have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    Float64,
    Int32,
    Int64,
    UInt64,
    Boolean,
}

impl Item {
    /// Its column, if it has one.
    pub fn column(self) -> Option<usize> {
        match self {
            Item::Column(column) => Some(column),
            _ => None,
        }
    }

    /// Its type.
    pub fn of_type(self, model: &ModelType) -> Type {
        match self {
            Item::Column(column) => match model.table.at(column).kind {
                Kind::Real(_) => Type::Float64,
                Kind::Integer => Type::Int32,
                Kind::Enumeration(_) => Type::Int64,
                Kind::Boolean => Type::Boolean,
            },
            Item::Derivative(_) | Item::Time | Item::Indicator(_) => Type::Float64,
            Item::Size(_) => Type::UInt64,
        }
    }
}

/// The elements of a variable, in their order.
#[derive(Clone, Copy, Debug)]
pub(super) enum Elements<'a> {
    One(Item),
    Columns(&'a [usize]),
    Derivatives(&'a [usize]),
    Indicators(usize),
}

impl<'a> Elements<'a> {
    pub fn len(self) -> usize {
        match self {
            Elements::One(_) => 1,
            Elements::Columns(columns) | Elements::Derivatives(columns) => columns.len(),
            Elements::Indicators(count) => count,
        }
    }

    /// The first one; every variable has one.
    pub fn first(self) -> Item {
        self.at(0)
    }

    fn at(self, index: usize) -> Item {
        match self {
            Elements::One(item) => item,
            Elements::Columns(columns) => Item::Column(columns[index]),
            Elements::Derivatives(columns) => Item::Derivative(columns[index]),
            Elements::Indicators(_) => Item::Indicator(index),
        }
    }

    pub fn iter(self) -> impl Iterator<Item = Item> + Clone + use<'a> {
        (0..self.len()).map(move |index| self.at(index))
    }
}

/// The arrays of an instance and their sizes. Only plain numbers, because the library may be reloaded at another address.
pub(super) struct Layout {
    arrays: Box<[Array]>,
    /// Whether a column is an element of an array.
    is_element: Box<[bool]>,
    /// References of the sizes, and the columns with the numbers of elements in use.
    size_references: Box<[fmi3ValueReference]>,
    in_use: Box<[usize]>,
    /// The sizes that the importer has chosen.
    pub sizes: Box<[usize]>,
    /// The largest ones, which are the defaults.
    pub most: Box<[usize]>,
}

struct Array {
    reference: fmi3ValueReference,
    /// That of the time derivatives, if they exist.
    derivatives: Option<fmi3ValueReference>,
    columns: Box<[usize]>,
    /// Place of its size, if it has one.
    size: Option<usize>,
}

impl Layout {
    pub fn of(model: &ModelType) -> Result<Layout, OutOfMemory> {
        let arrays = arrays::of(model)?;
        let is_new = |(at, size): &(usize, arrays::Size)| {
            let before = arrays[..*at].iter().filter_map(|array| array.size);
            before.into_iter().all(|other| other.reference() != size.reference())
        };
        let sizes = arrays.iter().enumerate().filter_map(|(at, array)| array.size.map(|size| (at, size)));
        let sizes = memory::collected(sizes.filter(is_new).map(|(_, size)| size))?;
        let size_references = memory::collected(sizes.iter().map(arrays::Size::reference))?;
        let mut is_element = memory::filled(false, model.table.len())?;
        for column in arrays.iter().flat_map(|array| &array.columns) {
            is_element[*column] = true;
        }
        Ok(Layout {
            arrays: memory::each(arrays.iter(), |array| Array::of(model, array, &size_references))?.into_boxed_slice(),
            is_element,
            size_references,
            in_use: memory::collected(sizes.iter().map(|size| size.in_use))?,
            sizes: memory::collected(sizes.iter().map(|size| size.most))?,
            most: memory::collected(sizes.iter().map(|size| size.most))?,
        })
    }

    /// Whether a column can only be reached as an element of an array.
    #[inline]
    pub fn is_element(&self, column: usize) -> bool {
        self.is_element[column]
    }

    pub fn has_arrays(&self) -> bool {
        !self.arrays.is_empty()
    }

    /// Place of a column in the order in which FMI 3.0 lists variables: an array where its first element is.
    pub fn order(&self, column: usize) -> (usize, usize) {
        let array = self.arrays.iter().find_map(|array| {
            let index = array.columns.iter().position(|element| *element == column)?;
            Some((array.columns[0], index))
        });
        array.unwrap_or((column, 0))
    }

    /// The elements of the variable with this reference.
    pub fn find(&self, model: &ModelType, reference: fmi3ValueReference) -> Option<Elements<'_>> {
        match model.place(reference) {
            Some(Place::Column(column)) => (!self.is_element[column]).then_some(Elements::One(Item::Column(column))),
            Some(Place::Time) => Some(Elements::One(Item::Time)),
            Some(Place::Derivative(state)) => {
                let is_one = model.model_exchange && !self.is_element[state];
                is_one.then_some(Elements::One(Item::Derivative(state)))
            }
            None => self.find_array(model, reference),
        }
    }

    /// The elements of variables that exist, one after the other.
    pub fn items<'a>(
        &'a self,
        model: &'static ModelType,
        references: &'a [fmi3ValueReference],
    ) -> impl Iterator<Item = Item> + Clone + use<'a> {
        let elements = references.iter().filter_map(move |reference| self.find(model, *reference));
        elements.flat_map(Elements::iter)
    }

    fn find_array(&self, model: &ModelType, reference: fmi3ValueReference) -> Option<Elements<'_>> {
        if reference == reference::EVENT_INDICATORS {
            return (model.event_indicators > 0).then_some(Elements::Indicators(model.event_indicators));
        }
        if let Some(at) = self.size_references.iter().position(|size| *size == reference) {
            return Some(Elements::One(Item::Size(at)));
        }
        self.arrays.iter().find_map(|array| {
            let columns = &array.columns[..array.size.map_or(array.columns.len(), |size| self.sizes[size])];
            if array.reference == reference {
                Some(Elements::Columns(columns))
            } else {
                (array.derivatives == Some(reference)).then_some(Elements::Derivatives(columns))
            }
        })
    }

    /// A size below the number of elements in use: the column with that number, and the place of the size.
    pub fn too_small(&self, row: &[f64]) -> Option<(usize, usize)> {
        let sizes = self.in_use.iter().zip(&self.sizes).enumerate();
        sizes.filter(|(_, (column, size))| row[**column] > **size as f64).map(|(at, (column, _))| (*column, at)).next()
    }
}

impl Array {
    fn of(model: &ModelType, array: &arrays::Array, sizes: &[fmi3ValueReference]) -> Result<Array, OutOfMemory> {
        let first = model.table.at(array.columns[0]);
        let has_derivatives = model.model_exchange && first.is_continuous_state();
        let place = |size: arrays::Size| sizes.iter().position(|reference| *reference == size.reference());
        Ok(Array {
            reference: array.reference(),
            derivatives: has_derivatives.then(|| array.derivative_reference()),
            columns: memory::copied(&array.columns)?,
            size: array.size.and_then(place),
        })
    }
}

/// The name of a variable, for messages.
pub(super) struct Name<'a>(pub &'a ModelType, pub &'a Layout, pub Elements<'a>);

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Name(model, layout, elements) = *self;
        let path = |column: usize| {
            let path = model.table.at(column).path;
            if layout.is_element(column) { path.without_index().map_or(path, |(path, _)| path) } else { path }
        };
        match elements.first() {
            Item::Column(column) => path(column).fmt(f),
            Item::Derivative(state) => write!(f, "der({})", path(state)),
            Item::Time => f.write_str("time"),
            Item::Indicator(_) => f.write_str("event_indicators"),
            Item::Size(at) => {
                let arrays = arrays::of(model).map_err(|_| fmt::Error)?;
                let mut sizes = arrays.iter().filter_map(|array| array.size);
                let size = sizes.find(|size| size.reference() == layout.size_references[at]);
                size.map_or(Ok(()), |size| size.fmt(f))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Elements stand one after the other at the place of the first, in whichever order the table has them.
    #[test]
    fn columns_are_ordered_by_variables() {
        let mut moved = 0;
        for model in crate::models::all() {
            let arrays = arrays::of(model).expect("memory");
            let mut expected: Vec<usize> = Vec::new();
            for column in 0..model.table.len() {
                match arrays.iter().find(|array| array.columns.contains(&column)) {
                    Some(array) if array.columns[0] == column => expected.extend(&array.columns),
                    Some(_) => {}
                    None => expected.push(column),
                }
            }
            let layout = Layout::of(model).expect("memory");
            let mut columns: Vec<usize> = (0..model.table.len()).collect();
            columns.sort_by_key(|column| layout.order(*column));
            moved += usize::from(!columns.is_sorted());
            assert_eq!(columns, expected, "{}", model.name);
        }
        assert!(moved > 0, "some table has its elements apart");
    }

    fn reference(name: &str, of: impl Fn(&arrays::Array) -> fmi3ValueReference) -> (ModelTypeRef, fmi3ValueReference) {
        let model = crate::models::by_name("ShockAbsorber").expect("a model");
        let arrays = arrays::of(model).expect("memory");
        let array = arrays.iter().find(|array| array.path.to_string() == name).expect("an array");
        (model, of(array))
    }

    type ModelTypeRef = &'static ModelType;

    #[test]
    fn an_array_has_as_many_elements_as_its_size() {
        let (model, values) = reference("damper.tab_v", arrays::Array::reference);
        let (_, size) = reference("damper.tab_v", |array| array.size.expect("a size").reference());
        let mut layout = Layout::of(model).expect("memory");
        let Some(Elements::One(Item::Size(at))) = layout.find(model, size) else { panic!("no size") };
        assert_eq!(layout.find(model, values).map(Elements::len), Some(16));
        layout.sizes[at] = 3;
        let elements = layout.find(model, values).expect("an array");
        let names: Vec<String> = elements
            .iter()
            .map(|item| match item {
                Item::Column(column) => model.table.at(column).path.to_string(),
                _ => panic!("{item:?}"),
            })
            .collect();
        assert_eq!(names, ["damper.tab_v[1]", "damper.tab_v[2]", "damper.tab_v[3]"]);
        assert_eq!(Name(model, &layout, elements).to_string(), "damper.tab_v");
        let size = layout.find(model, size).expect("a size");
        assert_eq!(Name(model, &layout, size).to_string(), "damper.tab_size");
        let first = model.find("damper.tab_v[1]").expect("an element");
        assert!(layout.find(model, model.reference(first)).is_none(), "only as an array");
    }
}
