//! Descriptions that several tests use: a swinging payload, once for each version, with a bit of everything.

use swayless_modeldesc::types::*;

/// A pendulum with a state, its derivative, an input, parameters of every type that FMI 2.0 knows, and an output.
pub fn pendulum(version: FmiVersion) -> ModelDescription {
    let mut md = ModelDescription::new(version, "Pendulum", "{8c4e810f-3df3-4a00-8276-176fa3c9f9e0}");
    md.description = Some("A payload that swings & <says> so".to_owned());
    md.author = Some("The \"makers\"".to_owned());
    md.version = Some("1.0".to_owned());
    md.generation_date_and_time = Some("2024-02-29T12:00:00Z".to_owned());
    md.variable_naming_convention = NamingConvention::Structured;
    md.model_exchange = Some(Interface {
        model_identifier: "Pendulum".to_owned(),
        provides_directional_derivatives: true,
        needs_completed_integrator_step: true,
        ..Interface::default()
    });
    md.co_simulation = Some(Interface {
        model_identifier: "Pendulum".to_owned(),
        can_handle_variable_communication_step_size: true,
        can_get_and_set_fmu_state: true,
        has_event_mode: version == FmiVersion::V3,
        ..Interface::default()
    });
    md.units = vec![
        Unit {
            name: "rad".to_owned(),
            base: Some(BaseUnit { exponents: [0, 0, 0, 0, 0, 0, 0, 1], factor: 1.0, offset: 0.0 }),
            display_units: vec![DisplayUnit {
                name: "deg".to_owned(),
                factor: 180.0 / std::f64::consts::PI,
                offset: 0.0,
                inverse: false,
            }],
        },
        Unit {
            name: "rad/s".to_owned(),
            base: Some(BaseUnit { exponents: [0, 0, -1, 0, 0, 0, 0, 1], factor: 1.0, offset: 0.0 }),
            display_units: Vec::new(),
        },
    ];
    md.type_definitions = vec![
        TypeDefinition {
            name: "Angle".to_owned(),
            description: None,
            data_type: DataType::Float64,
            attributes: Attributes {
                quantity: Some("Angle".to_owned()),
                unit: Some("rad".to_owned()),
                display_unit: Some("deg".to_owned()),
                ..Attributes::default()
            },
            items: Vec::new(),
            clock: None,
        },
        TypeDefinition {
            name: "Kind".to_owned(),
            description: Some("What swings".to_owned()),
            data_type: DataType::Enumeration,
            attributes: Attributes::default(),
            items: vec![
                Item { name: "Hook".to_owned(), value: 1, description: None },
                Item { name: "Payload".to_owned(), value: 2, description: Some("and hook".to_owned()) },
            ],
            clock: None,
        },
    ];
    md.log_categories = vec![LogCategory { name: "logStatusError".to_owned(), description: None }];
    md.default_experiment = Some(DefaultExperiment {
        start_time: Some(0.0),
        stop_time: Some(20.0),
        tolerance: Some(1e-6),
        step_size: Some(0.01),
    });
    md.variables = variables();
    md.structure = ModelStructure {
        outputs: vec![Unknown {
            variable: 1,
            dependencies: Some(vec![1]),
            dependencies_kind: Some(vec![DependencyKind::Constant]),
            line: 0,
        }],
        derivatives: vec![Unknown { variable: 2, dependencies: Some(vec![1, 3]), ..Unknown::default() }],
        initial_unknowns: vec![Unknown {
            variable: 2,
            dependencies: Some(vec![1, 3]),
            dependencies_kind: Some(vec![DependencyKind::Dependent; 2]),
            line: 0,
        }],
        ..ModelStructure::default()
    };
    md
}

fn variables() -> Vec<Variable> {
    use Causality as C;
    use DataType as T;
    use Variability as V;
    let unit = |unit: &str| Attributes { unit: Some(unit.to_owned()), ..Attributes::default() };
    vec![
        Variable::new("time", 0, T::Float64, C::Independent, V::Continuous),
        Variable {
            description: Some("Swing angle".to_owned()),
            declared_type: Some("Angle".to_owned()),
            initial: Some(Initial::Exact),
            start: Some(Start::Float(vec![0.1])),
            ..Variable::new("swing.angle", 1, T::Float64, C::Output, V::Continuous)
        },
        Variable {
            attributes: unit("rad/s"),
            derivative: Some(1),
            ..Variable::new("der(swing.angle)", 2, T::Float64, C::Local, V::Continuous)
        },
        Variable {
            attributes: unit("rad/s"),
            start: Some(Start::Float(vec![0.0])),
            ..Variable::new("swing.push", 3, T::Float64, C::Input, V::Continuous)
        },
        Variable {
            attributes: Attributes { min: Some(0.0), max: Some(10.0), ..Attributes::default() },
            start: Some(Start::Integer(vec![3])),
            ..Variable::new("parts", 4, T::Int32, C::Parameter, V::Tunable)
        },
        Variable {
            start: Some(Start::Boolean(vec![true])),
            ..Variable::new("enabled", 5, T::Boolean, C::Parameter, V::Fixed)
        },
        Variable {
            start: Some(Start::String(vec!["a\nb <c>".to_owned()])),
            ..Variable::new("file", 6, T::String, C::Parameter, V::Fixed)
        },
        Variable {
            declared_type: Some("Kind".to_owned()),
            start: Some(Start::Integer(vec![2])),
            ..Variable::new("kind", 7, T::Enumeration, C::Parameter, V::Fixed)
        },
    ]
}

