//! CVODE, the solver of SUNDIALS 6, for the equations of this workbench.
//!
//! The libraries are opened when the benchmark runs (Debian: libsundials-dev), so that nothing else needs them.

use std::ffi::{c_int, c_long, c_void};
use std::ptr;

use libloading::{Library, Symbol};
use stribeck_solve::solve::{Equations, Grid};

const NORMAL: c_int = 1;
const BDF: c_int = 2;
const ROOT: c_int = 2;

/// Objects of SUNDIALS.
type Object = *mut c_void;

type Rates = unsafe extern "C" fn(f64, Object, Object, *mut c_void) -> c_int;
type Jacobian = unsafe extern "C" fn(f64, Object, Object, Object, *mut c_void, Object, Object, Object) -> c_int;
type Roots = unsafe extern "C" fn(f64, Object, *mut f64, *mut c_void) -> c_int;

/// The libraries.
pub struct Sundials {
    libraries: Vec<Library>,
}

/// Equations as CVODE's functions get them.
struct Problem<'a> {
    equations: &'a mut dyn Equations,
    data: unsafe extern "C" fn(Object) -> *mut f64,
    matrix: unsafe extern "C" fn(Object) -> *mut f64,
    row_major: Vec<f64>,
    by_time: Vec<f64>,
}

impl Sundials {
    /// Opens the libraries; None if they are not installed.
    pub fn open() -> Option<Sundials> {
        let names = ["cvode", "nvecserial", "sunmatrixdense", "sunlinsoldense"];
        // SAFETY: these libraries run no code of their own when they are opened.
        let opened = names.map(|name| unsafe { Library::new(format!("libsundials_{name}.so")) }.ok());
        Some(Sundials { libraries: opened.into_iter().collect::<Option<Vec<Library>>>()? })
    }

    /// A function of the libraries.
    fn function<F: Copy>(&self, name: &str) -> F {
        // SAFETY: the types at the calls are those of the headers of SUNDIALS 6.
        let found = self.libraries.iter().find_map(|library| unsafe { library.get::<F>(name.as_bytes()) }.ok());
        let symbol: Symbol<F> = found.unwrap_or_else(|| panic!("SUNDIALS has no function {name}"));
        *symbol
    }

    /// Runs the equations from `states` over the grid with BDF, exact Jacobian and, if there are indicators, roots.
    /// Returns one of the states on the grid; None if CVODE does not come to the end.
    pub fn run(
        &self,
        equations: &mut dyn Equations,
        states: &[f64],
        (grid, wanted): (Grid, usize),
        tolerance: f64,
    ) -> Option<Vec<f64>> {
        let mut run = Run::new(self, equations, states, tolerance);
        run.set(self, tolerance);
        let column = run.go(grid, wanted);
        run.free(self);
        column
    }
}

/// A run under way.
struct Run<'a> {
    context: Object,
    memory: Object,
    vector: Object,
    tolerances: Object,
    matrix: Object,
    linear: Object,
    problem: Box<Problem<'a>>,
    cvode: unsafe extern "C" fn(Object, f64, Object, *mut f64, c_int) -> c_int,
    restart: unsafe extern "C" fn(Object, f64, Object) -> c_int,
}

