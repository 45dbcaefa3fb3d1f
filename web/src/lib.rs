//! The library behind the page: a question as JSON in, an answer as JSON with arrays out.
//!
//! A host writes the bytes of a question into a buffer of [`stribeck_alloc`] and calls [`stribeck_ask`], which takes the
//! buffer. The answer begins with the length of its JSON and the number of numbers in its arrays, as two integers of 32
//! bits; the JSON follows, filled up with spaces to a multiple of 8 bytes, then the numbers, 8 bytes each. It lies at
//! [`stribeck_answer`] until the next question. A host of the WebAssembly hears of a search that is under way through
//! the import `page.progress`, and ends it by an answer other than 0: the best so far is kept.

mod answer;
mod catalogue;
mod copied;
mod parameters;
mod program;
mod progress;
mod question;
mod rig;
mod series;
mod solution;
mod strokes;
mod system;
#[cfg(not(target_family = "wasm"))]
mod types;
mod values;

use std::cell::RefCell;

thread_local! {
    /// Buffers of the host and the last answer.
    static DESK: RefCell<Desk> = const { RefCell::new(Desk { question: Vec::new(), answer: Vec::new() }) };
}

struct Desk {
    question: Vec<u8>,
    answer: Vec<u64>,
}

/// A buffer for a question of `length` bytes; it is valid until [`stribeck_ask`].
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_alloc(length: usize) -> *mut u8 {
    DESK.with_borrow_mut(|desk| {
        desk.question.clear();
        desk.question.resize(length, b' ');
        desk.question.as_mut_ptr()
    })
}

/// Answers the question in the buffer; returns the length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_ask() -> usize {
    let question = DESK.with_borrow_mut(|desk| std::mem::take(&mut desk.question));
    laid(question::answer(&question))
}

/// As [`stribeck_ask`]; the answer is the text of all questions and answers as types of TypeScript, for those who build
/// the page.
#[cfg(not(target_family = "wasm"))]
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_types() -> usize {
    laid(answer::Answer::plain(answer::Text { text: types::types() }))
}

/// Keeps an answer for the host; returns its length in bytes.
fn laid(answer: answer::Answer) -> usize {
    let packed = answer.packed();
    DESK.with_borrow_mut(|desk| {
        desk.answer = packed;
        8 * desk.answer.len()
    })
}

/// Where the last answer lies.
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_answer() -> *const u8 {
    DESK.with_borrow(|desk| desk.answer.as_ptr().cast())
}
