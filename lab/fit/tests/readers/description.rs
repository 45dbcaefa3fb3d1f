//! Descriptions of runs, studies and identifications: what is read is written and read again as the same.

use serde::Serialize;
use serde::de::DeserializeOwned;
use stribeck_fit::identify::{Inquiry, damper, tyre};
use stribeck_solve::{job, run, study};

pub fn read(bytes: &[u8]) {
    let text = &*String::from_utf8_lossy(bytes);
    again::<run::Configuration>(text);
    again::<study::Description>(text);
    again::<Inquiry>(text);
    again::<damper::Inquiry>(text);
    again::<tyre::Inquiry>(text);
    if let Ok(inquiry) = toml::from_str::<Inquiry>(text) {
        // A refusal is an answer as well.
        let (_, _, _) = (inquiry.settings(), inquiry.laws(), inquiry.command());
    }
}

fn again<T: DeserializeOwned + Serialize>(text: &str) {
    let Ok(found) = toml::from_str::<T>(text) else { return };
    let Ok(written) = job::text(&found) else { return };
    let read = toml::from_str::<T>(&written).unwrap_or_else(|error| panic!("{error}: {written}"));
    assert_eq!(job::text(&read).ok(), Some(written));
}
