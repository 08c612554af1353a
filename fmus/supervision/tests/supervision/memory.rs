//! What is remembered comes back, and nonsense does not.

use swayless_supervision::{Observation, Supervisor};

use crate::plant::{Plant, asked, settings};

#[test]
fn a_supervisor_comes_back() {
    let mut plant = Plant::new(settings());
    plant.run(0.7, 2.0);
    plant.step(Observation { emergency_stop: true, hook_valid: false, ..asked(0.1) });
    let bytes = postcard::to_allocvec(&plant.supervisor).expect("bytes");
    assert_eq!(postcard::from_bytes::<Supervisor>(&bytes).expect("a supervisor"), plant.supervisor);
}

#[test]
fn what_is_not_finite_is_refused() {
    let supervisor = Supervisor::default();
    let bytes = postcard::to_allocvec(&supervisor).expect("bytes");
    let zero = [0_u8; 8];
    let places: Vec<usize> = (0..bytes.len() - 8).filter(|at| bytes[*at..at + 8] == zero).collect();
    assert!(places.len() > 20);
    // The first numbers are velocities, after two times that are not there.
    for wrong in [f64::NAN, f64::INFINITY, 1.1e9] {
        let mut forged = bytes.clone();
        forged[2..10].copy_from_slice(&wrong.to_le_bytes());
        assert!(postcard::from_bytes::<Supervisor>(&forged).is_err(), "{wrong}");
    }
}
