//! Passivity of a contact and of a strut: what they say, in the names of their own parameters, under any load.

use crate::common::Bench;
use crate::common::random::Random;
use crate::{law, strut};

fn said(bench: &Bench) -> Option<String> {
    bench.instance.model().passivity(bench.instance.row()).map(|fault| fault.to_string())
}

/// The parameter that a text names, and the value that it gives as the limit.
fn limit(text: &str) -> (&str, f64) {
    let mut words = text.split_whitespace();
    let name = words.next().unwrap();
    let rest: Vec<&str> = words.skip_while(|word| !["below", "above"].contains(word)).collect();
    let value = if rest[0] == "below" { rest[1] } else { rest[3] };
    (name, value.parse().unwrap())
}

fn drawn(random: &mut Random, from: f64, to: f64) -> f64 {
    from * (to / from).powf(random.next())
}

/// Levels, bristles and factors of a contact, whose levels have this prefix.
fn draw(bench: &mut Bench, random: &mut Random, parts: &[&str]) {
    for part in parts {
        for (name, from, to) in [("mu", 0.02, 0.3), ("preload", 1.0, 20.0)] {
            let kinetic = drawn(random, from, to);
            bench.set(&format!("{part}{name}_k"), kinetic);
            bench.set(&format!("{part}{name}_s"), kinetic * drawn(random, 1.0, 3.0));
        }
    }
    bench.set("friction.sigma_1", drawn(random, 30.0, 3e3));
    bench.set("friction.stribeck_velocity", drawn(random, 1e-4, 1e-1));
    bench.set("friction.damping_velocity", if random.next() < 0.5 { 0.0 } else { drawn(random, 1e-3, 1.0) });
    bench.set("friction.scale", drawn(random, 0.3, 3.0));
    bench.set("friction.asymmetry", 1.6 * random.next() - 0.8);
}

fn press(bench: &mut Bench, load: f64) {
    let name = if bench.instance.model().name == "GuideContact" { "normal_force" } else { "side_force_m" };
    bench.set(name, load);
}

/// Lets go whatever an earlier motion has deflected.
fn release(bench: &mut Bench) {
    let scale = bench.get("friction.scale");
    bench.set("velocity", 0.0);
    bench.set("friction.scale", 0.0);
    bench.step(1e-3);
    bench.set("friction.scale", scale);
}

/// Least energy that the contacts have taken, from released bristles on: deflected up to the static level, then in jumps,
/// under loads that jump too.
fn least_energy(bench: &mut Bench, random: &mut Random, loads_jump: bool) -> f64 {
    let mut least = 0.0f64;
    press(bench, drawn(random, 1e-2, 1e3));
    for _ in 0..4 {
        release(bench);
        let before = bench.get("dissipated_energy");
        bench.set("velocity", 1e-5);
        bench.step(100.0);
        for _ in 0..15 {
            let speed = drawn(random, 1e-5, 10.0);
            bench.set("velocity", if random.next() < 0.5 { speed } else { -speed });
            if loads_jump && random.next() < 0.5 {
                press(bench, drawn(random, 1e-2, 1e3));
            }
            bench.step(drawn(random, 1e-8, 1e-3));
            least = least.min(bench.get("dissipated_energy") - before);
        }
    }
    least
}

/// A contact, or a strut without a damper whose loads are those of its inputs.
fn benches(name: &str) -> [(Bench, &'static [&'static str]); 2] {
    let free = [("damper.enabled", 0.0), ("side.mode", 1.0), law(name)];
    [(Bench::new("GuideContact", &[law(name)]), &["levels."]), (strut(&free), &["c1.", "c2."])]
}

