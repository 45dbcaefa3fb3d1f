//! Answers: JSON and arrays, packed into one buffer.

use serde::Serialize;
use serde_json::{Value, json};
use ts_rs::TS;

/// A text.
#[derive(Debug, Serialize, TS)]
#[ts(rename = "Written")]
pub struct Text {
    /// The text.
    pub text: String,
}

/// An answer.
pub struct Answer {
    json: Value,
    arrays: Vec<Vec<f64>>,
}

impl Answer {
    /// An answer without arrays.
    pub fn plain(json: impl Serialize) -> Answer {
        Answer::with(json, Vec::new())
    }

    /// An answer with arrays of numbers; the JSON says what each is.
    pub fn with(json: impl Serialize, arrays: Vec<Vec<f64>>) -> Answer {
        match serde_json::to_value(json) {
            Ok(json) => Answer { json, arrays },
            Err(fault) => Answer::refusal(fault),
        }
    }

    /// A refusal with its reason.
    pub fn refusal(reason: impl std::fmt::Display) -> Answer {
        Answer { json: json!({ "refused": reason.to_string() }), arrays: Vec::new() }
    }

    /// The answer as words of 8 bytes.
    pub fn packed(self) -> Vec<u64> {
        let lengths: Vec<usize> = self.arrays.iter().map(Vec::len).collect();
        let mut text = json!({ "answer": self.json, "lengths": lengths }).to_string().into_bytes();
        text.resize(text.len().next_multiple_of(8), b' ');
        let numbers: usize = lengths.iter().sum();
        let mut words = Vec::with_capacity(1 + text.len() / 8 + numbers);
        words.push(text.len() as u64 | (numbers as u64) << 32);
        words.extend(text.as_chunks::<8>().0.iter().map(|bytes| u64::from_le_bytes(*bytes)));
        words.extend(self.arrays.iter().flatten().map(|number| number.to_bits()));
        words
    }
}
