//! Ctrl-C, which ends a render early but not without its picture.

use std::panic;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::{Error, atomic_file};

/// The exit status after an interrupt, as shells expect it: 128 + SIGINT.
pub(crate) const STATUS: u8 = 130;

/// Whether there is a picture to save: between the start of the render and the end of the run.
static SAVING: AtomicBool = AtomicBool::new(false);

/// Whether Ctrl-C was pressed in that time.
static STOP: AtomicBool = AtomicBool::new(false);

/// Listens for Ctrl-C, SIGTERM and a closed terminal from now on.
///
/// During the render the first one stops it, so that what there is can be written. Before, there
/// is nothing to write; and whoever presses twice wants out at once.
///
/// A panic ends a release build at once, too, and nothing that is half written stays behind.
pub(crate) fn listen() -> Result<(), Error> {
    let report = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        report(info);
        atomic_file::remove_unfinished();
    }));
    let handler = || {
        if !SAVING.load(Ordering::SeqCst) || STOP.swap(true, Ordering::SeqCst) {
            atomic_file::remove_unfinished();
            process::exit(i32::from(STATUS));
        }
    };
    ctrlc::set_handler(handler).map_err(|error| Error::Threads(error.to_string()))
}

/// From now on, the first interrupt only sets [`stop`].
pub(crate) fn keep_the_picture() {
    SAVING.store(true, Ordering::SeqCst);
}

/// Whether the render should end now.
pub(crate) fn stop() -> bool {
    STOP.load(Ordering::Relaxed)
}
