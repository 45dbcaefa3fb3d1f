//! Parameters and motions that are refused, and what the messages say.

use crate::{TABLE, law, strut};

#[test]
fn impossible_parameters_are_refused_by_name() {
    let cases: [(&[(&str, f64)], &str); 8] = [
        (&[("c1.mu_s", 0.05)], "c1.mu_s = 0.05: must be >= c1.mu_k = 0.1"),
        (&[("c2.preload_s", 1.0)], "c2.preload_s = 1: must be >= c2.preload_k = 6"),
        (&[("adapter.length_gain", 0.0)], "adapter.length_gain = 0: must not be 0"),
        (&[TABLE, ("damper.tab_v[2]", -1.0)], "damper.tab_v[2] = -1: must be > damper.tab_v[1] = -1"),
        (&[("spring.mode", 2.0), ("spring.tab_x[2]", 0.0)], "spring.tab_x[2] = 0: must be > spring.tab_x[1] = 0"),
        (&[("gas.V0", 8e-6)], "gas.V0 = 0.000008 m3: must be > "),
        (&[law("LuGre"), ("friction.sigma_1", -1.0)], "friction.sigma_1 = -1: must be "),
        (&[("c1.preload_k", 0.0)], "c1.preload_k = 0: must be > 0 because c1.preload_s = 10 is"),
    ];
    for (set, expected) in cases {
        let mut strut = strut(&[]);
        let refused = set.iter().find_map(|(name, value)| {
            let column = strut.column(name);
            let variable = strut.instance.variable(column).unwrap();
            if !variable.admits(*value) {
                return Some(variable.fault(*value));
            }
            strut.set(name, *value);
            None
        });
        let fault = refused.or_else(|| strut.instance.check().err()).unwrap_or_else(|| panic!("admitted: {expected}"));
        assert!(fault.to_string().starts_with(expected), "{fault}");
    }
}

/// Where the rod would fill the gas volume, the message names the compression and its limit.
#[test]
fn a_strut_without_gas_volume_left_says_so() {
    let mut strut = strut(&[("gas.V0", 1e-5)]);
    strut.set("length", 0.12);
    let text = strut.instance.refresh().unwrap_err().to_string();
    assert!(text.contains("compression = 0.08") && text.contains("m: must be < 0.06496"), "{text}");
    let text = strut.instance.step(1e-3).unwrap_err().to_string();
    assert!(text.contains("m: must be < 0.06496"), "{text}");
}

/// Where guide and piston meet, nothing carries the couple of a side load: the message names the overlap and its limit.
#[test]
fn a_strut_without_overlap_left_says_so() {
    let mut strut = strut(&[("geom.h_reg", 0.0), ("side_force_m", 100.0)]);
    let end = strut.instance.row()[strut.column("length")] + strut.get("overlap");
    strut.set("length", end);
    let text = strut.instance.refresh().unwrap_err().to_string();
    assert!(text.contains("overlap = ") && text.contains("with geom.h_reg = 0 m"), "{text}");
    let text = strut.instance.step(1e-3).unwrap_err().to_string();
    assert!(text.contains("with geom.h_reg = 0 m"), "{text}");
}

/// A step that moves the length with the velocity until no gas volume is left is refused, and the length stays.
#[test]
fn a_refused_step_along_the_motion_changes_nothing() {
    let mut strut = strut(&[("num.input_mode", 2.0), ("gas.V0", 1e-5), ("velocity", -1.0)]);
    strut.step(1e-3);
    let before = strut.instance.save();
    let text = strut.instance.step(0.2).unwrap_err().to_string();
    assert!(text.ends_with("nothing was changed"), "{text}");
    assert_eq!(strut.instance.save(), before);
    strut.step(1e-3);
}
