//! Mobile boom crane with a suspended payload.
