//! States: complete, portable, reusable, and refused when they are not what they claim.

use std::ffi::c_void;
use std::ptr::null_mut;

use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::{fmi2, fmi3};

use crate::ball::Ball;
use crate::host::Host;

/// A state that is freed in the end.
struct State<'a>(&'a Host, *mut c_void);

impl<'a> State<'a> {
    fn of(host: &'a Host) -> Self {
        let mut state = null_mut();
        // SAFETY: an instance and a place.
        assert_eq!(unsafe { fmi3::fmi3GetFMUState::<Ball>(host.instance, &mut state) }, OK, "{:?}", host.log);
        Self(host, state)
    }

    fn bytes(&self) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: an instance with its state, and room of the size announced.
        unsafe {
            assert_eq!(fmi3::fmi3SerializedFMUStateSize::<Ball>(self.0.instance, self.1, &mut size), OK);
            let mut bytes = vec![0; size];
            let status = fmi3::fmi3SerializeFMUState::<Ball>(self.0.instance, self.1, bytes.as_mut_ptr(), size);
            assert_eq!(status, OK);
            assert_eq!(
                fmi3::fmi3SerializeFMUState::<Ball>(
                    Host::co_simulation().instance,
                    self.1,
                    bytes.as_mut_ptr(),
                    size - 1
                ),
                ERROR
            );
            bytes
        }
    }

    fn read(host: &'a Host, bytes: &[u8]) -> Option<Self> {
        let mut state = null_mut();
        // SAFETY: an instance, bytes and a place.
        let status =
            unsafe { fmi3::fmi3DeserializeFMUState::<Ball>(host.instance, bytes.as_ptr(), bytes.len(), &mut state) };
        (status == OK).then_some(Self(host, state))
    }

    fn set(&self, host: &Host) -> i32 {
        // SAFETY: an instance and a state.
        unsafe { fmi3::fmi3SetFMUState::<Ball>(host.instance, self.1) }
    }
}

impl Drop for State<'_> {
    fn drop(&mut self) {
        // SAFETY: an instance and a state that is not used again.
        let status = unsafe { fmi3::fmi3FreeFMUState::<Ball>(self.0.instance, &mut self.1) };
        assert!(status == OK && self.1.is_null() || std::thread::panicking());
    }
}

/// Steps from 0.4 s on, over bounces and ticks, and returns what there is to see.
fn go_on(ball: &Host) -> Vec<u64> {
    let mut seen = Vec::new();
    for n in 0..40 {
        assert_eq!(ball.step(0.4 + f64::from(n) * 0.025, 0.025), OK, "{:?}", ball.log);
        seen.extend([ball.get("height").to_bits(), ball.get("velocity").to_bits()]);
        seen.push(ball.integer("bounces") as u64 + 100 * ball.integer("ticks") as u64);
    }
    seen
}

/// A ball at 0.4 s, a tick of 0.07 s and a longer way from step to step behind it.
fn under_way() -> Host {
    let ball = Host::co_simulation();
    assert_eq!(ball.set("tick", 0.07), OK);
    assert_eq!(ball.set_item("ground", 1), OK);
    ball.initialize();
    for n in 0..4 {
        assert_eq!(ball.set("push", 0.1 * f64::from(n)), OK);
        assert_eq!(ball.step(0.1 * f64::from(n), 0.1), OK);
    }
    ball
}

#[test]
fn a_state_goes_on_to_the_same_bits_again_and_again() {
    let ball = under_way();
    let state = State::of(&ball);
    let first = go_on(&ball);
    assert_eq!(state.set(&ball), OK);
    assert_eq!(go_on(&ball), first);
    // After an error, too; and taking a state has changed nothing.
    assert_eq!(ball.step(77.0, 0.1), ERROR);
    assert_eq!(state.set(&ball), OK);
    assert_eq!(go_on(&ball), first);
    assert_eq!(go_on(&under_way()), first);
}

#[test]
fn bytes_carry_a_state_to_another_instance() {
    let ball = under_way();
    let bytes = State::of(&ball).bytes();
    let first = go_on(&ball);
    let other = Host::co_simulation();
    let state = State::read(&other, &bytes).unwrap();
    assert_eq!(state.set(&other), OK);
    assert_eq!(other.get("push"), 0.1 * 3.0);
    assert_eq!(go_on(&other), first);
    assert_eq!(state.bytes(), bytes);
}

#[test]
fn bytes_that_are_no_state_are_refused() {
    let ball = under_way();
    let bytes = State::of(&ball).bytes();
    for length in 0..bytes.len() {
        assert!(State::read(&ball, &bytes[..length]).is_none(), "{length} bytes");
    }
    for place in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x11;
        assert!(State::read(&ball, &damaged).is_none(), "byte {place}");
    }
    let mut longer = bytes.clone();
    longer.push(0);
    assert!(State::read(&ball, &longer).is_none());
    assert!(ball.last_message().contains("damaged"), "{}", ball.last_message());
}

