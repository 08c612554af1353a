//! From a train that is nearly the shortest to the shortest, to rounding: Newton's method on the conditions for an optimum.
//!
//! With c = f̄(ωₘ) and weights νₘ the train of places τₖ, the last of which is the length h that is sought, fulfils
//!
//! - Σₘ νₘ Re(c e(ωₘ, τₖ)) = V² for every impulse, with zero slope over τ at those inside;
//! - |f(ωₘ)|² = V² at every frequency in use, with zero slope over ω at those inside a range (the equioscillation);
//! - Σxₖ = 1.
//!
//! Those are as many equations as there are xₖ, νₘ, inner ωₘ, inner τₖ and h.

use nalgebra::{Complex, DMatrix, DVector};

use super::exchange::{Cut, Exchange, Mix};
use super::response::Derivatives;

/// An impulse at its place τ with its share x, or a frequency ω in use with its weight ν.
struct Point {
    place: f64,
    mass: f64,
    /// Whether the place is an unknown.
    free: bool,
    /// The number of the frequency's range.
    range: usize,
}

/// The optimum near a mix: places, ascending, and shares. `None` if Newton's method does not lead to one that passes the
/// check from both sides.
pub(super) fn polish(exchange: &Exchange, mix: &Mix, longest: f64, limit: f64) -> Option<Vec<(f64, f64)>> {
    let places = exchange.prices(mix, longest).into_iter().map(|(place, _)| Point::at(place, place > 0.0, 0));
    let humps = exchange.humps(mix, longest).into_iter().map(|hump| {
        let range = &exchange.ranges[hump.range];
        Point::at(hump.omega, range.low < hump.omega && hump.omega < range.high, hump.range)
    });
    let mut train = gather(places, mix.train.iter().map(|(place, share)| (0, *place, *share)));
    let mut waves = gather(humps, mix.weights.iter().map(|(cut, weight)| (cut.range, cut.omega, *weight)));
    if train.last()?.place < longest {
        return None;
    }
    newton(exchange, &mut train, &mut waves, limit)?;
    checked(exchange, &train, &waves, limit)
}

impl Point {
    fn at(place: f64, free: bool, range: usize) -> Self {
        Self { place, mass: 0.0, free, range }
    }
}

/// Gives every mass to the nearest of the points of its range; points without any are dropped.
fn gather(points: impl Iterator<Item = Point>, masses: impl Iterator<Item = (usize, f64, f64)>) -> Vec<Point> {
    let mut points: Vec<Point> = points.collect();
    for (range, at, mass) in masses {
        let candidates = points.iter_mut().filter(|point| point.range == range);
        let nearest = candidates.min_by(|a, b| (a.place - at).abs().total_cmp(&(b.place - at).abs()));
        if let Some(nearest) = nearest {
            nearest.mass += mass;
        }
    }
    points.retain(|point| point.mass > LEAST_MASS);
    points
}

fn newton(exchange: &Exchange, train: &mut [Point], waves: &mut [Point], limit: f64) -> Option<()> {
    let mut last = f64::INFINITY;
    for _ in 0..MAX_ITERATIONS {
        let (residual, jacobian) = system(exchange, train, waves, limit);
        let size = residual.amax();
        if size <= TOLERANCE * limit * limit && size >= 0.5 * last {
            return Some(()); // rounding is all that is left
        }
        last = size;
        let step = jacobian.lu().solve(&residual)?;
        if !step.iter().all(|entry| entry.abs() < 1.0) {
            return None;
        }
        let mut steps = step.iter();
        for points in [&mut *train, &mut *waves] {
            for point in points.iter_mut() {
                point.mass -= steps.next()?;
            }
            for point in points.iter_mut().filter(|point| point.free) {
                point.place -= steps.next()?;
            }
        }
    }
    None
}

