//! From a system that is checked to instances that are initialized, with consistent values at the start time.

use swayless_modeldesc::types::Causality;

use super::layout::{Slots, batches, declared_start, drives, transfers, whole};
use super::store::{Batch, Store};
use super::{Instance, Run, Signals, failed};
use crate::error::{Error, Result};
use crate::signals::Cursor;
use crate::slave::Experiment;
use crate::system::{Kind, Names, Port, Start, System, Wiring};

/// Instantiates and initializes a system. After an error the instances that were made are freed.
pub(crate) fn start(system: &System, wiring: &Wiring, experiment: &Experiment, logging: bool) -> Result<Run> {
    let mut run = Run {
        instances: Vec::new(),
        outputs: Store::default(),
        inputs: Store::default(),
        signals: Signals::default(),
        order: wiring.flow.instances.clone(),
        terminated: None,
    };
    let (mut outputs, mut inputs) = (Slots::default(), Slots::default());
    for (index, instance) in system.instances().iter().enumerate() {
        let slave = instance.model.instantiate(&instance.name, logging)?;
        let names = &wiring.names;
        let sources = whole(index, wiring.links.iter().map(|link| link.from));
        let gets = batches(names, &sources, &mut run.outputs, &mut outputs, |port| declared_start(names, port));
        let driven = wiring.drives.iter().map(|drive| drive.to);
        let sinks = whole(index, wiring.links.iter().map(|link| link.to).chain(driven));
        // Elements of an array that nothing is connected to keep their start values.
        let sets = batches(names, &sinks, &mut run.inputs, &mut inputs, |port| {
            let given = wiring.starts.iter().find(|start| start.port == port);
            given.map_or_else(|| declared_start(names, port), |start| start.values.clone())
        });
        let name = instance.name.clone();
        run.instances.push(Instance { name, slave, gets, sets, transfers: Default::default() });
    }
    for (index, instance) in run.instances.iter_mut().enumerate() {
        instance.transfers = transfers(wiring, index, &outputs, &inputs);
    }
    let (signals, cursor) = (wiring.signals.clone(), Cursor::default());
    run.signals = Signals { signals, drives: drives(wiring, &inputs), cursor };

    initialize(&mut run, wiring, experiment, &outputs, &inputs)?;
    Ok(run)
}

fn initialize(run: &mut Run, wiring: &Wiring, experiment: &Experiment, outputs: &Slots, inputs: &Slots) -> Result<()> {
    let names = &wiring.names;
    let time = experiment.start_time;
    set_structural_parameters(run, wiring)?;
    for start in wiring.starts.iter().filter(|start| causality(names, start.port) != Causality::Input) {
        if causality(names, start.port) != Causality::StructuralParameter {
            set_start(run, names, start)?;
        }
    }
    for Instance { name, slave, .. } in &mut run.instances {
        slave.enter_initialization_mode(experiment).map_err(|failure| failed(name, Some(time), failure))?;
    }
    // Inputs have no `initial`, so they are set in initialization mode rather than before.
    for start in wiring.starts.iter().filter(|start| causality(names, start.port) == Causality::Input) {
        set_start(run, names, start)?;
    }
    run.take_signals(time);
    for drive in &wiring.drives {
        set_one(run, names, Port { element: None, ..drive.to }, inputs, time)?;
    }
    // An output is got when all that it depends on has been set, so that feed-through is consistent at once.
    for &port in &wiring.flow.initialization {
        match causality(names, port) {
            Causality::Output => {
                let Instance { name, slave, .. } = &mut run.instances[port.instance];
                let got = one(names, port, outputs).get(&mut **slave, &mut run.outputs);
                got.map_err(|failure| failed(name, Some(time), failure))?;
            }
            _ => {
                run.transfer(port.instance, time)?;
                set_one(run, names, port, inputs, time)?;
            }
        }
    }
    for Instance { name, slave, .. } in &mut run.instances {
        slave.exit_initialization_mode().map_err(|failure| failed(name, Some(time), failure))?;
    }
    (0..run.count()).try_for_each(|instance| run.get_outputs(instance, time))
}

fn causality(names: &Names, port: Port) -> Causality {
    names.variable(port).causality
}

/// A batch of a single variable that has a slot.
fn one(names: &Names, port: Port, slots: &Slots) -> Batch {
    let variable = names.variable(port);
    let first = slots.of(port);
    Batch {
        kind: Kind::of(variable.data_type).unwrap_or(Kind::Float),
        data_type: variable.data_type,
        references: vec![variable.value_reference],
        slots: first..first + names.size(port),
        names: Vec::new(),
    }
}

fn set_one(run: &mut Run, names: &Names, port: Port, inputs: &Slots, time: f64) -> Result<()> {
    let Instance { name, slave, .. } = &mut run.instances[port.instance];
    let set = one(names, port, inputs).set(&mut **slave, &run.inputs);
    set.map_err(|failure| failed(name, Some(time), failure))
}

/// Sets a start value alone, so that a refusal names it.
fn set_start(run: &mut Run, names: &Names, start: &Start) -> Result<()> {
    let (mut store, mut slots) = (Store::default(), Slots::default());
    let batches = batches(names, &[start.port], &mut store, &mut slots, |_| start.values.clone());
    let slave = &mut *run.instances[start.port.instance].slave;
    batches.iter().try_for_each(|batch| batch.set(slave, &store)).map_err(|failure| Error::Refused {
        place: start.place.clone(),
        variable: names.name(start.port),
        value: start.text.clone(),
        failure: Box::new(failure),
    })
}

/// Structural parameters are set in a mode of their own, and only if there are any to set.
fn set_structural_parameters(run: &mut Run, wiring: &Wiring) -> Result<()> {
    let names = &wiring.names;
    for instance in 0..run.count() {
        let starts: Vec<&Start> = wiring
            .starts
            .iter()
            .filter(|start| start.port.instance == instance)
            .filter(|start| causality(names, start.port) == Causality::StructuralParameter)
            .collect();
        if starts.is_empty() {
            continue;
        }
        let call = |run: &mut Run, exit: bool| {
            let Instance { name, slave, .. } = &mut run.instances[instance];
            let done = if exit { slave.exit_configuration_mode() } else { slave.enter_configuration_mode() };
            done.map_err(|failure| failed(name, None, failure))
        };
        call(run, false)?;
        starts.into_iter().try_for_each(|start| set_start(run, names, start))?;
        call(run, true)?;
    }
    Ok(())
}
