//! Samplers, noise, quantisation and the camera against statistics, closed forms and geometry done another way.

mod camera;
mod noise;
mod quantise;
mod sampler;
mod timing;
