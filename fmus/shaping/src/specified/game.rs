//! A matrix game, that is a small linear program together with its dual.

use nalgebra::DMatrix;

/// The value of a game and how each side mixes its choices.
pub(crate) struct Solution {
    /// Shares x of the columns: max over rows of (Bx) is the value.
    pub columns: Vec<f64>,
    /// Shares y of the rows: min over columns of (yB) is the value.
    pub rows: Vec<f64>,
}

/// Minimises over x ≥ 0, Σx = 1 the largest entry of Bx, where all entries of B are between −1 and 1.
///
/// With B + 2, whose entries are positive, and z = x/value it is: maximise Σz subject to (B + 2)z ≤ 1, z ≥ 0. There z = 0 is
/// a feasible corner, from which the simplex method starts; the slacks' prices are y. `None` if rounding keeps it from an end.
pub(crate) fn solve(matrix: &DMatrix<f64>) -> Option<Solution> {
    let (rows, columns) = matrix.shape();
    let width = columns + rows; // the tableau's columns: z, slacks, and the right-hand side
    let mut tableau = DMatrix::from_fn(rows + 1, width + 1, |row, column| match (row < rows, column < columns) {
        (true, true) => matrix[(row, column)] + 2.0,
        (true, false) => f64::from(column == columns + row || column == width),
        (false, first) => f64::from(first),
    });
    let mut basis: Vec<usize> = (columns..width).collect();
    for _ in 0..50 * (rows + columns) {
        let entering = (0..width).max_by(|a, b| tableau[(rows, *a)].total_cmp(&tableau[(rows, *b)]))?;
        if tableau[(rows, entering)] <= TOLERANCE {
            let mut solution = Solution { columns: vec![0.0; columns], rows: vec![0.0; rows] };
            for (row, &basic) in basis.iter().enumerate().filter(|(_, basic)| **basic < columns) {
                solution.columns[basic] = tableau[(row, width)].max(0.0);
            }
            for (row, share) in solution.rows.iter_mut().enumerate() {
                *share = (-tableau[(rows, columns + row)]).max(0.0);
            }
            normalise(&mut solution.columns);
            normalise(&mut solution.rows);
            return Some(solution);
        }
        let leaving = leaving(&tableau, rows, entering)?;
        pivot(&mut tableau, leaving, entering);
        basis[leaving] = entering;
    }
    None
}

/// Prices below this are rounding.
const TOLERANCE: f64 = 1e-12;

/// Pivots below this are rounding.
const LEAST_PIVOT: f64 = 1e-9;

/// How far a constraint may be overstepped for the sake of a larger pivot.
const SLACK: f64 = 1e-12;

/// The row that limits the entering column; of rows that limit it all but equally, the one with the largest pivot, as Harris
/// has it: small pivots, which come with nearly equal columns, would let rounding grow.
fn leaving(tableau: &DMatrix<f64>, rows: usize, entering: usize) -> Option<usize> {
    let side = tableau.column(tableau.ncols() - 1);
    let pivots = tableau.column(entering);
    let candidates = || (0..rows).filter(|row| pivots[*row] > LEAST_PIVOT);
    let bound = candidates().map(|row| (side[row].max(0.0) + SLACK) / pivots[row]).fold(f64::INFINITY, f64::min);
    candidates().filter(|row| side[*row] / pivots[*row] <= bound).max_by(|a, b| pivots[*a].total_cmp(&pivots[*b]))
}

fn pivot(tableau: &mut DMatrix<f64>, pivot_row: usize, pivot_column: usize) {
    let factors = tableau.column(pivot_column).clone_owned();
    for mut column in tableau.column_iter_mut() {
        let share = column[pivot_row] / factors[pivot_row];
        if share != 0.0 {
            column.axpy(-share, &factors, 1.0);
        }
        column[pivot_row] = share;
    }
}

fn normalise(shares: &mut [f64]) {
    let sum: f64 = shares.iter().sum();
    shares.iter_mut().for_each(|share| *share /= sum);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(matrix: &DMatrix<f64>) -> (f64, f64) {
        let solution = solve(matrix).unwrap();
        let high = (0..matrix.nrows()).map(|r| (0..matrix.ncols()).map(|c| matrix[(r, c)] * solution.columns[c]).sum());
        let low = (0..matrix.ncols()).map(|c| (0..matrix.nrows()).map(|r| matrix[(r, c)] * solution.rows[r]).sum());
        (low.fold(f64::INFINITY, f64::min), high.fold(f64::NEG_INFINITY, f64::max))
    }

    #[test]
    fn both_sides_agree_on_the_value() {
        let rock_paper_scissors = DMatrix::from_row_slice(3, 3, &[0.0, 1.0, -1.0, -1.0, 0.0, 1.0, 1.0, -1.0, 0.0]);
        let saddle = DMatrix::from_row_slice(2, 3, &[0.2, 0.5, 0.9, 0.1, 0.7, -0.3]);
        let mixed = DMatrix::from_row_slice(2, 2, &[0.8, -0.4, -0.2, 0.4]);
        for (matrix, expected) in [(rock_paper_scissors, 0.0), (saddle, 0.2), (mixed, 2.0 / 15.0)] {
            let (low, high) = value(&matrix);
            assert!((low - expected).abs() < 1e-14 && (high - expected).abs() < 1e-14, "{low} {high}");
        }
    }
}
