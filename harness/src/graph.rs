//! What feeds through to what, variable by variable: in which order outputs are propagated, in which order instances
//! are stepped, and whether there is an algebraic loop.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap, VecDeque};

use swayless_modeldesc::types::{Causality, Initial, ModelDescription, Unknown, Variability};

use crate::error::{Error, Result};
use crate::system::{Link, Names, Port};

/// The orders that follow from a system's connections and its FMUs' declared dependencies.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Flow {
    /// All connected variables (never elements), each after those that it depends on in initialization.
    pub initialization: Vec<Port>,
    /// The instances, each as far as possible after those that feed it.
    pub instances: Vec<usize>,
    /// The connections that pass their values a step late, to break algebraic loops: output and input.
    pub late: Vec<(Port, Port)>,
}

impl Flow {
    /// Of resolved connections. An algebraic loop, in initialization or later, is an error, or is broken where its last
    /// connection is.
    pub(crate) fn of(names: &Names, links: &[Link], break_loops: bool) -> Result<Self> {
        let variables = Variables::of(links);
        let mut stepping = variables.graph(names, links, Phase::Stepping);
        let mut initializing = variables.graph(names, links, Phase::Initialization);
        let mut late = Vec::new();
        let order = loop {
            let cycle = match (initializing.order(), stepping.order()) {
                (Ok(order), Ok(_)) => break order,
                (Err(cycle), _) | (_, Err(cycle)) => cycle,
            };
            let last = links.iter().rev().find(|link| {
                let (from, to) = (variables.node(link.from), variables.node(link.to));
                let next = cycle.iter().cycle().skip(1);
                cycle.iter().zip(next).any(|(&a, &b)| (a, b) == (from, to))
            });
            let Some(link) = last.filter(|_| break_loops) else {
                let variables = cycle.into_iter().map(|node| names.name(variables.ports[node])).collect();
                return Err(Error::AlgebraicLoop { variables });
            };
            for graph in [&mut initializing, &mut stepping] {
                graph.disconnect(variables.node(link.from), variables.node(link.to));
            }
            late.push((link.from, link.to));
        };
        Ok(Self {
            initialization: order.into_iter().map(|node| variables.ports[node]).collect(),
            instances: order_instances(names, links, &variables, &stepping),
            late,
        })
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Initialization,
    Stepping,
}

/// The variables at the ends of the connections, in a fixed order.
struct Variables {
    ports: Vec<Port>,
    nodes: BTreeMap<Port, usize>,
}

impl Variables {
    fn of(links: &[Link]) -> Self {
        let ends = links.iter().flat_map(|link| [link.from, link.to]);
        // An array is one variable: dependencies are declared for the whole of it.
        let mut ports: Vec<Port> = ends.map(|port| Port { element: None, ..port }).collect();
        ports.sort();
        ports.dedup();
        let nodes = ports.iter().enumerate().map(|(node, &port)| (port, node)).collect();
        Self { ports, nodes }
    }

    fn node(&self, port: Port) -> usize {
        self.nodes[&Port { element: None, ..port }]
    }

    /// Edges along the connections, and through the instances from inputs to outputs.
    fn graph(&self, names: &Names, links: &[Link], phase: Phase) -> Graph {
        let mut graph = Graph::new(self.ports.len());
        for link in links {
            graph.connect(self.node(link.from), self.node(link.to));
        }
        for (node, &port) in self.ports.iter().enumerate() {
            let description = names.description(port.instance);
            if description.variables[port.variable].causality != Causality::Output {
                continue;
            }
            let inputs = self.ports.iter().enumerate().filter(|(_, other)| {
                other.instance == port.instance && description.variables[other.variable].causality == Causality::Input
            });
            let dependencies = dependencies(description, port.variable, phase);
            for (input, other) in inputs {
                if dependencies.is_none_or(|dependencies| dependencies.contains(&other.variable)) {
                    graph.connect(input, node);
                }
            }
        }
        graph
    }
}

/// What an output depends on; `None` means on everything.
fn dependencies(description: &ModelDescription, output: usize, phase: Phase) -> Option<&[usize]> {
    let of = |unknowns: &'_ [Unknown]| unknowns.iter().position(|unknown| unknown.variable == output);
    let structure = &description.structure;
    if phase == Phase::Initialization {
        if let Some(at) = of(&structure.initial_unknowns) {
            return structure.initial_unknowns[at].dependencies.as_deref();
        }
        if description.variables[output].initial == Some(Initial::Exact) {
            // It is what it was set to.
            return Some(&[]);
        }
    }
    structure.outputs[of(&structure.outputs)?].dependencies.as_deref()
}

/// The order in which Gauss–Seidel steps the instances: each after those that feed it. In a circle of instances an input
/// that feeds through to no continuous output may get its value late: it takes effect only through the state, or when the
/// instance samples it, which it may do at the beginning of a step as well as at its end.
fn order_instances(names: &Names, links: &[Link], variables: &Variables, stepping: &Graph) -> Vec<usize> {
    let count = names.count();
    let (mut all, mut direct) = (Graph::new(count), Graph::new(count));
    let is_continuous = |&node: &usize| {
        let port = variables.ports[node];
        names.description(port.instance).variables[port.variable].variability == Variability::Continuous
    };
    for link in links.iter().filter(|link| link.from.instance != link.to.instance) {
        all.connect(link.from.instance, link.to.instance);
        if stepping.next[variables.node(link.to)].iter().any(is_continuous) {
            direct.connect(link.from.instance, link.to.instance);
        }
    }
    let mut order = Vec::new();
    let mut rest: Vec<usize> = (0..count).collect();
    while !rest.is_empty() {
        // First those that wait for nobody; else, in a circle, those that wait for nobody in it directly; else the
        // first of the circle.
        let waits = |graph: &Graph, instance: usize, on: &[usize]| {
            on.iter().any(|&other| graph.next[other].contains(&instance))
        };
        let free = rest.iter().copied().find(|&instance| !waits(&all, instance, &rest));
        let next = free.unwrap_or_else(|| {
            let circle = all.first_circle(&rest);
            circle.iter().copied().find(|&instance| !waits(&direct, instance, &circle)).unwrap_or(circle[0])
        });
        order.push(next);
        rest.retain(|&instance| instance != next);
    }
    order
}

/// A directed graph of numbered nodes.
#[derive(Debug, Clone)]
struct Graph {
    next: Vec<Vec<usize>>,
}

impl Graph {
    fn new(nodes: usize) -> Self {
        Self { next: vec![Vec::new(); nodes] }
    }

