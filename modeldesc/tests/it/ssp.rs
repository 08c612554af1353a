//! SSP documents: a system written by hand is read as it was meant, and written so that the same is read again.

use swayless_modeldesc::problem::{Problem, Severity};
use swayless_modeldesc::ssp::*;
use swayless_modeldesc::types::DataType;

const CRANE: &str = include_str!("../golden/crane_by_hand.ssd");

fn crane() -> SystemStructureDescription {
    let (description, problems) = read_system(CRANE).expect("well-formed");
    assert_eq!(problems, []);
    description
}

#[test]
fn a_system_is_read_as_it_was_meant() {
    let crane = crane();
    assert_eq!((crane.version, crane.name.as_str()), (SspVersion::V1, "Crane"));
    assert_eq!(crane.default_experiment.and_then(|e| e.stop_time), Some(60.0));
    assert_eq!(crane.units[2].base.factor, 0.017_453_292_519_943_295);
    assert_eq!(crane.units[3].base.exponents, [0, 0, -1, 0, 0, 0, 0, 1]);
    assert_eq!(crane.enumerations[0].items[0].name, "ZV");

    let system = &crane.system;
    let Some(Element::Component(drive)) = system.element("drive") else { panic!("no drive") };
    assert_eq!(drive.source, "resources/VectorDrive.fmu");
    assert_eq!(drive.implementation, Implementation::CoSimulation);
    assert_eq!(
        drive.parameter_bindings[0].values,
        Source::File { source: "extra/start.ssv".to_owned(), base: SourceBase::Component }
    );
    let Some(Element::Component(plant)) = system.element("plant") else { panic!("no plant") };
    assert_eq!(plant.media_type.as_deref(), Some(Component::FMU));
    assert_eq!(plant.connectors[1].connector_type, None);
    let rate = plant.connectors[0].connector_type.as_ref().expect("a type");
    assert_eq!((rate.data_type, rate.unit.as_deref()), (DataType::Float64, Some("rad/s")));
    assert_eq!(plant.connectors[3].connector_type.as_ref().and_then(|t| t.enumeration.as_deref()), Some("Kind"));

    let connection = &system.connections[0];
    assert_eq!(connection.transformation, Some(Transformation::Linear { factor: 0.5, offset: 0.1 }));
    assert_eq!(connection.line, CRANE.lines().position(|l| l.contains("startConnector=\"slew.rate\"")).unwrap() + 1);
    assert!(system.connections[1].suppress_unit_conversion);

    let [inline, file] = system.parameter_bindings.as_slice() else { panic!("two bindings") };
    assert_eq!(inline.prefix, "plant.");
    let Source::Inline(set) = &inline.values else { panic!("inline values") };
    let values: Vec<(String, DataType, String)> =
        set.parameters.iter().map(|p| (p.name.clone(), p.data_type, p.value.to_string())).collect();
    let expected = [
        ("hoist.length", DataType::Float64, "6.5"),
        ("parts", DataType::Int32, "3"),
        ("enabled", DataType::Boolean, "true"),
        ("file", DataType::String, "a b.csv"),
        ("kind", DataType::Enumeration, "ZVD"),
        ("blob", DataType::Binary, "00FF"),
    ];
    assert_eq!(values, expected.map(|(name, data_type, value)| (name.to_owned(), data_type, value.to_owned())));
    assert_eq!(set.parameters[0].unit.as_deref(), Some("m"));
    let Some(Source::Inline(mapping)) = &file.mapping else { panic!("inline mapping") };
    assert_eq!(mapping.entries[0].target, "plant.payload.mass");
    assert_eq!(mapping.entries[0].transformation, Some(Transformation::Linear { factor: 1000.0, offset: 0.0 }));
}

#[test]
fn data_flows_by_kind_and_not_by_start_and_end() {
    let crane = crane();
    let flows: Vec<(String, String)> = crane
        .system
        .connections
        .iter()
        .map(|connection| crane.system.flow(connection).unwrap())
        .map(|flow| (flow.from.to_string(), flow.to.to_string()))
        .collect();
    let expected = [("drive.velocity", "plant.slew.rate"), ("wind", "plant.wind.x"), ("plant.swing.radial", "swing")];
    assert_eq!(flows, expected.map(|(from, to)| (from.to_owned(), to.to_owned())));
}

