//! `Oscillator`: a mass on a spring.

use swayless_export::{Info, Model, Point, Scalar, Variables, export_fmu};

struct Oscillator;

#[derive(Clone, Variables)]
struct Parameters<R: Scalar> {
    /// Natural frequency.
    #[variable(unit = "rad/s", start = 2.0, min = 0.0)]
    frequency: R,
}

#[derive(Clone, Variables)]
struct States<R: Scalar> {
    /// Position of the mass.
    #[variable(unit = "m", output, start = 1.0)]
    position: R,
    /// Velocity of the mass.
    #[variable(unit = "m/s")]
    velocity: R,
}

impl Model for Oscillator {
    const INFO: Info = Info::new("Oscillator", "A mass on a spring");
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = ();
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = ();
    type Memory = ();
    type Indicators = [f64; 0];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let stiffness = at.p.frequency * at.p.frequency;
        States { position: at.x.velocity, velocity: -at.x.position * stiffness }
    }

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}
}

export_fmu!(Oscillator);
