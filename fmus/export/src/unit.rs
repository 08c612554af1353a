//! The units that variables may have, each declared once with its quantity, dimensions and display units.

/// A unit: SI, so that the conversion factor is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// How it is written.
    pub symbol: &'static str,
    /// The quantity it measures, which also names the type definition of variables in this unit.
    pub quantity: &'static str,
    /// Exponents of kg, m, s, A, K, mol, cd, rad.
    pub exponents: [i32; 8],
    /// What users may want to see instead: name and display value per value. The first is shown by default.
    pub display: &'static [(&'static str, f64)],
}

const DEGREES: f64 = 180.0 / core::f64::consts::PI;
const PER_TURN: f64 = 0.5 / core::f64::consts::PI;

const fn unit(
    symbol: &'static str,
    quantity: &'static str,
    [kg, m, s, rad]: [i32; 4],
    display: &'static [(&'static str, f64)],
) -> Unit {
    Unit { symbol, quantity, exponents: [kg, m, s, 0, 0, 0, 0, rad], display }
}

/// All units.
pub const UNITS: &[Unit] = &[
    unit("1", "Ratio", [0, 0, 0, 0], &[]),
    unit("s", "Time", [0, 0, 1, 0], &[]),
    unit("1/s", "Rate", [0, 0, -1, 0], &[]),
    unit("m", "Length", [0, 1, 0, 0], &[]),
    unit("m/s", "Velocity", [0, 1, -1, 0], &[]),
    unit("m/s2", "Acceleration", [0, 1, -2, 0], &[]),
    unit("rad", "Angle", [0, 0, 0, 1], &[("deg", DEGREES)]),
    unit("rad/s", "AngularVelocity", [0, 0, -1, 1], &[("deg/s", DEGREES), ("Hz", PER_TURN)]),
    unit("rad/s2", "AngularAcceleration", [0, 0, -2, 1], &[("deg/s2", DEGREES)]),
    unit("kg", "Mass", [1, 0, 0, 0], &[("t", 1e-3)]),
    unit("kg.m2", "MomentOfInertia", [1, 2, 0, 0], &[]),
    unit("kg/s", "MassFlow", [1, 0, -1, 0], &[]),
    unit("N", "Force", [1, 1, -2, 0], &[("kN", 1e-3)]),
];

impl Unit {
    /// The unit of the symbol; an unknown one stops the compilation when evaluated in a constant.
    pub const fn named(symbol: &str) -> Self {
        let mut i = 0;
        while i < UNITS.len() {
            if same(UNITS[i].symbol, symbol) {
                return UNITS[i];
            }
            i += 1;
        }
        panic!("unknown unit: the units are declared in fmus/export/src/unit.rs");
    }

    /// The unit that a state's time derivative has.
    pub fn per_second(self) -> Option<Self> {
        let mut exponents = self.exponents;
        exponents[2] -= 1;
        UNITS.iter().copied().find(|unit| unit.exponents == exponents)
    }
}

const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len() != b.len() {
        return false;
    }
    let mut i = 0;
    while i < a.len() {
        if a[i] != b[i] {
            return false;
        }
        i += 1;
    }
    true
}
