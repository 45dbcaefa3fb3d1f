//! Variables whose names differ by an index only, such as `damper.tab_v[1]` to `damper.tab_v[16]`. FMI 3.0 has them as
//! one array, `damper.tab_v`.

use std::fmt;

use crate::memory::{self, OutOfMemory};
use crate::model::ModelType;
use crate::reference::{self, Place, Reference};
use crate::table::Path;

/// Variables with the indices 1, 2, 3 and so on.
#[derive(Debug)]
pub struct Array {
    /// The name, without an index.
    pub path: Path,
    /// Columns of the elements, in the order of their indices.
    pub columns: Box<[usize]>,
    /// The size that an importer may choose, if the elements are parameters.
    pub size: Option<Size>,
}

impl Array {
    /// Value reference.
    pub fn reference(&self) -> Reference {
        reference::of(&self.path)
    }

    /// Value reference of the time derivatives, if the elements are continuous states.
    pub fn derivative_reference(&self) -> Reference {
        reference::of_derivative(&self.path)
    }
}

/// Size of the arrays of one table: `damper.tab_size` is that of `damper.tab_v` and of `damper.tab_f`, `element_size` that
/// of the parameters of all elements. Its name is its `Display`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    stem: Path,
    /// Largest size, and the default.
    pub most: usize,
    /// The column with the number of elements that the model uses. The size must not be smaller.
    pub in_use: usize,
}

impl Size {
    /// Value reference.
    pub fn reference(&self) -> Reference {
        reference::of_ending(&self.stem, "_size")
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}_size", self.stem)
    }
}

/// The arrays of a model, in the order of their first elements.
pub fn of(model: &ModelType) -> Result<Box<[Array]>, OutOfMemory> {
    let is_first = |column: &usize| is_shown(model, *column).is_some_and(|(_, index)| index == 1);
    let firsts = memory::collected((0..model.table.len()).filter(is_first))?;
    Ok(memory::each(firsts.iter(), |first| array(model, *first))?.into_boxed_slice())
}

/// The name without its index, and the index, of a variable that the interfaces show.
fn is_shown(model: &ModelType, column: usize) -> Option<(Path, u16)> {
    let variable = model.table.at(column);
    variable.path.without_index().filter(|_| !variable.is_hidden)
}

fn array(model: &ModelType, first: usize) -> Result<Array, OutOfMemory> {
    let variable = model.table.at(first);
    let (path, _) = variable.path.without_index().unwrap_or((variable.path, 0));
    let is_element = |column: &usize| is_shown(model, *column).is_some_and(|(other, _)| other == path);
    let columns = memory::collected((first..model.table.len()).filter(is_element))?;
    let size = variable.role.is_parameter().then(|| size(model, &variable.path, columns.len())).flatten();
    Ok(Array { path, columns, size })
}

/// The size of a table with a count of the elements in use.
fn size(model: &ModelType, element: &Path, most: usize) -> Option<Size> {
    let stem = element.stem();
    let count = |ending: &&str| match model.place(reference::of_ending(&stem, ending)) {
        Some(Place::Column(column)) => Some(column),
        _ => None,
    };
    let in_use = ["_n", "_count"].iter().find_map(count)?;
    Some(Size { stem, most, in_use })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue;

    #[test]
    fn elements_are_alike_and_counted_from_one() {
        for model in catalogue::models() {
            for array in of(model).unwrap() {
                let first = model.table.at(array.columns[0]);
                for (index, column) in (1..).zip(&array.columns) {
                    let variable = model.table.at(*column);
                    assert_eq!(variable.path.without_index(), Some((array.path, index)), "{}", model.name);
                    assert_eq!(variable.role, first.role, "{}: {}", model.name, variable.path);
                    assert_eq!(variable.kind, first.kind);
                    assert_eq!(variable.jumps, first.jumps);
                    assert_eq!(variable.bound, first.bound);
                    assert_eq!((variable.nominal, variable.display), (first.nominal, first.display));
                    assert_eq!((variable.help, variable.reinit), (first.help, first.reinit));
                }
            }
        }
    }

    #[test]
    fn every_element_is_in_one_array() {
        for model in catalogue::models() {
            let arrays = of(model).unwrap();
            for (column, variable) in model.variables() {
                let owners = arrays.iter().filter(|array| array.columns.contains(&column)).count();
                assert_eq!(owners, usize::from(variable.path.without_index().is_some()), "{}", variable.path);
            }
        }
    }

    #[test]
    fn references_of_arrays_belong_to_nothing_else() {
        for model in catalogue::models() {
            let arrays = of(model).unwrap();
            let sizes = arrays.iter().filter_map(|array| array.size.map(|size| (size.to_string(), size.reference())));
            let names = arrays.iter().map(|array| (array.path.to_string(), array.reference()));
            let derivatives = arrays.iter().map(|it| (format!("der({})", it.path), it.derivative_reference()));
            let indicators = std::iter::once(("event_indicators".to_string(), reference::EVENT_INDICATORS));
            let all: std::collections::BTreeMap<_, _> =
                sizes.chain(names).chain(derivatives).chain(indicators).collect();
            for (name, reference) in &all {
                assert_eq!(*reference, reference::of_name(name));
                assert_eq!(model.place(*reference), None, "{}: {name}", model.name);
            }
            let different: std::collections::BTreeSet<_> = all.values().collect();
            assert_eq!(different.len(), all.len(), "{}", model.name);
        }
    }

    #[test]
    fn tables_have_the_size_of_their_points() {
        let strut = catalogue::by_name("ShockAbsorber").unwrap();
        let arrays = of(strut).unwrap();
        let size = |name: &str| arrays.iter().find(|array| array.path.is_spelled(name)).unwrap().size;
        let damper = size("damper.tab_v").unwrap();
        assert_eq!((damper.to_string().as_str(), damper.most), ("damper.tab_size", 16));
        assert_eq!(Some(damper), size("damper.tab_f"));
        assert!(strut.table.at(damper.in_use).path.is_spelled("damper.tab_n"));
        let element = size("friction.element.strength_share").unwrap();
        assert_eq!(element.to_string(), "friction.element_size");
        assert_eq!(Some(element), size("friction.element.stiffness_share"));
        assert_eq!(size("memory_1"), None, "a state");
    }

    #[test]
    fn every_array_of_parameters_has_a_size() {
        for model in catalogue::models() {
            for array in of(model).unwrap() {
                let is_parameter = model.table.at(array.columns[0]).role.is_parameter();
                assert_eq!(array.size.is_some(), is_parameter, "{}: {}", model.name, array.path);
            }
        }
    }
}
