//! Getting and setting values of every type.

use std::ffi::CStr;
use std::ptr;

use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::fmi3;

use crate::ball::Ball;
use crate::host::Host;

#[test]
fn an_array_is_one_variable() {
    let ball = Host::co_simulation();
    let reference = ball.reference("weights");
    let given = [4.0, 5.0, 6.0];
    let mut found = [0.0; 4];
    // SAFETY: arrays of the sizes announced.
    unsafe {
        assert_eq!(fmi3::fmi3SetFloat64::<Ball>(ball.instance, &reference, 1, given.as_ptr(), 3), OK);
        ball.initialize();
        let both = [reference, ball.reference("gravity")];
        assert_eq!(fmi3::fmi3GetFloat64::<Ball>(ball.instance, both.as_ptr(), 2, found.as_mut_ptr(), 4), OK);
        assert_eq!(found, [4.0, 5.0, 6.0, 9.81]);
        assert_eq!(fmi3::fmi3GetFloat64::<Ball>(ball.instance, both.as_ptr(), 2, found.as_mut_ptr(), 3), ERROR);
        assert!(ball.last_message().contains('4'), "{}", ball.last_message());
    }
}

#[test]
fn an_element_is_no_variable_of_its_own() {
    let ball = Host::co_simulation();
    ball.initialize();
    let inside = ball.reference("weights") + 1;
    let mut value = 0.0;
    // SAFETY: one reference and one value.
    let status = unsafe { fmi3::fmi3GetFloat64::<Ball>(ball.instance, &inside, 1, &mut value, 1) };
    assert_eq!(status, ERROR);
}

#[test]
fn texts_and_items_come_back() {
    let ball = Host::co_simulation();
    let label = ball.reference("label");
    let ground = ball.reference("ground");
    let mut text = ptr::null();
    let mut item = 0;
    // SAFETY: one reference and one value each; the text lives until the next call.
    unsafe {
        let given = c"größer";
        assert_eq!(fmi3::fmi3SetString::<Ball>(ball.instance, &label, 1, &given.as_ptr(), 1), OK);
        assert_eq!(ball.set_item("ground", 2), OK);
        ball.initialize();
        assert_eq!(fmi3::fmi3GetString::<Ball>(ball.instance, &label, 1, &mut text, 1), OK);
        assert_eq!(CStr::from_ptr(text), given);
        assert_eq!(fmi3::fmi3GetInt64::<Ball>(ball.instance, &ground, 1, &mut item, 1), OK);
    }
    assert_eq!(item, 2);
    assert_eq!(ball.integer("number"), -7);
}

#[test]
fn nothing_is_fine_with_null_and_dangling_pointers() {
    let ball = Host::co_simulation();
    ball.initialize();
    let dangling = ptr::dangling::<u32>();
    // SAFETY: nothing is announced, so nothing is read.
    unsafe {
        assert_eq!(fmi3::fmi3GetFloat64::<Ball>(ball.instance, dangling, 0, ptr::null_mut(), 0), OK);
        assert_eq!(fmi3::fmi3SetFloat64::<Ball>(ball.instance, ptr::null(), 0, ptr::null(), 0), OK);
        assert_eq!(fmi3::fmi3GetUInt16::<Ball>(ball.instance, ptr::null(), 0, ptr::null_mut(), 0), OK);
        assert_eq!(fmi3::fmi3GetFloat64::<Ball>(ball.instance, ptr::null(), 1, ptr::null_mut(), 1), ERROR);
        assert_eq!(fmi3::fmi3GetFloat64::<Ball>(ptr::null_mut(), ptr::null(), 0, ptr::null_mut(), 0), ERROR);
        fmi3::fmi3FreeInstance::<Ball>(ptr::null_mut());
    }
}

#[test]
fn outputs_are_consistent_in_initialization_mode() {
    let ball = Host::co_simulation();
    assert_eq!(ball.enter_initialization(), OK);
    assert_eq!(ball.set("height", 3.0), OK);
    assert_eq!(ball.get("clearance"), 3.0);
    assert_eq!(ball.set("floor", 1.0), OK);
    assert_eq!(ball.get("clearance"), 2.0);
    assert_eq!(ball.set("gravity", 2.0), OK);
    assert_eq!(ball.get("der(velocity)"), -2.0);
    assert_eq!(ball.get("energy"), 6.0);
}
