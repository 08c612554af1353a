//! The number that model equations are written over: values and dependency sets.
