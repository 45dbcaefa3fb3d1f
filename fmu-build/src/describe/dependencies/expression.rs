//! Expressions that a model's equations build, each stored once, so that equal ones have the same number.

use std::collections::{BTreeSet, HashMap};

use stribeck::number::Real;

/// Number of an expression.
pub type Id = u32;

/// An operation on one or two numbers that are results of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    Add,
    Sub,
    Mul,
    Div,
    Power,
    Neg,
    Abs,
    Sign,
    Exp,
    ExpM1,
    Ln,
    Ln1p,
    Tanh,
    Sin,
    Cos,
    Atan,
    Sqrt,
}

/// How two numbers may be ordered: a set of less, equal and greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Order(u8);

impl Order {
    pub const NEVER: Order = Order(0);
    pub const LESS: Order = Order(1);
    pub const EQUAL: Order = Order(2);
    pub const GREATER: Order = Order(4);
    pub const ANY: Order = Order(7);

    pub const fn or(self, other: Order) -> Order {
        Order(self.0 | other.0)
    }

    pub const fn and(self, other: Order) -> Order {
        Order(self.0 & other.0)
    }

    pub const fn not(self) -> Order {
        Order(Order::ANY.0 & !self.0)
    }

    /// The answer to a question about numbers that are ordered in one of these ways, if all of them agree on it.
    pub fn settles(self, asked: Order) -> Option<bool> {
        if self.and(asked) == Order::NEVER {
            return Some(false);
        }
        (self.and(asked.not()) == Order::NEVER).then_some(true)
    }

    /// The same question with the two numbers exchanged.
    pub const fn turned(self) -> Order {
        Order(self.0 & 2 | (self.0 & 1) << 2 | (self.0 & 4) >> 2)
    }

    fn of(a: f64, b: f64) -> Order {
        match a.partial_cmp(&b) {
            Some(std::cmp::Ordering::Less) => Order::LESS,
            Some(std::cmp::Ordering::Equal) => Order::EQUAL,
            Some(std::cmp::Ordering::Greater) => Order::GREATER,
            None => Order::NEVER,
        }
    }
}

/// An expression: a number, or the answer of a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Expression {
    /// A constant, by its bits.
    Constant(u64),
    /// The value of a column.
    Column(usize),
    /// A result of one number, or of two; the second one is the first again where there is only one.
    Result(Operation, Id, Id),
    /// Whether two numbers are ordered in one of these ways.
    Compared(Order, Id, Id),
    And(Id, Id),
    Not(Id),
    /// One of two numbers, by an answer.
    Chosen(Id, Id, Id),
    /// Result of a search, or of another model, at this place, from a list of numbers.
    Found(usize, Id),
    /// A list: its rest and its last number.
    List(Id, Id),
}

use Expression::{And, Chosen, Column, Compared, Constant, Found, List, Not, Result};

/// All expressions that have been built.
#[derive(Default)]
pub struct Expressions {
    all: Vec<Expression>,
    known: HashMap<Expression, Id>,
}

impl Expressions {
    pub fn get(&self, id: Id) -> Expression {
        self.all[id as usize]
    }

    pub fn add(&mut self, expression: Expression) -> Id {
        *self.known.entry(expression).or_insert_with(|| {
            self.all.push(expression);
            self.all.len() as Id - 1
        })
    }

    pub fn constant(&mut self, value: f64) -> Id {
        self.add(Constant(value.to_bits()))
    }

