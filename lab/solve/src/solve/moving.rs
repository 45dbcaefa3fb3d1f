//! The states that move under linear equations, apart from those that do not.

/// Row by row.
type Matrix<const N: usize> = [[f64; N]; N];

/// States with a rate, and those whose rates depend on them: the others stay where they are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<const N: usize> {
    states: [usize; N],
    count: usize,
}

impl<const N: usize> Moving<N> {
    /// Those that move from these rates on.
    pub fn of(rates: &[f64; N], jacobian: &Matrix<N>) -> Moving<N> {
        let mut moves = rates.map(|rate| rate != 0.0);
        let follows =
            |moves: &[bool; N], state: usize| (0..N).any(|other| moves[other] && jacobian[state][other] != 0.0);
        while let Some(state) = (0..N).find(|state| !moves[*state] && follows(&moves, *state)) {
            moves[state] = true;
        }
        let mut moving = Moving { states: [0; N], count: 0 };
        for state in (0..N).filter(|state| moves[*state]) {
            moving.states[moving.count] = state;
            moving.count += 1;
        }
        moving
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Their rows and columns, as the first ones of a matrix that has no others; it must be as large.
    pub fn gather<const M: usize>(&self, matrix: &Matrix<N>) -> Matrix<M> {
        let (mut found, states) = ([[0.0; M]; M], &self.states[..self.count]);
        for (row, from) in found.iter_mut().zip(states) {
            for (value, column) in row.iter_mut().zip(states) {
                *value = matrix[*from][*column];
            }
        }
        found
    }

    /// The matrix with such rows and columns; the others are 0.
    pub fn scatter<const M: usize>(&self, matrix: &Matrix<M>) -> Matrix<N> {
        let (mut found, states) = ([[0.0; N]; N], &self.states[..self.count]);
        for (row, to) in matrix.iter().zip(states) {
            for (value, column) in row.iter().zip(states) {
                found[*to][*column] = *value;
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The fourth state moves by itself, the second one follows it, the fifth one the second; the third one would move the
    /// first.
    #[test]
    fn states_that_follow_others_move_with_them() {
        let mut matrix = [[0.0; 5]; 5];
        (matrix[1][3], matrix[4][1], matrix[0][2], matrix[3][0]) = (2.0, -1e-300, 5.0, 7.0);
        let moving = Moving::of(&[0.0, 0.0, 0.0, 1e-9, 0.0], &matrix);
        assert_eq!((moving.states[..moving.count].to_vec(), moving.count()), (vec![1, 3, 4], 3));
        let gathered = moving.gather::<3>(&matrix);
        assert_eq!(gathered, [[0.0, 2.0, 0.0], [0.0; 3], [-1e-300, 0.0, 0.0]]);
        let mut expected = [[0.0; 5]; 5];
        (expected[1][3], expected[4][1]) = (2.0, -1e-300);
        assert_eq!(moving.scatter(&gathered), expected);
        let all = Moving::of(&[0.0, 0.0, -1.0, 0.0, 0.0], &matrix);
        assert_eq!((all.count(), all.gather::<5>(&matrix)), (5, matrix));
        assert_eq!(Moving::of(&[0.0; 5], &matrix).count(), 0);
    }
}
