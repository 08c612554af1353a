//! A model whose declarations name what is not there describes itself as one that cannot be.

use std::ffi::c_void;

use swayless_export::abi::describe::{CANNOT, FMI3};
use swayless_export::{Clock, Info, Interval, Model, Point, Scalar, Variables, swayless_describe};

struct Lost;

#[derive(Clone, Variables)]
struct Discrete<R: Scalar> {
    /// Depends on nothing there is.
    #[variable(output, depends_on = ["sea"])]
    island: R,
    /// As long as nothing there is.
    #[variable(output, length = "tail")]
    dog: [R; 3],
    /// Computed when nothing there is ticks.
    #[variable(output, clock = "moon heart")]
    blood: R,
}

impl Model for Lost {
    const INFO: Info = Info::new("Lost", "Names that lead nowhere");
    const CLOCKS: &'static [Clock] = &[Clock { by: &["sun"], ..Clock::new("moon", "Shines", Interval::Triggered) }];
    type Parameters<R: Scalar> = ();
    type Inputs<R: Scalar> = ();
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = ();
    type Indicators = [f64; 0];

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}
}

unsafe extern "C" fn collect(context: *mut c_void, bytes: *const u8, count: usize) {
    // SAFETY: the test's own vector, and bytes that are valid during the call.
    unsafe { (*context.cast::<Vec<u8>>()).extend_from_slice(std::slice::from_raw_parts(bytes, count)) };
}

#[test]
fn names_that_lead_nowhere_are_told_all_at_once() {
    let mut answer = Vec::<u8>::new();
    // SAFETY: the sink takes the context it is given.
    let status = unsafe { swayless_describe::<Lost>(FMI3.as_ptr(), Some(collect), (&raw mut answer).cast()) };
    let text = String::from_utf8(answer).unwrap();
    assert_eq!(status, CANNOT, "{text}");
    for (who, what) in [("island", "`sea`"), ("dog", "`tail`"), ("blood", "`heart`"), ("moon", "`sun`")] {
        assert!(text.contains(who) && text.contains(what), "{text}");
    }
    assert!(!text.contains("`moon`"), "{text}");
}
