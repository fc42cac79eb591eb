//! Warnings: what mdBook logs while it builds, collected, so that a warning fails the build.
//!
//! mdBook reports unclosed HTML tags, for one, through the `tracing` crate and carries on.

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use tracing::field::{Field, Visit};
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Level, Metadata, Subscriber};

/// Runs `work`, and returns its result with the warnings and errors that it logged.
pub fn collect<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    let log = Arc::new(Mutex::new(Vec::new()));
    let result = tracing::subscriber::with_default(Collector(Arc::clone(&log)), work);
    let warnings = std::mem::take(&mut *log.lock().unwrap_or_else(PoisonError::into_inner));
    (result, warnings)
}

struct Collector(Arc<Mutex<Vec<String>>>);

impl Subscriber for Collector {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        *metadata.level() <= Level::WARN
    }

    fn event(&self, event: &Event<'_>) {
        event.record(&mut Message(&self.0));
    }

    // Spans only group messages; here they all are one.
    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }
    fn record(&self, _: &Id, _: &Record<'_>) {}
    fn record_follows_from(&self, _: &Id, _: &Id) {}
    fn enter(&self, _: &Id) {}
    fn exit(&self, _: &Id) {}
}

struct Message<'a>(&'a Mutex<Vec<String>>);

impl Visit for Message<'_> {
    fn record_debug(&mut self, field: &Field, value: &dyn fmt::Debug) {
        if field.name() == "message" {
            let mut log = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            log.push(format!("{value:?}"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::collect;

    #[test]
    fn warnings_are_collected_and_chatter_is_not() {
        let (result, warnings) = collect(|| {
            tracing::info!("building");
            tracing::warn!("unclosed tag {}", "<p>");
            7
        });
        assert_eq!(result, 7, "the work's own result");
        assert_eq!(warnings, ["unclosed tag <p>"], "one warning");
    }
}