    fn connect(&mut self, from: usize, to: usize) {
        if !self.next[from].contains(&to) {
            self.next[from].push(to);
        }
    }

    fn disconnect(&mut self, from: usize, to: usize) {
        self.next[from].retain(|&node| node != to);
    }

    /// All nodes, each after those that lead to it, smaller numbers first where there is a choice; or a shortest circle.
    fn order(&self) -> Result<Vec<usize>, Vec<usize>> {
        let mut waiting = vec![0; self.next.len()];
        self.next.iter().flatten().for_each(|&to| waiting[to] += 1);
        let mut ready: BinaryHeap<_> = (0..waiting.len()).filter(|&node| waiting[node] == 0).map(Reverse).collect();
        let mut order = Vec::with_capacity(waiting.len());
        while let Some(Reverse(node)) = ready.pop() {
            order.push(node);
            for &to in &self.next[node] {
                waiting[to] -= 1;
                if waiting[to] == 0 {
                    ready.push(Reverse(to));
                }
            }
        }
        if order.len() == self.next.len() {
            return Ok(order);
        }
        let circles = (0..waiting.len()).filter(|&node| waiting[node] > 0).filter_map(|node| self.path(node, node));
        // Some node of those that are left lies on a circle, or they would not wait for each other.
        Err(circles.min_by_key(Vec::len).unwrap_or_default())
    }

    /// The nodes of a shortest way of at least one edge, without the last.
    fn path(&self, from: usize, to: usize) -> Option<Vec<usize>> {
        let mut before = vec![None; self.next.len()];
        let mut queue = VecDeque::from([from]);
        while let Some(node) = queue.pop_front() {
            for &next in &self.next[node] {
                if next == to {
                    let mut path = vec![node];
                    while let Some(previous) = before[path[path.len() - 1]] {
                        path.push(previous);
                    }
                    path.reverse();
                    return Some(path);
                }
                if before[next].is_none() && next != from {
                    before[next] = Some(node);
                    queue.push_back(next);
                }
            }
        }
        None
    }

    /// A set of nodes of `among` that all lead to each other and to which none of the others leads; in order.
    fn first_circle(&self, among: &[usize]) -> Vec<usize> {
        let reach: Vec<Vec<bool>> = among.iter().map(|&node| self.reachable(node, among)).collect();
        let leads = |a: usize, b: usize| reach[a][among[b]];
        let circle = |a: usize| (0..among.len()).filter(move |&b| a == b || leads(a, b) && leads(b, a));
        let first = (0..among.len()).find(|&a| (0..among.len()).all(|b| a == b || !leads(b, a) || leads(a, b)));
        first.map(|a| circle(a).map(|b| among[b]).collect()).unwrap_or_else(|| among.to_vec())
    }

    fn reachable(&self, from: usize, among: &[usize]) -> Vec<bool> {
        let mut seen = vec![false; self.next.len()];
        let mut stack = vec![from];
        while let Some(node) = stack.pop() {
            for &next in self.next[node].iter().filter(|next| among.contains(next)) {
                if !std::mem::replace(&mut seen[next], true) {
                    stack.push(next);
                }
            }
        }
        seen
    }
}

#[cfg(test)]
mod tests;