#[test]
fn the_value_that_is_named_keeps_contact_and_strut_passive() {
    let mut random = Random(43);
    for (name, has_bristles) in [
        ("LuGre", true),
        ("ElastoPlastic", true),
        ("CylinderFriction", true),
        ("Leuven", true),
        ("Gonthier", false),
        ("MaxwellSlip", false),
    ] {
        let mut named = 0;
        for _ in 0..12 {
            for (mut bench, parts) in benches(name) {
                draw(&mut bench, &mut random, parts);
                while let Some(text) = said(&bench) {
                    let (parameter, value) = limit(&text);
                    assert_eq!(parameter == "friction.viscous_coefficient", has_bristles, "{name}: {text}");
                    bench.set(parameter, value);
                    named += 1;
                    assert_ne!(said(&bench), Some(text), "{name}");
                }
                let energy = least_energy(&mut bench, &mut random, has_bristles);
                assert!(energy >= -1e-12, "{name}, {}: {energy} J", bench.instance.model().name);
            }
        }
        assert!(named >= 12, "{name}: {named}");
    }
}

/// Takes the value that the contact names, until it says nothing.
fn heed(contact: &mut Bench) {
    while let Some(text) = said(contact) {
        let (name, value) = limit(&text);
        contact.set(name, value);
    }
}

/// A load that falls leaves bristles up to the larger static level, also where the level of the motion is the smaller one.
#[test]
fn the_value_suffices_where_a_load_falls_in_the_weak_direction() {
    for (asymmetry, direction) in [(0.3, 1.0), (0.5, 1.0), (-0.5, -1.0)] {
        let contact = &mut Bench::new("GuideContact", &[("friction.asymmetry", asymmetry)]);
        heed(contact);
        press(contact, 100.0);
        contact.set("velocity", 1e-5 * direction);
        contact.step(100.0);
        press(contact, 0.0);
        contact.set("velocity", 10.0 * direction);
        contact.step(3e-6);
        let taken = contact.get("dissipated_energy");
        assert!(taken > 0.0, "{asymmetry}: {taken} J");
    }
}

/// Power that a contact of `LuGre` takes beside what its bristles store, over the viscous power: f v - sigma_0 z dz/dt.
fn share_taken(contact: &mut Bench, velocity: f64) -> f64 {
    contact.set("velocity", 0.0);
    let elastic = contact.get("friction_force");
    contact.set("velocity", velocity);
    let force = contact.get("friction_force");
    let [sigma_1, sigma_2, fading] =
        ["sigma_1", "viscous_coefficient", "damping_velocity"].map(|name| contact.get(&format!("friction.{name}")));
    let fade = if fading == 0.0 { 1.0 } else { (-(velocity / fading).powi(2)).exp() };
    let rate = (force - elastic - sigma_2 * velocity) / (sigma_1 * fade);
    (force * velocity - elastic * rate) / (sigma_2 * velocity * velocity)
}

/// At any speed right after a load has fallen, in both directions, also where the damping fades.
#[test]
fn the_value_leaves_no_power_to_bristles_whose_load_falls() {
    let (mut random, mut tight) = (Random(44), 0);
    for _ in 0..60 {
        let contact = &mut Bench::new("GuideContact", &[]);
        draw(contact, &mut random, &["levels."]);
        heed(contact);
        for direction in [1.0, -1.0] {
            press(contact, 1e3);
            contact.set("velocity", 1e-5 * direction);
            contact.step(1e4);
            press(contact, drawn(&mut random, 1e-3, 1e2));
            let fading = contact.get("friction.damping_velocity");
            let speeds = if fading == 0.0 { [1e-4, 10.0] } else { [1e-3 * fading, 2.5 * fading] };
            for _ in 0..40 {
                let speed = drawn(&mut random, speeds[0], speeds[1]) * direction;
                let share = share_taken(contact, speed);
                assert!(share > -1e-3, "{speed} m/s: {share}");
                tight += i32::from(share < 0.5);
            }
        }
    }
    assert!(tight > 100, "{tight}");
}