/// Residuals, and their derivatives with respect to x, free τ, ν and free ω in that order.
fn system(exchange: &Exchange, train: &[Point], waves: &[Point], limit: f64) -> (DVector<f64>, DMatrix<f64>) {
    let (impulses, frequencies) = (train.len(), waves.len());
    let numbered = |points: &[Point], mut next: usize| -> Vec<Option<usize>> {
        let mut number = |free: bool| {
            next += usize::from(free);
            free.then(|| next - 1)
        };
        points.iter().map(|point| number(point.free)).collect()
    };
    let tau = numbered(train, impulses);
    let nu = impulses + tau.iter().flatten().count();
    let omega = numbered(waves, nu + frequencies);
    let size = nu + frequencies + omega.iter().flatten().count();

    let mut residual = DVector::zeros(size);
    let mut jacobian = DMatrix::zeros(size, size);
    // The row of an impulse's or frequency's condition is that of its unknown; h has none of its own, so Σx = 1 stands there.
    let sum_row = tau[impulses - 1].unwrap_or(0);
    residual[sum_row] = train.iter().map(|point| point.mass).sum::<f64>() - 1.0;
    for k in 0..impulses {
        jacobian[(sum_row, k)] = 1.0;
        residual[k] = -limit * limit;
    }
    let slope_row = |k: usize| tau[k].filter(|row| *row != sum_row);

    for (m, wave) in waves.iter().enumerate() {
        let response = exchange.ranges[wave.range].response;
        let e: Vec<Derivatives> = train.iter().map(|point| response.derivatives(wave.place, point.place)).collect();
        let total = |part: fn(&Derivatives) -> Complex<f64>| -> Complex<f64> {
            e.iter().zip(train).map(|(e, point)| part(e) * point.mass).sum()
        };
        let (f, by_omega, by_omega_omega) = (total(|e| e.value), total(|e| e.by_omega), total(|e| e.by_omega_omega));
        let (c, c_by_omega) = (f.conj(), by_omega.conj());
        let weight = wave.mass;

        for k in 0..impulses {
            let rows = [(Some(k), e[k].value, e[k].by_tau, e[k].by_omega)];
            let slope = (slope_row(k), e[k].by_tau, e[k].by_tau_tau, e[k].by_omega_tau);
            for (row, own, own_by_tau, own_by_omega) in rows.into_iter().chain([slope]) {
                let Some(row) = row else { continue };
                residual[row] += weight * (c * own).re;
                for j in 0..impulses {
                    jacobian[(row, j)] += weight * (e[j].value.conj() * own).re;
                    if let Some(column) = tau[j] {
                        jacobian[(row, column)] += weight * train[j].mass * (e[j].by_tau.conj() * own).re;
                    }
                }
                if let Some(column) = tau[k] {
                    jacobian[(row, column)] += weight * (c * own_by_tau).re;
                }
                jacobian[(row, nu + m)] += (c * own).re;
                if let Some(column) = omega[m] {
                    jacobian[(row, column)] += weight * (c_by_omega * own + c * own_by_omega).re;
                }
            }
        }

        let row = nu + m;
        residual[row] = 0.5 * (f.norm_sqr() - limit * limit);
        for j in 0..impulses {
            jacobian[(row, j)] = (c * e[j].value).re;
            if let Some(column) = tau[j] {
                jacobian[(row, column)] = train[j].mass * (c * e[j].by_tau).re;
            }
        }
        if let Some(row) = omega[m] {
            jacobian[(nu + m, row)] = (c * by_omega).re;
            residual[row] = (c * by_omega).re;
            for j in 0..impulses {
                jacobian[(row, j)] = (e[j].value.conj() * by_omega + c * e[j].by_omega).re;
                if let Some(column) = tau[j] {
                    let rise = e[j].by_tau.conj() * by_omega + c * e[j].by_omega_tau;
                    jacobian[(row, column)] = train[j].mass * rise.re;
                }
            }
            jacobian[(row, row)] = by_omega.norm_sqr() + (c * by_omega_omega).re;
        }
    }
    (residual, jacobian)
}

/// The proof, whatever way the train was found: it keeps the limit everywhere in the ranges, and the weights' price is nowhere
/// below the limit, up to its length, so that no train of that length or shorter keeps less. The price falls at the end, so
/// shorter ones cannot keep as much either.
fn checked(exchange: &Exchange, train: &[Point], waves: &[Point], limit: f64) -> Option<Vec<(f64, f64)>> {
    let longest = train.last()?.place;
    let ordered = train.is_sorted_by(|a, b| a.place < b.place) && train[0].place >= 0.0;
    let positive = train.iter().chain(waves).all(|point| point.mass > 0.0);
    let inside = waves.iter().all(|wave| {
        let range = &exchange.ranges[wave.range];
        range.low <= wave.place && wave.place <= range.high
    });
    if !(ordered && positive && inside) {
        return None;
    }
    let mut mix = Mix { train: train.iter().map(|point| (point.place, point.mass)).collect(), weights: Vec::new() };
    for wave in waves {
        let response = exchange.ranges[wave.range].response;
        let [f, ..] = mix.answer(response, wave.place);
        let cut = Cut { range: wave.range, response, omega: wave.place, direction: f / f.norm() };
        mix.weights.push((cut, wave.mass));
    }
    let highest = exchange.humps(&mix, longest).iter().map(|hump| hump.size).fold(0.0, f64::max);
    let total: f64 = waves.iter().map(|wave| wave.mass).sum();
    let cheapest = exchange.prices(&mix, longest).iter().map(|(_, jet)| jet[0]).fold(f64::INFINITY, f64::min);
    let falls = mix.price(longest)[1] < 0.0;
    let optimal = highest <= limit * (1.0 + MARGIN) && cheapest >= limit * total * (1.0 - MARGIN) && falls;
    optimal.then_some(mix.train)
}

/// Impulses and weights below this are left-overs of the exchange.
const LEAST_MASS: f64 = 1e-9;

/// Newton converges in four or five iterations if at all.
const MAX_ITERATIONS: usize = 20;

/// Largest residual accepted, relative to V².
const TOLERANCE: f64 = 1e-9;

/// By how much, relative to the limit, rounding may keep the two sides apart.
pub(super) const MARGIN: f64 = 1e-9;