/// Takes the lines away, which writing does not keep.
fn normalised(text: &str) -> String {
    let debug = format!("{:#?}", read_system(text).expect("well-formed"));
    debug.lines().filter(|line| !line.trim_start().starts_with("line: ")).collect::<Vec<_>>().join("\n")
}

#[test]
fn what_was_written_is_read_again() {
    let written = write_system(&crane()).unwrap();
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/crane_written.ssd"), &written).unwrap();
    }
    assert_eq!(written, include_str!("../golden/crane_written.ssd"));
    assert_eq!(normalised(&written), normalised(CRANE));
    assert_eq!(write_system(&read_system(&written).unwrap().0).unwrap(), written);
}

#[test]
fn what_is_new_in_ssp_2_is_written_and_read_there_and_refused_in_ssp_1() {
    let mut crane = crane();
    crane.version = SspVersion::V2;
    crane.system.connectors[0].kind = ConnectorKind::StructuralParameter;
    crane.system.connectors[1].dimensions =
        vec![Dimension::Fixed(3), Dimension::Connector("n".to_owned()), Dimension::Unspecified];
    crane.system.connections[2].end.indices = vec![1, 2];
    if let Some(connector_type) = &mut crane.system.connectors[0].connector_type {
        connector_type.data_type = DataType::Float32;
    }
    let written = write_system(&crane).unwrap();
    let (again, problems) = read_system(&written).unwrap();
    assert_eq!(problems, []);
    assert_eq!(again.system.connectors[1].dimensions, crane.system.connectors[1].dimensions);
    assert_eq!(again.system.connections[2].end.indices, [1, 2]);
    assert_eq!(write_system(&again).unwrap(), written);
    let kind = |kind| {
        let mut crane = self::crane();
        crane.system.connectors[0].kind = kind;
        crane
    };
    crane.version = SspVersion::V1;
    for crane in [crane, kind(ConnectorKind::Local)] {
        let error = write_system(&crane).unwrap_err().to_string();
        assert!(error.contains("SSP 1.0"), "{error}");
    }
}

#[test]
fn parameter_sets_and_mappings_have_files_of_their_own() {
    let text = "<ssv:ParameterSet xmlns:ssv='http://ssp-standard.org/SSP1/SystemStructureParameterValues' \
        version='2.0' name='p'><ssv:Parameters>
        <ssv:Parameter name='a'><ssv:Float64 value='1 2 3'/><ssv:Dimension size='3'/></ssv:Parameter>
        <ssv:Parameter name='b'><ssv:String><ssv:Value value='x y'/><ssv:Value value=''/></ssv:String>\
        <ssv:Dimension size='2'/></ssv:Parameter>
        <ssv:Parameter name='c'><ssv:UInt8 value='300'/></ssv:Parameter>
        </ssv:Parameters></ssv:ParameterSet>";
    let (set, problems) = read_parameters(text).unwrap();
    assert_eq!(problems.len(), 1);
    assert_eq!((problems[0].line, set.parameters.len()), (4, 2));
    assert_eq!(set.parameters[0].value, Value::Float(vec![1.0, 2.0, 3.0]));
    assert_eq!(set.parameters[1].value, Value::String(vec!["x y".to_owned(), String::new()]));
    let written = write_parameters(&set).unwrap();
    let (again, problems) = read_parameters(&written).unwrap();
    assert_eq!(problems, []);
    assert_eq!(write_parameters(&again).unwrap(), written);

    let mapping = ParameterMapping {
        version: SspVersion::V1,
        description: None,
        entries: [
            Some(Transformation::Boolean(vec![(true, false)])),
            Some(Transformation::Integer(vec![(1, -2)])),
            Some(Transformation::Enumeration(vec![("ZV".to_owned(), "Z V".to_owned())])),
            None,
        ]
        .map(|transformation| MappingEntry {
            source: "a".to_owned(),
            target: "b".to_owned(),
            suppress_unit_conversion: true,
            transformation,
            line: 0,
        })
        .to_vec(),
    };
    let (mut again, problems) = read_mapping(&write_mapping(&mapping).unwrap()).unwrap();
    assert_eq!(problems, []);
    again.entries.iter_mut().for_each(|entry| entry.line = 0);
    assert_eq!(again, mapping);
}

