//! Properties that hold for every description and for every text, however broken.

use crate::any_description::description;
use crate::samples::without_lines;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use swayless_modeldesc::check::{check, read_and_check};
use swayless_modeldesc::read::read;
use swayless_modeldesc::ssp;
use swayless_modeldesc::types::*;
use swayless_modeldesc::write::write;

/// A good document to break.
fn document() -> impl Strategy<Value = String> {
    select(vec![
        include_str!("../golden/fmi2.xml"),
        include_str!("../golden/fmi3.xml"),
        include_str!("../golden/fmi3_clocks.xml"),
        include_str!("../golden/crane_written.ssd"),
        include_str!("../golden/crane_by_hand.ssd"),
    ])
    .prop_map(str::to_owned)
}

/// Texts that parsers stumble over.
const NASTY: &[&str] = &[
    "<",
    ">",
    "/>",
    "\"",
    "&",
    "&amp;",
    "&#0;",
    "&#x110000;",
    "&x;",
    "<!DOCTYPE x [<!ENTITY x \"y\">]>",
    "<![CDATA[",
    "]]>",
    "<!--",
    "-->",
    "<?",
    "?>",
    "xmlns:x=''",
    "99999999999999999999999999999999999999999999",
    "-1",
    "1e999",
    "\u{feff}",
    "ä",
];

/// Cuts, doubles, moves and replaces parts of a text.
fn broken(mut text: String, changes: &[(u8, Index, Index, Index)]) -> String {
    for (kind, from, to, what) in changes {
        let boundaries: Vec<usize> = text.char_indices().map(|(at, _)| at).chain([text.len()]).collect();
        let (a, b) = (*from.get(&boundaries), *to.get(&boundaries));
        let nasty: &str = what.get::<&str>(NASTY);
        let near = boundaries.iter().copied().find(|at| *at > a + (b % 40)).unwrap_or(text.len());
        match kind % 6 {
            0 => text.truncate(a),
            1 => text.replace_range(a..near, ""),
            2 => {
                let part = text[a..near].to_owned();
                text.insert_str(b, &part);
            }
            3 => text.insert_str(a, nasty),
            4 => text.replace_range(a..near, nasty),
            _ => {
                // The value of an attribute, where most of the meaning is.
                let quote = text[a..].find("=\"").map_or(text.len(), |at| a + at + 2);
                let end = text[quote..].find('"').map_or(text.len(), |at| quote + at);
                text.replace_range(quote..end, nasty);
            }
        }
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn what_was_written_is_read(description in description()) {
        let written = write(&description).expect("what the version can say");
        let (again, problems) = read(&written).expect("well-formed");
        prop_assert_eq!(&problems, &[], "{}", written);
        prop_assert_eq!(without_lines(again), description);
    }

    #[test]
    fn nothing_makes_the_checker_panic(mut description in description(), index in any::<usize>()) {
        check(&description);
        // Nobody promises that indices of a description made by hand lead somewhere.
        for unknown in &mut description.structure.outputs {
            unknown.variable = index;
            unknown.dependencies = Some(vec![index]);
        }
        for variable in &mut description.variables {
            variable.derivative = Some(index);
            variable.previous = Some(index);
            variable.dimensions = vec![Dimension::Fixed(u64::MAX), Dimension::Variable(0), Dimension::Variable(9)];
        }
        check(&description);
    }

    #[test]
    fn broken_documents_make_nothing_panic(
        document in document(),
        changes in prop::collection::vec(any::<(u8, Index, Index, Index)>(), 1..5),
    ) {
        let text = broken(document, &changes);
        let _ = read_and_check(text.as_bytes());
        {
            if let Ok((system, _)) = ssp::read_system(&text) {
                ssp::check(&system);
                let _ = ssp::write_system(&system);
            }
            let _ = ssp::read_parameters(&text);
            let _ = ssp::read_mapping(&text);
        }
    }

    #[test]
    fn bytes_make_nothing_panic(bytes in any::<Vec<u8>>()) {
        let _ = read_and_check(&bytes);
    }
}
