//! The derive macro for the variables of a model.
