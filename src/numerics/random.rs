//! Random numbers that are functions of a count, so that the same question has the same numbers in whatever order.
//!
//! Steele, Lea, Flood (2014), doi:10.1145/2660193.2660195.

/// Random number k of a sequence of a seed, uniform in (0, 1]: a counter, mixed twice.
pub(crate) fn uniform(seed: i32, sequence: u64, k: u64) -> f64 {
    uniform_of(key(seed, sequence), k)
}

/// Key of a sequence of a seed: two mixes, which all its numbers share.
pub(crate) fn key(seed: i32, sequence: u64) -> u64 {
    mix(mix(seed as u64).wrapping_add(sequence))
}

/// Random number k of the sequence with a key.
pub(crate) fn uniform_of(key: u64, k: u64) -> f64 {
    let bits = mix(key.wrapping_add(k.wrapping_mul(0x9E37_79B9_7F4A_7C15)));
    // A number with sign is converted by one instruction.
    ((bits >> 11) + 1) as i64 as f64 / (1u64 << 53) as f64
}

/// The mixing function of SplitMix64.
fn mix(number: u64) -> u64 {
    let z = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first outputs of SplitMix64 with the state 1234567, from the reference implementation of S. Vigna.
    #[test]
    fn mixing_function_is_that_of_splitmix64() {
        let gamma = 0x9E37_79B9_7F4A_7C15u64;
        let outputs = [0u64, 1, 2].map(|k| mix(1_234_567u64.wrapping_add(k.wrapping_mul(gamma))));
        assert_eq!(outputs, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    /// Mean 1/2 and variance 1/12, and neighbours in seed, sequence and k are not correlated: 4 standard errors each.
    #[test]
    fn random_numbers_are_uniform_and_independent() {
        let n = 100_000;
        let sequence = |f: &dyn Fn(i32) -> f64| (0..n).map(f).collect::<Vec<_>>();
        let sequences = [
            sequence(&|k| uniform(3, 7, k as u64)),
            sequence(&|k| uniform(3, k as u64, 7)),
            sequence(&|k| uniform(k - n / 2, 3, 7)),
        ];
        for values in sequences {
            let error = (1.0 / f64::from(n)).sqrt();
            let mean = values.iter().sum::<f64>() / f64::from(n);
            let variance = values.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>() / f64::from(n);
            let next = values.windows(2).map(|w| (w[0] - 0.5) * (w[1] - 0.5)).sum::<f64>() / f64::from(n);
            assert!((mean - 0.5).abs() < 4.0 * error / 12f64.sqrt(), "{mean}");
            assert!((variance - 1.0 / 12.0).abs() < 4.0 * error / 180f64.sqrt(), "{variance}");
            assert!(next.abs() < 4.0 * error / 12.0, "{next}");
        }
    }
}
