//! Friction models behind the FMI functions of a shared library: Stribeck's, and the C floors in `benches/floor`.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::ffi::{CStr, CString, c_char, c_int, c_uint, c_void};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::ptr;

use libloading::Library;
use stribeck::catalogue;

/// Communication step of every measurement.
pub const STEP: f64 = 1e-4;

/// Two periods of a motion that spends its time in the pre-sliding range, at the Stribeck velocity and in sliding.
/// Branches and transcendental functions get the arguments of a stick-slip run, not a single lucky number.
pub fn velocities() -> Vec<f64> {
    (0..1024).map(|k| 0.005 * f64::sin(4.0 * std::f64::consts::PI * f64::from(k) / 1024.0)).collect()
}

type Component = *mut c_void;
type SetReal = unsafe extern "C" fn(Component, *const c_uint, usize, *const f64) -> c_int;
type GetReal = unsafe extern "C" fn(Component, *const c_uint, usize, *mut f64) -> c_int;
type DoStep = unsafe extern "C" fn(Component, f64, f64, c_int) -> c_int;
type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char);

/// fmi2CallbackFunctions. The logger is called with further arguments that it does not read.
#[repr(C)]
struct Callbacks {
    logger: Logger,
    allocate_memory: *const c_void,
    free_memory: *const c_void,
    step_finished: *const c_void,
    environment: *mut c_void,
}

unsafe extern "C" fn print(_: *mut c_void, _: *const c_char, _: c_int, category: *const c_char, text: *const c_char) {
    // SAFETY: FMI promises two strings.
    let [category, text] = unsafe { [CStr::from_ptr(category), CStr::from_ptr(text)] };
    eprintln!("{}: {}", category.to_string_lossy(), text.to_string_lossy());
}

/// A slave in its stepping mode.
pub struct Slave {
    component: Component,
    set_real: SetReal,
    get_real: GetReal,
    do_step: DoStep,
    free: unsafe extern "C" fn(Component),
    inputs: [c_uint; 2],
    outputs: [c_uint; 2],
    time: f64,
    // Dropped last: it contains the functions above.
    _library: Library,
}

impl Slave {
    /// A model of Stribeck's release library.
    pub fn ours(library: &Path, model: &str) -> Slave {
        let model = catalogue::by_name(model).unwrap_or_else(|| panic!("no model {model}"));
        let reference = |name: &str| {
            // Laws in a plane and in space are moved along x.
            let found = model.find(name).or_else(|| model.find(&format!("{name}_x")));
            model.reference(found.unwrap_or_else(|| panic!("{} has no {name}", model.name)))
        };
        let inputs = ["velocity", "normal_force"].map(reference);
        let outputs = ["friction_force", "dissipated_power"].map(reference);
        Slave::load(library, model.guid(), inputs, outputs)
    }

    /// A law of `benches/floor`; all of them begin with the same four columns.
    pub fn floor(law: &str) -> Slave {
        Slave::load(&compile_floor(law), "", [0, 1], [2, 3])
    }

