//! Turns one model into an FMU for FMI 2.0 and FMI 3.0, co-simulation and model exchange.
