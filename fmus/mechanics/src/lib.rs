//! Suspended payloads and crane kinematics.
