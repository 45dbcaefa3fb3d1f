//! Work that threads share.

use std::sync::Mutex;
use std::thread;

/// Runs numbered pieces of work in order, on at most `threads` threads. `begin` is called before each piece, by one thread
/// at a time, and ends the work by returning false; `worker` returns the function that does the pieces of one thread.
pub fn share<W: FnMut(usize)>(
    pieces: usize,
    threads: usize,
    begin: impl FnMut(usize) -> bool + Send,
    worker: impl Fn() -> W + Sync,
) {
    let left = Mutex::new((0..pieces, begin));
    let pick = || {
        let mut left = left.lock().ok()?;
        let (numbers, begin) = &mut *left;
        let number = numbers.next()?;
        if !begin(number) {
            *numbers = 0..0;
            return None;
        }
        Some(number)
    };
    let work = || {
        let mut make = worker();
        while let Some(piece) = pick() {
            make(piece);
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(pieces) {
            // Where the system has no more threads, those that there are do the work.
            let _ = thread::Builder::new().spawn_scoped(scope, work);
        }
        work();
    });
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    /// Pieces begin in order and are done once each; none begins after a refusal.
    #[test]
    fn pieces_are_made_once_until_the_work_ends() {
        for threads in [1, 2, 7] {
            for last in [0, 3, 50, 1000] {
                let (mut begun, made, workers) = (Vec::new(), Mutex::new(Vec::new()), AtomicUsize::new(0));
                let begin = |piece: usize| {
                    begun.push(piece);
                    piece < last
                };
                share(100, threads, begin, || {
                    workers.fetch_add(1, Ordering::Relaxed);
                    |piece| made.lock().unwrap().push(piece)
                });
                let mut made = made.into_inner().unwrap();
                made.sort_unstable();
                let expected = last.min(100);
                assert_eq!(made, (0..expected).collect::<Vec<_>>());
                assert_eq!(begun, (0..100.min(expected + 1)).collect::<Vec<_>>());
                assert!(workers.into_inner() <= threads);
            }
        }
    }
}