    fn load(library: &Path, guid: &str, inputs: [c_uint; 2], outputs: [c_uint; 2]) -> Slave {
        let guid = CString::new(guid).expect("a guid has no zero byte");
        let callbacks = Callbacks {
            logger: print,
            allocate_memory: ptr::null(),
            free_memory: ptr::null(),
            step_finished: ptr::null(),
            environment: ptr::null_mut(),
        };
        // SAFETY: the signatures are those of FMI 2.0 section 2.1 and 4.2, which both kinds of library follow; the
        // component is used with the library that made it, and freed before the library is unloaded.
        unsafe {
            let library = Library::new(library).unwrap_or_else(|error| panic!("{}: {error}", library.display()));
            let instantiate: unsafe extern "C" fn(
                *const c_char,
                c_int,
                *const c_char,
                *const c_char,
                *const Callbacks,
                c_int,
                c_int,
            ) -> Component = symbol(&library, "fmi2Instantiate");
            let setup: unsafe extern "C" fn(Component, c_int, f64, f64, c_int, f64) -> c_int =
                symbol(&library, "fmi2SetupExperiment");
            let enter: unsafe extern "C" fn(Component) -> c_int = symbol(&library, "fmi2EnterInitializationMode");
            let exit: unsafe extern "C" fn(Component) -> c_int = symbol(&library, "fmi2ExitInitializationMode");
            let co_simulation = 1;
            let component = instantiate(c"bench".as_ptr(), co_simulation, guid.as_ptr(), ptr::null(), &callbacks, 0, 1);
            assert!(!component.is_null(), "fmi2Instantiate failed");
            let statuses = [setup(component, 0, 0.0, 0.0, 0, 0.0), enter(component), exit(component)];
            assert_eq!(statuses, [0; 3], "initialisation");
            Slave {
                component,
                set_real: symbol(&library, "fmi2SetReal"),
                get_real: symbol(&library, "fmi2GetReal"),
                do_step: symbol(&library, "fmi2DoStep"),
                free: symbol(&library, "fmi2FreeInstance"),
                inputs,
                outputs,
                time: 0.0,
                _library: library,
            }
        }
    }

    /// Sets two inputs, makes a step, gets two outputs. Returns the sum of the statuses for the caller to check.
    #[inline(always)]
    pub fn round_trip(&mut self, velocity: f64) -> ([f64; 2], c_int) {
        let given = [velocity, 9.81];
        let mut got = [0.0; 2];
        // SAFETY: the arrays have two elements each, as given.
        let status = unsafe {
            (self.set_real)(self.component, self.inputs.as_ptr(), 2, given.as_ptr())
                + (self.do_step)(self.component, self.time, STEP, 1)
                + (self.get_real)(self.component, self.outputs.as_ptr(), 2, got.as_mut_ptr())
        };
        self.time += STEP;
        (got, status)
    }
}

impl Drop for Slave {
    fn drop(&mut self) {
        // SAFETY: made by fmi2Instantiate of the same library, freed once.
        unsafe { (self.free)(self.component) }
    }
}

/// A function of a library.
///
/// # Safety
/// `F` must be the type of the function.
unsafe fn symbol<F: Copy>(library: &Library, name: &str) -> F {
    // SAFETY: the caller's promise.
    unsafe { *library.get(name.as_bytes()).unwrap_or_else(|error| panic!("{name}: {error}")) }
}

/// The target directory of the build that runs.
fn target_directory() -> &'static Path {
    Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("Cargo's folder for temporary files lies in the target folder")
}

fn library_file(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{DLL_PREFIX}{name}{DLL_SUFFIX}"))
}

/// The library as it is shipped. Where a benchmark only has to run once (`cargo test`), the one that the tests have built.
pub fn library() -> PathBuf {
    let (profile, folder): (&[&str], &str) = if std::env::args().any(|argument| argument == "--bench") {
        (&["--release", "--package", "libstribeck"], "release")
    } else {
        // With the workspace and a benchmark, crates have the features with which the tests have built them.
        (&["--workspace", "--bench", "stribeck"], "debug")
    };
    run(Command::new(env!("CARGO"))
        .args(["build", "--lib", "--quiet", "--target-dir"])
        .arg(target_directory())
        .args(profile)
        .current_dir(env!("CARGO_MANIFEST_DIR")));
    library_file(&target_directory().join(folder), "stribeck")
}

fn compile_floor(law: &str) -> PathBuf {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/floor").join(format!("{law}.c"));
    let library = library_file(Path::new(env!("CARGO_TARGET_TMPDIR")), &format!("floor_{law}"));
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_string());
    run(Command::new(compiler)
        .args(["-std=c99", "-O3", "-fPIC", "-shared", "-o"])
        .args([&library, &source])
        .arg("-lm"));
    library
}

fn run(command: &mut Command) {
    match command.status() {
        Ok(status) => assert!(status.success(), "{command:?}: {status}"),
        Err(error) => panic!("{command:?}: {error}"),
    }
}
