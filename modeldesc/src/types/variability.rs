//! Causality, variability, initial, and which of them go together.

use super::name_of;

/// `causality`. Its names are [`Causality::as_str`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Causality {
    StructuralParameter,
    Parameter,
    CalculatedParameter,
    Input,
    Output,
    Local,
    Independent,
}

impl Causality {
    /// Every causality with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 7] = [
        ("structuralParameter", Self::StructuralParameter),
        ("parameter", Self::Parameter),
        ("calculatedParameter", Self::CalculatedParameter),
        ("input", Self::Input),
        ("output", Self::Output),
        ("local", Self::Local),
        ("independent", Self::Independent),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }
}

/// `variability`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Variability {
    Constant,
    Fixed,
    Tunable,
    Discrete,
    Continuous,
}

impl Variability {
    /// Every variability with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 5] = [
        ("constant", Self::Constant),
        ("fixed", Self::Fixed),
        ("tunable", Self::Tunable),
        ("discrete", Self::Discrete),
        ("continuous", Self::Continuous),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }
}

/// `initial`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Initial {
    Exact,
    Approx,
    Calculated,
}

impl Initial {
    /// Every initial with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 3] =
        [("exact", Self::Exact), ("approx", Self::Approx), ("calculated", Self::Calculated)];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }

    /// What `initial` may be, its default first (FMI 2.0.5 section 2.2.7, FMI 3.0.2 section 2.4.7.4): nothing for the
    /// independent variable; exact for inputs, which FMI 2.0 leaves unsaid. Empty for combinations that may not be.
    pub fn allowed_for(causality: Causality, variability: Variability) -> &'static [Self] {
        use Causality as C;
        use Variability as V;
        match (causality, variability) {
            (C::StructuralParameter | C::Parameter, V::Fixed | V::Tunable)
            | (C::Input, V::Discrete | V::Continuous)
            | (C::Output | C::Local, V::Constant) => &[Self::Exact],
            (C::CalculatedParameter | C::Local, V::Fixed | V::Tunable) => &[Self::Calculated, Self::Approx],
            (C::Output | C::Local, V::Discrete | V::Continuous) => &[Self::Calculated, Self::Exact, Self::Approx],
            _ => &[],
        }
    }

    /// What `initial` is when it is not written.
    pub fn default_for(causality: Causality, variability: Variability) -> Option<Self> {
        Self::allowed_for(causality, variability).first().copied()
    }
}
