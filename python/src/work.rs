//! Work without the interpreter's lock, which Ctrl-C ends.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

/// Time between two looks for an interrupt.
const PATIENCE: Duration = Duration::from_millis(50);

/// Runs long work in a thread of its own. Ctrl-C sets the flag, on which the work must end early.
pub fn interruptible<T: Send>(py: Python, work: impl FnOnce(&AtomicBool) -> T + Send) -> PyResult<T> {
    watched(py, work, |_| Ok(()))
}

/// As `interruptible`; now and then, and at the end, the calling thread looks at the work. An error there ends it too.
pub fn watched<T: Send>(
    py: Python,
    work: impl FnOnce(&AtomicBool) -> T + Send,
    look: impl Fn(Python) -> PyResult<()> + Sync,
) -> PyResult<T> {
    let cancel = &AtomicBool::new(false);
    let (done, interrupt) = py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = channel();
            let worker = scope.spawn(move || {
                // The receiver lives until it has received this.
                let _ = sender.send(work(cancel));
            });
            let ended = wait(&receiver, cancel, &look);
            worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            ended
        })
    });
    match (done, interrupt) {
        (_, Some(error)) => Err(error),
        (Some(done), None) => look(py).map(|()| done),
        (None, None) => Err(crate::refused("the work ended without a result")),
    }
}

/// Waits for the result of the work, and for an interrupt.
fn wait<T>(
    receiver: &Receiver<T>,
    cancel: &AtomicBool,
    look: impl Fn(Python) -> PyResult<()>,
) -> (Option<T>, Option<PyErr>) {
    let mut interrupt = None;
    loop {
        match receiver.recv_timeout(PATIENCE) {
            Ok(done) => return (Some(done), interrupt),
            Err(RecvTimeoutError::Disconnected) => return (None, interrupt),
            Err(RecvTimeoutError::Timeout) if interrupt.is_some() => {}
            Err(RecvTimeoutError::Timeout) => {
                if let Err(error) = Python::attach(|py| py.check_signals().and_then(|()| look(py))) {
                    cancel.store(true, Ordering::Relaxed);
                    interrupt = Some(error);
                }
            }
        }
    }
}

/// The number of threads that was asked for, or of all processors.
pub fn threads(asked: Option<usize>) -> PyResult<NonZeroUsize> {
    let Some(asked) = asked else { return Ok(thread::available_parallelism().unwrap_or(NonZeroUsize::MIN)) };
    NonZeroUsize::new(asked).ok_or_else(|| crate::refused(format_args!("threads = {asked}: must be >= 1")))
}
