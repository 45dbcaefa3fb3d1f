//! The allocator: a fixed room, from which one allocation follows the other.
//!
//! What an instance keeps is allocated when it is made. Whatever a later call allocates is given back before it returns,
//! and then the room is as it was: [`Room::keep`] says from where on.

use std::alloc::{GlobalAlloc, Layout};
use std::cell::UnsafeCell;
use std::ptr::null_mut;

use stribeck::model::Model;

use crate::model::{COLUMNS, Chosen};

/// Numbers that an instance and a saved state keep for each column and each value of the memory: row, workspace, rates,
/// slopes, dual numbers and their rates, a snapshot, the directions and slopes of derivatives, the bytes of a state.
const PER_COLUMN: usize = 17;
const PER_VALUE: usize = 8;

/// Number of values that the model keeps beside its row.
const MEMORY: usize = <Chosen as Model>::MEMORY;

/// What does not grow with the model: texts, and the records themselves.
const REST: usize = 3072;

/// Size of the room.
const SIZE: usize = 8 * (PER_COLUMN * COLUMNS + PER_VALUE * MEMORY) + REST;

/// Its bytes, which are reached by their address only.
#[repr(align(16))]
struct Bytes(#[expect(dead_code, reason = "their address")] [u8; SIZE]);

/// The room.
pub struct Room {
    bytes: UnsafeCell<Bytes>,
    marks: UnsafeCell<Marks>,
}

#[derive(Clone, Copy)]
struct Marks {
    top: usize,
    /// Allocations that have not been given back.
    count: usize,
    kept_top: usize,
    kept_count: usize,
}

// SAFETY: the module has one thread.
unsafe impl Sync for Room {}

#[global_allocator]
static ROOM: Room = Room {
    bytes: UnsafeCell::new(Bytes([0; SIZE])),
    marks: UnsafeCell::new(Marks { top: 0, count: 0, kept_top: 0, kept_count: 0 }),
};

/// Keeps what has been allocated so far.
pub fn keep() {
    // SAFETY: the module has one thread, and nobody else holds a reference to the marks.
    let marks = unsafe { &mut *ROOM.marks.get() };
    (marks.kept_top, marks.kept_count) = (marks.top, marks.count);
}

// SAFETY: allocations do not overlap, and lie in the room.
unsafe impl GlobalAlloc for Room {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the module has one thread, and no reference to the marks outlives a call.
        let marks = unsafe { &mut *self.marks.get() };
        let start = marks.top.next_multiple_of(layout.align());
        match start.checked_add(layout.size()) {
            Some(end) if end <= SIZE && layout.align() <= 16 => {
                marks.top = end;
                marks.count += 1;
                // SAFETY: start lies in the room.
                unsafe { self.bytes.get().cast::<u8>().add(start) }
            }
            _ => null_mut(),
        }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as in `alloc`.
        let marks = unsafe { &mut *self.marks.get() };
        let start = pointer.addr() - self.bytes.get().addr();
        marks.count -= 1;
        if start + layout.size() == marks.top {
            marks.top = start;
        }
        if marks.count == marks.kept_count {
            marks.top = marks.kept_top;
        }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as in `alloc`.
        let marks = unsafe { &mut *self.marks.get() };
        let start = pointer.addr() - self.bytes.get().addr();
        if start + layout.size() == marks.top && start.checked_add(size).is_some_and(|end| end <= SIZE) {
            marks.top = start + size;
            return pointer;
        }
        // SAFETY: the caller's promise about layout and size.
        let new = unsafe { self.alloc(Layout::from_size_align_unchecked(size, layout.align())) };
        if !new.is_null() {
            // SAFETY: both have room for the smaller of the two sizes, and do not overlap.
            unsafe { new.copy_from_nonoverlapping(pointer, layout.size().min(size)) };
            // SAFETY: the caller gives the old one up.
            unsafe { self.dealloc(pointer, layout) };
        }
        new
    }
}