#[test]
fn states_of_the_two_interfaces_are_not_mixed() {
    let ball = under_way();
    let exchange = Host::model_exchange();
    assert_eq!(State::of(&ball).set(&exchange), ERROR);
    assert!(exchange.last_message().contains("CoSimulation"), "{}", exchange.last_message());
}

#[test]
fn null_is_refused_or_nothing_to_do() {
    let ball = under_way();
    let mut none = null_mut();
    // SAFETY: an instance and places, some of them NULL.
    unsafe {
        assert_eq!(fmi3::fmi3FreeFMUState::<Ball>(ball.instance, &mut none), OK);
        assert_eq!(fmi3::fmi3FreeFMUState::<Ball>(ball.instance, null_mut()), OK);
        assert_eq!(fmi3::fmi3SetFMUState::<Ball>(ball.instance, null_mut()), ERROR);
        assert_eq!(fmi3::fmi3GetFMUState::<Ball>(ball.instance, null_mut()), ERROR);
    }
}

#[test]
fn a_state_can_be_taken_anew_into_its_place() {
    let ball = Host::co_simulation();
    ball.initialize();
    let mut state = State::of(&ball);
    assert_eq!(ball.step(0.0, 0.2), OK);
    let height = ball.get("height");
    let place = state.1;
    // SAFETY: an instance and a state of it.
    assert_eq!(unsafe { fmi3::fmi3GetFMUState::<Ball>(ball.instance, &mut state.1) }, OK);
    assert_eq!(state.1, place);
    assert_eq!(ball.step(0.2, 0.1), OK);
    assert_eq!(state.set(&ball), OK);
    assert_eq!(ball.get("height"), height);
}

#[test]
fn derivatives_of_inputs_are_part_of_a_state() {
    let ball = under_way();
    let (push, rate) = (ball.reference("push"), 5.0);
    // SAFETY: an instance, which is the same in both versions, and one value each.
    assert_eq!(unsafe { fmi2::fmi2SetRealInputDerivatives::<Ball>(ball.instance, &push, 1, &1, &rate) }, OK);
    let bytes = State::of(&ball).bytes();
    let other = Host::co_simulation();
    assert_eq!(State::read(&other, &bytes).unwrap().set(&other), OK);
    assert_eq!((ball.step(0.4, 0.01), other.step(0.4, 0.01)), (OK, OK));
    assert_eq!(ball.get("push"), 0.1 * 3.0 + rate * ((0.4 + 0.01) - 0.4));
    assert_eq!(other.get("push").to_bits(), ball.get("push").to_bits());
    assert_eq!(other.get("velocity").to_bits(), ball.get("velocity").to_bits());
}

/// Another phase, with a checksum that fits.
fn forged(bytes: &[u8], phase: u8) -> Vec<u8> {
    let values = bytes.len() - bytes.iter().position(|byte| *byte == b'}').unwrap() - 1 - 16;
    let (head, values) = bytes.split_at(bytes.len() - values);
    let mut values = values.to_vec();
    // The interface and whether there are clocks stand before the phase.
    values[2] = phase;
    // FNV-1a of 128 bits, from its reference.
    let checksum = values.iter().fold(0x6C62_272E_07BB_0142_62B8_2175_6295_C58D_u128, |hash, byte| {
        (hash ^ u128::from(*byte)).wrapping_mul((1 << 88) + 0x13B)
    });
    [&head[..head.len() - 16], &checksum.to_le_bytes(), &values].concat()
}

#[test]
fn bytes_of_a_run_that_was_never_initialized_are_refused() {
    let ball = Host::co_simulation();
    let instantiated = State::of(&ball).bytes();
    assert!(State::read(&ball, &forged(&instantiated, 1)).is_some(), "the forgery itself is right");
    // Event, continuous time, step, terminated.
    for phase in [4, 8, 16, 32] {
        assert_eq!(ball.reset(), OK);
        assert!(State::read(&ball, &forged(&instantiated, phase)).is_none(), "{phase}");
        assert!(ball.last_message().contains("refused"), "{}", ball.last_message());
    }
    // Not checked, but taken at their word: parameters that no model has seen.
    assert_eq!(ball.reset(), OK);
    assert_eq!((ball.set("restitution", 7.0), ball.enter_initialization()), (OK, OK));
    let unchecked = State::of(&ball).bytes();
    assert!(State::read(&ball, &forged(&unchecked, 16)).is_none());
}
