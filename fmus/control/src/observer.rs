//! What a camera sees late, and what is known of the drive, together: where hook and payload are now.

use nalgebra::{SMatrix, SVector, Vector2};
use serde::{Deserialize, Serialize};

use crate::crane::{BOUND, State};
use crate::pendulum::{Modes, Pendulum, Swing, Transition};

/// p, ṗ, and how far the camera's zero is off.
const ORDER: usize = 5;

type Covariance = SMatrix<f64, ORDER, ORDER>;
type Column = SVector<f64, ORDER>;

/// What is not known exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainty {
    /// Standard deviation of a measured displacement (m).
    pub noise: f64,
    /// Density of the accelerations that the model does not know of (m/s² per √Hz).
    pub disturbance: f64,
    /// Density of how the zero of the measurement wanders (m per √s).
    pub wander: f64,
    /// Standard deviation of the swing angle (rad) before anything has been measured.
    pub start: f64,
    /// The same of the zero of the measurement (m).
    pub offset: f64,
}

/// A Kalman filter for hook and payload, without the swing itself, which is part of a crane's [`State`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Numbers", into = "Numbers")]
pub struct Observer {
    covariance: Covariance,
    /// How far the camera's zero is off (m).
    offset: f64,
}

/// What an observer is serialized as: the upper triangle, and the offset.
type Numbers = [f64; ORDER * (ORDER + 1) / 2 + 1];

impl From<Observer> for Numbers {
    fn from(observer: Observer) -> Self {
        let triangle = (0..ORDER).flat_map(|column| (0..=column).map(move |row| (row, column)));
        let mut numbers = [observer.offset; ORDER * (ORDER + 1) / 2 + 1];
        numbers.iter_mut().zip(triangle).for_each(|(number, place)| *number = observer.covariance[place]);
        numbers
    }
}

impl TryFrom<Numbers> for Observer {
    type Error = &'static str;

    fn try_from(numbers: Numbers) -> Result<Self, Self::Error> {
        if !numbers.iter().all(|number| number.abs() <= BOUND * BOUND) {
            return Err("an observer knows less than nothing");
        }
        let triangle = (0..ORDER).flat_map(|column| (0..=column).map(move |row| (row, column)));
        let mut covariance = Covariance::zeros();
        numbers.iter().zip(triangle).for_each(|(number, (row, column))| {
            covariance[(row, column)] = *number;
            covariance[(column, row)] = *number;
        });
        Ok(Self { covariance, offset: numbers[numbers.len() - 1] })
    }
}

impl Observer {
    /// One that has seen nothing of a pendulum.
    #[must_use]
    pub fn new(pendulum: &Pendulum, modes: &Modes, uncertainty: &Uncertainty) -> Self {
        let hook = uncertainty.start * pendulum.hoist;
        let payload = uncertainty.start * (pendulum.hoist + pendulum.rigging) * pendulum.mass_ratio.sqrt();
        let places = [hook, payload];
        let deviations =
            [places[0], places[1], places[0] * modes.frequency[1], places[1] * modes.frequency[1], uncertainty.offset];
        let covariance = Covariance::from_diagonal(&Column::from(deviations.map(|deviation| deviation * deviation)));
        Self { covariance, offset: 0.0 }
    }

    /// How far the camera's zero is off (m), as far as it is known.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// An interval (s) passes.
    #[must_use]
    pub fn after(
        &self,
        pendulum: &Pendulum,
        transition: &Transition,
        uncertainty: &Uncertainty,
        interval: f64,
    ) -> Self {
        let mut f = Covariance::identity();
        f.fixed_view_mut::<2, 2>(0, 0).copy_from(&transition.cosine);
        f.fixed_view_mut::<2, 2>(0, 2).copy_from(&transition.sine);
        f.fixed_view_mut::<2, 2>(2, 0).copy_from(&-transition.force);
        f.fixed_view_mut::<2, 2>(2, 2).copy_from(&transition.cosine);
        let mut covariance = f * self.covariance * f.transpose();
        let pushed = uncertainty.disturbance * uncertainty.disturbance * interval;
        covariance[(2, 2)] += pushed;
        covariance[(3, 3)] += pendulum.mass_ratio * pushed;
        covariance[(4, 4)] += uncertainty.wander * uncertainty.wander * interval;
        Self { covariance, offset: self.offset }
    }

    /// Little more uncertain than one that has seen nothing, and that one where numbers have failed.
    #[must_use]
    pub fn bounded(&self, unknown: &Self) -> Self {
        const MOST: f64 = 4.0;
        let (here, there) = (self.covariance.diagonal(), unknown.covariance.diagonal());
        if !self.offset.is_finite() || self.covariance.iter().any(|c| !c.is_finite()) || here.iter().any(|c| *c < 0.0) {
            return *unknown;
        }
        let bound =
            here.zip_map(&there, |here, there| if here > MOST * there { (MOST * there / here).sqrt() } else { 1.0 });
        // Each row and its column by the same share: the whole stays a covariance.
        let covariance = self.covariance.map_with_location(|row, column, c| bound[row] * bound[column] * c);
        let covariance = 0.5 * (covariance + covariance.transpose());
        Self { covariance, offset: self.offset }
    }

    /// The hook was seen at `displacement` (m) a time `latency` (s) ago. The swing is corrected with it.
    ///
    /// What the hook did since is known: with the swing as it is now and the trolley's acceleration, the model runs back.
    #[must_use]
    pub fn correct(
        &self,
        (pendulum, modes): (&Pendulum, &Modes),
        state: State,
        (displacement, latency): (f64, f64),
        uncertainty: &Uncertainty,
    ) -> (Self, State) {
        let back = modes.transition(-latency);
        let then = back.of(state.swing, pendulum.rest(state.motion.acceleration));
        let row = Column::new(back.cosine[(0, 0)], back.cosine[(0, 1)], back.sine[(0, 0)], back.sine[(0, 1)], 1.0);
        let innovation = displacement - (then.place[0] + self.offset);
        let seen = self.covariance * row;
        let gain = seen / (row.dot(&seen) + uncertainty.noise * uncertainty.noise);
        let correction = gain * innovation;
        let swing = Swing {
            place: state.swing.place + Vector2::new(correction[0], correction[1]),
            rate: state.swing.rate + Vector2::new(correction[2], correction[3]),
        };
        let observer =
            Self { covariance: self.covariance - gain * seen.transpose(), offset: self.offset + correction[4] };
        (observer, State { motion: state.motion, swing }.bounded())
    }
}