    /// Its value, if it is a constant.
    pub fn value(&self, id: Id) -> Option<f64> {
        match self.get(id) {
            Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    pub fn result(&mut self, operation: Operation, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => self.constant(computed(operation, a, b)),
            // Nothing is left of a finite number; a model refuses others.
            (Some(0.0), _) if matches!(operation, Operation::Mul | Operation::Div) => self.constant(0.0),
            (_, Some(0.0)) if operation == Operation::Mul => self.constant(0.0),
            (Some(0.0), _) if operation == Operation::Add => b,
            (_, Some(0.0)) if matches!(operation, Operation::Add | Operation::Sub) => a,
            _ => self.add(Result(operation, a, b)),
        }
    }

    pub fn answer(&mut self, answer: bool) -> Id {
        self.add(Compared(if answer { Order::ANY } else { Order::NEVER }, 0, 0))
    }

    /// The answer, if it is the same for all numbers.
    pub fn known_answer(&self, id: Id) -> Option<bool> {
        match self.get(id) {
            Compared(Order::ANY, ..) => Some(true),
            Compared(Order::NEVER, ..) => Some(false),
            _ => None,
        }
    }

    pub fn compared(&mut self, order: Order, a: Id, b: Id) -> Id {
        if let (Some(x), Some(y)) = (self.value(a), self.value(b)) {
            return self.answer(Order::of(x, y).and(order) != Order::NEVER);
        }
        if a > b {
            return self.compared(order.turned(), b, a);
        }
        // Constants come after what is compared with them, whatever was built first.
        if self.value(a).is_some() {
            return self.ordered(order.turned(), b, a);
        }
        self.ordered(order, a, b)
    }

    /// A comparison of two numbers in their order. A sign or a magnitude has the order to zero of its number.
    fn ordered(&mut self, order: Order, a: Id, b: Id) -> Id {
        if self.value(b) == Some(0.0)
            && let Result(operation, number, _) = self.get(a)
        {
            let zero = order.and(Order::EQUAL);
            match operation {
                Operation::Sign => return self.compared(order, number, b),
                Operation::Neg => return self.compared(order.turned(), number, b),
                Operation::Abs if order.and(Order::GREATER) == Order::NEVER => return self.compared(zero, number, b),
                Operation::Abs => return self.compared(zero.or(Order::LESS).or(Order::GREATER), number, b),
                _ => {}
            }
        }
        match order {
            Order::ANY => self.answer(true),
            Order::NEVER => self.answer(false),
            _ => self.add(Compared(order, a, b)),
        }
    }

    pub fn and(&mut self, a: Id, b: Id) -> Id {
        match (self.known_answer(a), self.known_answer(b), self.get(a), self.get(b)) {
            (Some(true), ..) => b,
            (_, Some(true), ..) => a,
            (Some(false), ..) | (_, Some(false), ..) => self.answer(false),
            (.., Compared(one, a, b), Compared(other, c, d)) if (a, b) == (c, d) => self.ordered(one.and(other), a, b),
            _ if a == b => a,
            _ => self.add(And(a.min(b), a.max(b))),
        }
    }

    pub fn not(&mut self, id: Id) -> Id {
        match self.get(id) {
            Compared(Order::ANY | Order::NEVER, ..) => {
                let answer = self.known_answer(id) == Some(false);
                self.answer(answer)
            }
            Compared(order, a, b) => self.add(Compared(order.not(), a, b)),
            Not(other) => other,
            _ => self.add(Not(id)),
        }
    }

    pub fn chosen(&mut self, answer: Id, yes: Id, no: Id) -> Id {
        if yes == no { yes } else { self.add(Chosen(answer, yes, no)) }
    }

    /// A result at a place that is found from these numbers.
    pub fn found(&mut self, place: usize, from: impl Iterator<Item = Id>) -> Id {
        let end = self.constant(0.0);
        let list = from.fold(end, |list, number| self.add(List(list, number)));
        self.add(Found(place, list))
    }

    /// The columns that an expression is computed from.
    pub fn columns(&self, id: Id) -> BTreeSet<usize> {
        let (mut found, mut seen, mut left) = (BTreeSet::new(), vec![false; self.all.len()], vec![id]);
        while let Some(id) = left.pop() {
            if std::mem::replace(&mut seen[id as usize], true) {
                continue;
            }
            match self.get(id) {
                Constant(_) | Compared(Order::ANY | Order::NEVER, ..) => {}
                Column(column) => {
                    found.insert(column);
                }
                Not(a) | Found(_, a) => left.push(a),
                Result(_, a, b) | Compared(_, a, b) | And(a, b) | List(a, b) => left.extend([a, b]),
                Chosen(a, b, c) => left.extend([a, b, c]),
            }
        }
        found
    }
}

fn computed(operation: Operation, a: f64, b: f64) -> f64 {
    match operation {
        Operation::Add => a + b,
        Operation::Sub => a - b,
        Operation::Mul => a * b,
        Operation::Div => a / b,
        Operation::Power => Real::powf(a, b),
        Operation::Neg => -a,
        Operation::Abs => a.abs(),
        Operation::Sign => Real::sign(a),
        Operation::Exp => Real::exp(a),
        Operation::ExpM1 => Real::exp_m1(a),
        Operation::Ln => Real::ln(a),
        Operation::Ln1p => Real::ln_1p(a),
        Operation::Tanh => Real::tanh(a),
        Operation::Sin => Real::sin(a),
        Operation::Cos => Real::cos(a),
        Operation::Atan => Real::atan(a),
        Operation::Sqrt => Real::sqrt(a),
    }
}