/// The pendulum in FMI 3.0 with what only FMI 3.0 knows: arrays, aliases, all widths, an event indicator.
pub fn pendulum_with_arrays() -> ModelDescription {
    use Causality as C;
    use DataType as T;
    use Variability as V;
    let mut md = pendulum(FmiVersion::V3);
    md.variables[1].aliases = vec![Alias {
        name: "theta".to_owned(),
        description: Some("the same".to_owned()),
        display_unit: Some("deg".to_owned()),
    }];
    md.variables.extend([
        Variable {
            start: Some(Start::Integer(vec![3])),
            ..Variable::new("n", 8, T::UInt64, C::StructuralParameter, V::Fixed)
        },
        Variable {
            start: Some(Start::Float(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0])),
            dimensions: vec![Dimension::Fixed(2), Dimension::Variable(8)],
            ..Variable::new("modes", 9, T::Float32, C::Parameter, V::Tunable)
        },
        Variable {
            start: Some(Start::Binary(vec![vec![0, 0xff, 0x1a]])),
            ..Variable::new("blob", 10, T::Binary, C::Parameter, V::Fixed)
        },
        Variable {
            start: Some(Start::String(vec![String::new(), "b".to_owned()])),
            dimensions: vec![Dimension::Fixed(2)],
            ..Variable::new("names", 11, T::String, C::Parameter, V::Fixed)
        },
        Variable::new("indicator", 12, T::Float64, C::Local, V::Continuous),
    ]);
    md.number_of_event_indicators = 1;
    md.structure.event_indicators =
        vec![Unknown { variable: 12, dependencies: Some(Vec::new()), ..Unknown::default() }];
    md
}

/// The pendulum with everything that ticks: clocks of every kind, a clock type, a clocked state with its previous value,
/// and all three interfaces.
pub fn pendulum_with_clocks() -> ModelDescription {
    use Causality as C;
    use IntervalVariability as I;
    let mut md = pendulum_with_arrays();
    md.scheduled_execution = Some(Interface {
        model_identifier: "Pendulum".to_owned(),
        can_get_and_set_fmu_state: true,
        provides_adjoint_derivatives: true,
        ..Interface::default()
    });
    let co_simulation = md.co_simulation.get_or_insert_default();
    co_simulation.provides_intermediate_update = true;
    co_simulation.can_return_early_after_intermediate_update = true;
    co_simulation.might_return_early_from_do_step = true;
    co_simulation.recommended_intermediate_input_smoothness = 1;
    co_simulation.provides_evaluate_discrete_states = true;
    co_simulation.provides_per_element_dependencies = true;
    md.type_definitions.push(TypeDefinition {
        name: "Sampling".to_owned(),
        description: Some("Ten times a second".to_owned()),
        data_type: DataType::Clock,
        attributes: Attributes::default(),
        items: Vec::new(),
        clock: Some(Clock {
            interval_decimal: Some(0.1),
            supports_fraction: true,
            resolution: Some(10),
            interval_counter: Some(1),
            ..Clock::new(I::Fixed)
        }),
    });
    let clock = |name: &str, reference, causality, clock| Variable {
        clock: Some(clock),
        ..Variable::new(name, reference, DataType::Clock, causality, Variability::Discrete)
    };
    let priority = |variability, priority| Clock { priority: Some(priority), ..Clock::new(variability) };
    let constant = Clock {
        can_be_deactivated: true,
        interval_decimal: Some(0.5),
        shift_decimal: Some(0.25),
        supports_fraction: true,
        resolution: Some(4),
        interval_counter: Some(2),
        shift_counter: Some(1),
        ..priority(I::Constant, 0)
    };
    md.variables.push(Variable {
        aliases: vec![Alias { name: "beat".to_owned(), description: None, display_unit: None }],
        ..clock("ticks.constant", 100, C::Input, constant)
    });
    md.variables.push(Variable {
        declared_type: Some("Sampling".to_owned()),
        ..clock("ticks.fixed", 101, C::Input, priority(I::Fixed, 1))
    });
    md.variables.extend([
        clock("ticks.tunable", 102, C::Input, priority(I::Tunable, 2)),
        clock("ticks.changing", 103, C::Input, priority(I::Changing, 3)),
        clock("ticks.countdown", 104, C::Input, priority(I::Countdown, 4)),
        clock("ticks.triggered", 105, C::Input, priority(I::Triggered, 5)),
        clock("ticks.out", 106, C::Output, Clock::new(I::Triggered)),
    ]);
    let first = md.variables.len();
    let counter = |name: &str, reference| Variable {
        clocks: vec![100, 101],
        ..Variable::new(name, reference, DataType::UInt64, C::Local, Variability::Discrete)
    };
    md.variables.push(Variable { previous: Some(first + 1), ..counter("count", 107) });
    md.variables.push(counter("count.before", 108));
    md.structure.outputs.push(Unknown {
        variable: first - 1,
        dependencies: Some(vec![first - 7]),
        ..Unknown::default()
    });
    md.structure.clocked_states.push(Unknown {
        variable: first,
        dependencies: Some(vec![first - 7, first - 6]),
        dependencies_kind: Some(vec![DependencyKind::Dependent; 2]),
        line: 0,
    });
    for name in ["swing.angle", "swing.push"] {
        if let Some(variable) = md.variables.iter_mut().find(|variable| variable.name == name) {
            variable.intermediate_update = true;
        }
    }
    md
}

/// Takes away what only a file has, so that descriptions can be compared.
pub fn without_lines(mut description: ModelDescription) -> ModelDescription {
    description.variables.iter_mut().for_each(|variable| variable.line = 0);
    let structure = &mut description.structure;
    for list in [
        &mut structure.outputs,
        &mut structure.derivatives,
        &mut structure.clocked_states,
        &mut structure.initial_unknowns,
        &mut structure.event_indicators,
    ] {
        list.iter_mut().for_each(|unknown| unknown.line = 0);
    }
    description
}