/// Replaces a part of the crane, reads and checks it.
fn problems_after(from: &str, to: &str) -> Vec<Problem> {
    assert_eq!(CRANE.matches(from).count(), 1, "{from}");
    let (description, mut problems) = read_system(&CRANE.replace(from, to)).expect("well-formed");
    problems.extend(check(&description));
    problems
}

#[track_caller]
fn problem(from: &str, to: &str, message: &str) {
    let line = CRANE.split(from).next().unwrap_or_default().matches('\n').count() + 1;
    let problems = problems_after(from, to);
    assert_eq!(problems.len(), 1, "{problems:#?}");
    assert!(problems[0].message.contains(message), "{}", problems[0]);
    assert_eq!(problems[0].line, line, "{}", problems[0]);
}

#[test]
fn the_crane_has_no_problems() {
    assert_eq!(check(&crane()), []);
}

#[test]
fn broken_forms_are_reported_in_their_line() {
    problem("<ssc:Item name=\"ZVD\" value=\"2\"/>", "<ssc:Item name=\"ZVD\" value=\"two\"/>", "must be a whole number");
    problem("stopTime=\"60\"", "stopTim=\"60\"", "no attribute `stopTim`");
    problem("implementation=\"CoSimulation\"", "implementation=\"CS\"", "must be one of any, ModelExchange");
    problem("<ssv:Integer value=\"3\"/>", "", "needs a type and a value");
    problem("<ssv:Integer value=\"3\"/>", "<ssv:Integer value=\"3000000000\"/>", "must be from");
    problem("<ssv:Integer value=\"3\"/>", "<ssv:Integer value=\"3\"/><ssv:Real value=\"3\"/>", "does not belong");
    problem(
        "<ssc:LinearTransformation factor=\"1000\"/>",
        "<ssc:LinearTransformation/><ssc:BooleanMappingTransformation><ssc:MapEntry source='1' target='0'/>\
         </ssc:BooleanMappingTransformation>",
        "more than one transformation",
    );
    problem(
        "<ssd:Connector name=\"wind.x\" kind=\"input\"/>",
        "<ssd:Connector name=\"wind.x\" kind=\"input\"><ssc:Dimension size='1' sizeConnector='n'/></ssd:Connector>",
        "both `size` and `sizeConnector`",
    );
    problem(
        "<ssd:Connector name=\"wind.x\" kind=\"input\"/>",
        "<ssd:Connector name=\"wind.x\" kind=\"input\"><ssc:Complex/></ssd:Connector>",
        "`Complex` does not belong",
    );
    problem(
        "<ssv:String value=\"a b.csv\"/>",
        "<ssv:String value=\"a\"><ssv:Value value=\"b\"/></ssv:String>",
        "both `value` and `Value`",
    );
    problem("<ssd:Elements>", "<ssd:Elements><ssd:Part/>", "`Part` does not belong into `Elements`");
    problem("<ssv:Boolean value=\"1\"/>", "<ssv:Boolean/>", "needs the attribute `value`");
    problem("<ssv:Binary value=\"00ff\"/>", "<ssv:Binary value=\"00f\"/>", "hexadecimal");
    problem("<ssd:ParameterBinding source=\"extra/start.ssv\"", "<ssd:ParameterBinding ", "neither a `source`");
    problem("<ssd:ParameterBinding prefix=\"plant.\">", "<ssd:ParameterBinding source=\"x\">", "both a `source`");
    problem("<ssd:SystemGeometry x1", "<ssd:Geometry x1", "`Geometry` does not belong into `System`");
    problem(
        "<ssd:Connector name=\"wind.x\" kind=\"input\"/>",
        "<ssd:Connector name=\"wind.x\" kind=\"in\"/>",
        "must be one of",
    );
}

