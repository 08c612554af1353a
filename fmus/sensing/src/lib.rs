//! What sampled sensors are made of.
//!
//! A [`Sampler`] takes samples, adds [`Noise`] that a seed repeats, and gives each sample out when its latency has passed;
//! [`quantise`] rounds to what a sensor can tell apart; [`Camera`] is one that looks down at a payload.
//!
//! ```
//! use swayless_sensing::{Sampler, Timing, quantise};
//!
//! let timing = Timing { sample_time: 0.04, latency: 0.06 };
//! let mut sampler = Sampler::new(1, timing);
//! let now = sampler.sample(2.0, timing, |noise| Some([quantise(17.0 + 0.002 * noise.draw(), 0.001)]));
//! assert_eq!((now, sampler.next_delivery()), (None, Some(2.06)));
//! sampler.deliver(2.06, |reading| assert!((reading.unwrap()[0] - 17.0).abs() < 0.02));
//! ```
//!
//! Units are SI. Nothing allocates once a sampler is made: what it has room for is bounded.

mod camera;
mod delay;
mod noise;
mod quantise;
mod sampler;
mod timing;

pub use camera::{Camera, Located};
pub use noise::Noise;
pub use quantise::quantise;
pub use sampler::Sampler;
pub use timing::{MOST_UNDER_WAY, Timing, TimingError};
