//! Which functions of a module are needed, what they may do, and how much of the stack they take.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result};

use super::frame::Frame;
use super::function::{Facts, Function, Rules};
use super::links::Target;
use super::module::Module;

/// Bytes of C's stack that a call takes beside variables: registers, the return address, and a function of the runtime.
const BESIDE_VARIABLES: u32 = 128;

/// Functions of a module with all that they need: the functions that they call, directly or by number, and data.
pub struct Graph<'a> {
    module: &'a Module<'a>,
    pub functions: BTreeMap<u32, Facts>,
    /// Data and functions whose address is used.
    pub targets: BTreeSet<Target>,
    /// The function that writes texts, if nobody reads them: it writes nothing, and its callers take that for success.
    silent: Option<u32>,
    /// Functions that never return.
    endless: BTreeSet<u32>,
}

impl Graph<'_> {
    /// The functions that these need. What a panic says is not needed: nobody reads it.
    pub fn of<'a>(module: &'a Module<'a>, roots: &[u32], with_texts: bool) -> Result<Graph<'a>> {
        let silent = if with_texts { None } else { Some(module.writer.context("no function writes texts")?) };
        let functions = BTreeMap::new();
        let mut graph = Graph { module, functions, targets: BTreeSet::new(), silent, endless: endless(module) };
        let rules = Rules { endless: graph.endless.clone(), ..Rules::default() };
        let mut waiting = roots.to_vec();
        while !waiting.is_empty() {
            while let Some(at) = waiting.pop() {
                let facts = if silent == Some(at) { Facts::default() } else { Function::of(module, at, &rules)?.0 };
                waiting.extend(&facts.needs.functions);
                graph.add_targets(&facts.needs.targets);
                graph.functions.insert(at, facts);
                waiting.retain(|at| !graph.functions.contains_key(at));
            }
            // A call by number may be one of a function whose address was found later.
            waiting = graph.by_number().into_values().flat_map(BTreeMap::into_values).collect();
            waiting.retain(|at| !graph.functions.contains_key(at));
        }
        Ok(graph)
    }

    /// Adds what has an address, and that to which it refers.
    fn add_targets(&mut self, targets: &BTreeSet<Target>) {
        let mut waiting: Vec<Target> = targets.iter().copied().collect();
        while let Some(target) = waiting.pop() {
            if self.targets.insert(target)
                && let Target::Data(symbol) = target
            {
                waiting.extend(self.module.links.of(self.module.links.part(symbol)));
            }
        }
    }

    /// Functions of a type that are called by number, by their numbers.
    fn of_kind(&self, kind: u32) -> BTreeMap<u32, u32> {
        let is_of = |at: u32| {
            let is_silent = self.silent.is_some() && self.module.formatters.contains(&at);
            !is_silent
                && self.targets.contains(&Target::Function(at))
                && self.module.kind_of(self.module.functions[at as usize]) == kind
        };
        self.module.table.iter().map(|(number, at)| (*number, *at)).filter(|(_, at)| is_of(*at)).collect()
    }

    /// The types whose functions are called by number, and those functions.
    pub fn by_number(&self) -> BTreeMap<u32, BTreeMap<u32, u32>> {
        let kinds: BTreeSet<u32> =
            self.functions.values().flat_map(|facts| facts.needs.kinds.iter().copied()).collect();
        kinds.into_iter().map(|kind| (kind, self.of_kind(kind))).collect()
    }

    /// How a function ends that is not translated.
    pub fn end_of(&self, function: u32) -> Option<&'static str> {
        (self.silent == Some(function)).then_some("return 0;")
    }

    fn callees(&self, function: u32) -> BTreeSet<u32> {
        let facts = &self.functions[&function];
        let by_number = facts.needs.kinds.iter().flat_map(|kind| self.of_kind(*kind).into_values());
        facts.needs.functions.iter().copied().chain(by_number).collect()
    }

    /// Bytes of the module's stack that calls of these functions need at most; none if that is not known.
    pub fn stack(&self, roots: &[u32]) -> Option<u32> {
        self.deepest(roots, |facts| match facts.frame {
            Frame::None => Some(0),
            Frame::Bytes(bytes) => Some(bytes),
            Frame::Unknown => None,
        })
    }

    /// The same for the stack of C, estimated: with each variable in memory, and what a call keeps.
    pub fn stack_of_c(&self, roots: &[u32]) -> Option<u32> {
        self.deepest(roots, |facts| Some(8 * facts.variables as u32 + BESIDE_VARIABLES))
    }

    /// The largest sum along a chain of calls that begins with one of these.
    fn deepest(&self, roots: &[u32], own: impl Fn(&Facts) -> Option<u32>) -> Option<u32> {
        let mut known = BTreeMap::new();
        roots.iter().try_fold(0, |most: u32, root| Some(most.max(self.depth(*root, &own, &mut known)?)))
    }

    /// The same of one function. Functions that are being looked at have no number yet: then they call themselves.
    fn depth(
        &self,
        function: u32,
        own: &impl Fn(&Facts) -> Option<u32>,
        known: &mut BTreeMap<u32, Option<u32>>,
    ) -> Option<u32> {
        if let Some(found) = known.get(&function) {
            return *found;
        }
        known.insert(function, None);
        let callees = self.callees(function);
        let below = callees.iter().try_fold(0, |most: u32, at| Some(most.max(self.depth(*at, own, known)?)))?;
        let sum = below + own(&self.functions[&function])?;
        known.insert(function, Some(sum));
        Some(sum)
    }

    /// Rules for the checks that functions make.
    pub fn rules(&self, has_stack_for_all: bool) -> Rules {
        let mut traps: BTreeSet<u32> =
            self.functions.iter().filter(|(_, facts)| facts.traps).map(|(at, _)| *at).collect();
        if !has_stack_for_all {
            traps.extend(self.functions.iter().filter(|(_, facts)| facts.frame != Frame::None).map(|(at, _)| *at));
        }
        loop {
            let calls_one = |facts: &Facts| !facts.needs.functions.is_disjoint(&traps);
            let more: Vec<u32> =
                self.functions.iter().filter(|(_, facts)| calls_one(facts)).map(|(at, _)| *at).collect();
            let before = traps.len();
            traps.extend(more);
            if traps.len() == before {
                return Rules { traps, endless: self.endless.clone(), has_stack_for_all };
            }
        }
    }
}

/// The functions that never return: they panic. What cannot be translated is not needed, or said so later.
fn endless(module: &Module) -> BTreeSet<u32> {
    let rules = Rules::default();
    let is_endless = |at: &u32| Function::of(module, *at, &rules).is_ok_and(|(facts, _)| !facts.returns);
    (0..module.functions.len() as u32).filter(is_endless).collect()
}