impl<'a> Run<'a> {
    fn new(library: &Sundials, equations: &'a mut dyn Equations, states: &[f64], tolerance: f64) -> Run<'a> {
        type Context = unsafe extern "C" fn(Object, *mut Object) -> c_int;
        type Vector = unsafe extern "C" fn(i64, Object) -> Object;
        type Memory = unsafe extern "C" fn(c_int, Object) -> Object;
        type Matrix = unsafe extern "C" fn(i64, i64, Object) -> Object;
        type Linear = unsafe extern "C" fn(Object, Object, Object) -> Object;
        let (size, rows) = (states.len(), states.len() as i64);
        let scales = equations.scales().to_vec();
        let mut start = states.to_vec();
        equations.at_event(0.0, &mut start).expect("states at the start");
        let problem = Box::new(Problem {
            equations,
            data: library.function("N_VGetArrayPointer"),
            matrix: library.function("SUNDenseMatrix_Data"),
            row_major: vec![0.0; size * size],
            by_time: vec![0.0; size],
        });
        let (cvode, restart) = (library.function("CVode"), library.function("CVodeReInit"));
        let mut context = ptr::null_mut();
        // SAFETY: the calls and their types are those of the manual of SUNDIALS 6; the vectors have `size` numbers.
        unsafe {
            library.function::<Context>("SUNContext_Create")(ptr::null_mut(), &mut context);
            let [vector, tolerances] = [(); 2].map(|()| library.function::<Vector>("N_VNew_Serial")(rows, context));
            for i in 0..size {
                *(problem.data)(vector).add(i) = start[i];
                *(problem.data)(tolerances).add(i) = tolerance * scales[i];
            }
            let memory = library.function::<Memory>("CVodeCreate")(BDF, context);
            let matrix = library.function::<Matrix>("SUNDenseMatrix")(rows, rows, context);
            let linear = library.function::<Linear>("SUNLinSol_Dense")(vector, matrix, context);
            Run { context, memory, vector, tolerances, matrix, linear, problem, cvode, restart }
        }
    }

    /// Gives the solver its equations.
    fn set(&mut self, library: &Sundials, tolerance: f64) {
        type Init = unsafe extern "C" fn(Object, Rates, f64, Object) -> c_int;
        type Tolerances = unsafe extern "C" fn(Object, f64, Object) -> c_int;
        type User = unsafe extern "C" fn(Object, *mut c_void) -> c_int;
        type Linear = unsafe extern "C" fn(Object, Object, Object) -> c_int;
        type Exact = unsafe extern "C" fn(Object, Jacobian) -> c_int;
        type Steps = unsafe extern "C" fn(Object, c_long) -> c_int;
        type Events = unsafe extern "C" fn(Object, c_int, Roots) -> c_int;
        let indicators = self.problem.equations.indicators() as c_int;
        let memory = self.memory;
        // SAFETY: as above; the problem lives as long as the solver, whose functions alone use it while it runs.
        let made = unsafe {
            [
                library.function::<Init>("CVodeInit")(memory, rates, 0.0, self.vector),
                library.function::<Tolerances>("CVodeSVtolerances")(memory, tolerance, self.tolerances),
                library.function::<User>("CVodeSetUserData")(memory, (&raw mut *self.problem).cast()),
                library.function::<Linear>("CVodeSetLinearSolver")(memory, self.linear, self.matrix),
                library.function::<Exact>("CVodeSetJacFn")(memory, jacobian),
                library.function::<Steps>("CVodeSetMaxNumSteps")(memory, 100_000_000),
                library.function::<Events>("CVodeRootInit")(memory, indicators, roots),
            ]
        };
        assert_eq!(made, [0; 7], "CVODE refuses its settings");
    }

    /// None if CVODE does not come to the end.
    fn go(&mut self, grid: Grid, wanted: usize) -> Option<Vec<f64>> {
        let size = self.problem.by_time.len();
        // SAFETY: the vector has `size` numbers.
        let states = unsafe { std::slice::from_raw_parts_mut((self.problem.data)(self.vector), size) };
        let mut column = vec![0.0; grid.len()];
        column[0] = states[wanted];
        let mut time = 0.0;
        for (number, value) in column.iter_mut().enumerate().skip(1) {
            while time < grid.time(number) {
                // SAFETY: see `new`.
                let status = unsafe { (self.cvode)(self.memory, grid.time(number), self.vector, &mut time, NORMAL) };
                if status < 0 {
                    return None;
                }
                if status == ROOT {
                    self.problem.equations.at_event(time, states).ok()?;
                    // SAFETY: see `new`.
                    unsafe { (self.restart)(self.memory, time, self.vector) };
                }
            }
            *value = states[wanted];
        }
        Some(column)
    }

    fn free(mut self, library: &Sundials) {
        type Free = unsafe extern "C" fn(Object);
        type FreeAt = unsafe extern "C" fn(*mut Object);
        // SAFETY: each object is freed once, the context last.
        unsafe {
            library.function::<FreeAt>("CVodeFree")(&mut self.memory);
            library.function::<Free>("SUNLinSolFree")(self.linear);
            library.function::<Free>("SUNMatDestroy")(self.matrix);
            library.function::<Free>("N_VDestroy")(self.vector);
            library.function::<Free>("N_VDestroy")(self.tolerances);
            library.function::<FreeAt>("SUNContext_Free")(&mut self.context);
        }
    }
}

/// Problem, and numbers of a vector.
///
/// # Safety
/// `user` is a problem, and the vector has as many numbers as it has states.
unsafe fn opened<'a>(user: *mut c_void, vector: Object) -> (&'a mut Problem<'a>, &'a mut [f64]) {
    // SAFETY: promised by the caller.
    unsafe {
        let problem: &mut Problem = &mut *user.cast();
        let numbers = std::slice::from_raw_parts_mut((problem.data)(vector), problem.by_time.len());
        (problem, numbers)
    }
}

unsafe extern "C" fn rates(time: f64, states: Object, rates: Object, user: *mut c_void) -> c_int {
    // SAFETY: CVODE passes what `Run::new` gave it.
    let ((_, rates), (problem, states)) = unsafe { (opened(user, rates), opened(user, states)) };
    problem.equations.rates(time, states, rates);
    c_int::from(!rates.iter().all(|rate| rate.is_finite()))
}

unsafe extern "C" fn jacobian(
    time: f64,
    states: Object,
    _: Object,
    matrix: Object,
    user: *mut c_void,
    _: Object,
    _: Object,
    _: Object,
) -> c_int {
    // SAFETY: as above; a dense matrix has size x size numbers, one column after the other.
    unsafe {
        let (problem, states) = opened(user, states);
        let size = states.len();
        let Problem { equations, row_major, by_time, .. } = problem;
        equations.jacobian(time, states, row_major, by_time);
        let columns = std::slice::from_raw_parts_mut((problem.matrix)(matrix), size * size);
        for (row, numbers) in problem.row_major.chunks(size).enumerate() {
            for (column, number) in numbers.iter().enumerate() {
                columns[column * size + row] = *number;
            }
        }
    }
    0
}

unsafe extern "C" fn roots(time: f64, states: Object, indicators: *mut f64, user: *mut c_void) -> c_int {
    // SAFETY: as above; there is room for all indicators.
    unsafe {
        let (problem, states) = opened(user, states);
        let count = problem.equations.indicators();
        problem.equations.indicate(time, states, std::slice::from_raw_parts_mut(indicators, count));
    }
    0
}