#[test]
fn what_does_not_fit_together_is_reported_in_its_line() {
    problem(
        "startElement=\"plant\" startConnector=\"swing.radial\"",
        "startElement=\"plan\" startConnector=\"x\"",
        "no element `plan`",
    );
    problem(
        "startElement=\"plant\" startConnector=\"swing.radial\"",
        "startElement=\"plant\" startConnector=\"x\"",
        "no connector `plant.x`",
    );
    problem(
        "startElement=\"plant\" startConnector=\"swing.radial\"",
        "startElement=\"plant\" startConnector=\"wind.x\"",
        "cannot be connected",
    );
    problem(
        "endElement=\"plant\" endConnector=\"wind.x\"",
        "endElement=\"plant\" endConnector=\"kind\"",
        "cannot be connected",
    );
    problem(
        "startConnector=\"wind\" endElement=\"plant\" endConnector=\"wind.x\"",
        "startConnector=\"wind\" endElement=\"plant\" endConnector=\"slew.rate\"",
        "already has a source, in line 62",
    );
}

#[test]
fn names_and_definitions_are_unique_and_known() {
    for (from, to, message) in [
        ("<ssd:Connector name=\"kind\"", "<ssd:Connector name=\"slew.rate\"", "connector `slew.rate` is there twice"),
        ("<ssd:Component name=\"drive\"", "<ssd:Component name=\"plant\"", "element `plant` is there twice"),
        ("<ssv:Parameter name=\"parts\">", "<ssv:Parameter name=\"file\">", "parameter `file` is"),
        ("<ssc:Item name=\"ZVD\" value=\"2\"/>", "<ssc:Item name=\"ZV\" value=\"2\"/>", "item of `Kind` `ZV` is"),
        ("<ssc:Unit name=\"N\">", "<ssc:Unit name=\"rad\">", "unit `rad` is there twice"),
        ("<ssc:Unit name=\"deg\">", "<ssc:Unit name=\"grad\">", "unit `deg`"),
        ("<ssc:Enumeration name=\"Kind\"/>", "<ssc:Enumeration name=\"Kin\"/>", "enumeration `Kin`"),
        ("<ssv:Enumeration value=\"ZVD\" name=\"Kind\"/>", "<ssv:Enumeration value=\"ZVD\" name=\"Kin\"/>", "`Kin`"),
        ("<ssv:Real value=\"6.5\" unit=\"m\"/>", "<ssv:Real value=\"6.5\" unit=\"km\"/>", "unit `km`"),
        ("source=\"resources/BoomCrane.fmu\"", "source=\"https://x/BoomCrane.fmu\"", "`https:`"),
        ("source=\"resources/more.ssv\"", "source=\"%\"", "not a valid URI"),
        ("<ssd:ParameterMapping>", "<ssd:ParameterMapping source=\"%\"/><ssd:ParameterMapping>", "parameter mapping: "),
        ("version=\"1.0\" name=\"Crane\"", "version=\"3.0\" name=\"Crane\"", "only SSP 1 and SSP 2"),
        ("startTime=\"0\"", "startTime=\"61\"", "before it starts"),
        ("<ssd:Component name=\"drive\"", "<ssd:Component name=\"\"", "not empty"),
    ] {
        let problems = problems_after(from, to);
        assert!(problems.iter().any(|p| p.message.contains(message)), "{message}: {problems:#?}");
    }
}

#[test]
fn a_wrong_namespace_is_said_once() {
    let (_, problems) = read_system(&CRANE.replace("SSP1/SystemStructureDescription", "SSP3/X")).unwrap();
    assert_eq!(problems.len(), 1, "{problems:#?}");
    assert!(problems[0].message.contains("xmlns"));
}

#[test]
fn signal_dictionaries_are_skipped_with_a_warning() {
    let (description, problems) = read_system(
        &CRANE.replace("<ssd:Elements>", "<ssd:Elements><ssd:SignalDictionaryReference name='d' dictionary='e'/>"),
    )
    .unwrap();
    assert_eq!(description.system.elements.len(), 2);
    assert_eq!(problems[0].severity, Severity::Warning);
}

#[test]
fn elements_must_not_be_empty() {
    let text = "<ssd:SystemStructureDescription xmlns:ssd='http://ssp-standard.org/SSP1/SystemStructureDescription' \
        version='1.0' name='a'><ssd:System name='b'><ssd:Elements/></ssd:System></ssd:SystemStructureDescription>";
    let (_, problems) = read_system(text).unwrap();
    assert_eq!(problems.len(), 1);
    assert!(problems[0].message.contains("`Elements` must not be empty"));
}

#[test]
fn another_root_is_an_error() {
    assert!(read_parameters(CRANE).unwrap_err().message.contains("must be `ParameterSet`"));
}