/// The preload alone needs more than the levels together with a load that has the larger ratio.
#[test]
fn the_smaller_ratio_of_the_levels_counts_where_it_needs_more() {
    let contact = &mut Bench::new(
        "GuideContact",
        &[
            ("levels.mu_k", 0.1),
            ("levels.mu_s", 0.275),
            ("levels.preload_k", 5.6),
            ("levels.preload_s", 9.3),
            ("friction.stribeck_velocity", 0.035),
            ("friction.sigma_1", 2150.0),
            ("friction.damping_velocity", 0.0405),
            ("friction.viscous_coefficient", 0.0),
        ],
    );
    heed(contact);
    let named = contact.get("friction.viscous_coefficient");
    let alone = Bench::new(
        "LuGre",
        &[
            ("mu_k", 1.0),
            ("mu_s", 9.3 / 5.6),
            ("normal_force", 5.6),
            ("stribeck_velocity", 0.035),
            ("sigma_1", 2150.0),
            ("damping_velocity", 0.0405),
            ("viscous_coefficient", 0.0),
        ],
    );
    let needed = limit(&said(&alone).unwrap()).1;
    assert!(needed > 3.0 && named >= needed, "{named} {needed}");
}

/// The level of the preload alone has the larger ratio here, and that under a large load the smaller one.
#[test]
fn the_ratio_of_the_levels_is_the_larger_one_of_preload_and_load() {
    let levels = [("levels.mu_s", 0.12), ("levels.preload_s", 16.0)];
    let text = said(&Bench::new("GuideContact", &levels)).unwrap();
    // sigma_1 (16 / 8 - 1), against sigma_1 (0.12 / 0.1 - 1)
    assert_eq!(limit(&text).0, "friction.viscous_coefficient");
    assert!((limit(&text).1 / 316.227766 - 1.0).abs() < 1e-5, "{text}");
    // The same sizes the other way round.
    let text = said(&Bench::new("GuideContact", &[("levels.mu_s", 0.2), ("levels.preload_s", 9.6)])).unwrap();
    assert!((limit(&text).1 / 316.227766 - 1.0).abs() < 1e-5, "{text}");
}

/// Deflected up to the static level, then moved at 100 m/s.
fn pushed(bench: &mut Bench, load: f64) {
    press(bench, load);
    bench.set("velocity", 1e-5);
    bench.step(5.0 * load.max(20.0));
    bench.set("velocity", 100.0);
}

#[test]
fn start_values_give_energy_back_unless_a_damper_takes_it() {
    let contact = &mut Bench::new("GuideContact", &[]);
    assert!(said(contact).is_some());
    pushed(contact, 20.0);
    contact.step(1e-5);
    let taken = contact.get("dissipated_energy");
    assert!(taken < -1e-3, "{taken} J");
    let scales = [(1.0, false), (0.18, false), (0.05, true), (0.0, true)];
    for (scale, gives_back) in scales {
        let mut strut = strut(&[("side.mode", 1.0), ("damper.scale", scale)]);
        let text = said(&strut);
        assert_eq!(text.is_some(), gives_back, "{scale} {text:?}");
        assert!(text.is_none_or(|text| text.starts_with("friction.viscous_coefficient = 0.1: below 158.114 ")));
        pushed(&mut strut, 500.0);
        let power = strut.get("dissipated_power");
        assert_eq!(power < 0.0, gives_back, "{scale} {power} W");
    }
    // A damper that heats up, yields or is not linear promises nothing.
    for set in [("thermal.enabled", 1.0), ("damper.k_series", 1e6), ("damper.mode", 2.0)] {
        assert!(said(&strut(&[set])).is_some(), "{set:?}");
    }
}

/// Contacts without stiction, without friction, or of a law that always is passive.
#[test]
fn passive_contacts_say_nothing() {
    for set in
        [("friction.switch", 2.0), ("friction.switch", 4.0), ("friction.scale", 0.0), law("Dahl"), law("Stribeck")]
    {
        assert_eq!(said(&Bench::new("GuideContact", &[set])), None, "{set:?}");
    }
}
