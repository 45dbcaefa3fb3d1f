//! Cost of one evaluation of a friction model: as a Rust struct, and through the FMI functions of the shipped library.

mod support;

use std::hint::black_box;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use stribeck::catalogue::{self, Family};
use stribeck::friction::{BrownMcPhee, CoulombStiction, Dahl, Karnopp, LuGre};
use stribeck::model::Model;

/// Runs `$bench` on each model of the list, with the function that sets its velocity.
macro_rules! each_model {
    ($bench:ident, $group:expr, $($Model:ident),+) => {
        $($bench($group, stringify!($Model), $Model::default(), |law, velocity| law.velocity = velocity);)+
    };
}

/// Calls `measured` with one velocity after another.
fn along_the_motion(group: &mut BenchmarkGroup<WallTime>, name: &str, mut measured: impl FnMut(f64)) {
    let velocities = support::velocities();
    let mut velocities = velocities.iter().cycle();
    group.bench_function(name, |bencher| {
        bencher.iter(|| measured(*velocities.next().expect("a cycle is endless")));
    });
}

fn bench_output<M: Model>(group: &mut BenchmarkGroup<WallTime>, name: &str, mut law: M, set: fn(&mut M, f64)) {
    // A little history, so that laws with memory are evaluated in the middle of their motion.
    set(&mut law, 1e-3);
    law.step(support::STEP);
    along_the_motion(group, name, |velocity| {
        set(&mut law, velocity);
        black_box(&mut law).output();
    });
}

fn bench_step<M: Model>(group: &mut BenchmarkGroup<WallTime>, name: &str, mut law: M, set: fn(&mut M, f64)) {
    along_the_motion(group, name, |velocity| {
        set(&mut law, velocity);
        black_box(&mut law).step(support::STEP);
    });
}

fn output(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("output");
    each_model!(bench_output, &mut group, CoulombStiction, Karnopp, BrownMcPhee, Dahl, LuGre);
}

fn step(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("step");
    each_model!(bench_step, &mut group, CoulombStiction, Karnopp, BrownMcPhee, Dahl, LuGre);
}

/// Set two inputs, step, get two outputs.
fn fmi(criterion: &mut Criterion) {
    let library = support::library();
    let mut group = criterion.benchmark_group("fmi");
    for (model, _) in catalogue::documented(Family::Friction) {
        bench_slave(&mut group, model.name, support::Slave::ours(&library, model.name));
    }
    for law in ["trivial", "brown_mcphee", "lugre"] {
        bench_slave(&mut group, &format!("floor in C: {law}"), support::Slave::floor(law));
    }
}

fn bench_slave(group: &mut BenchmarkGroup<WallTime>, name: &str, mut slave: support::Slave) {
    let mut refused = 0;
    along_the_motion(group, name, |velocity| {
        let (outputs, status) = slave.round_trip(velocity);
        refused |= status;
        black_box(outputs);
    });
    assert_eq!(refused, 0, "{name}: a call failed");
}

/// With criterion's own times the whole list would take eight minutes.
fn short() -> Criterion {
    Criterion::default().warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2))
}

criterion_group!(name = benches; config = short(); targets = output, step, fmi);
criterion_main!(benches);
