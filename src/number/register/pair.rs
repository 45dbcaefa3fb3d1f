//! Two registers that are worked on in turn.

use super::Register;

/// Two registers side by side. Most steps of a law wait for the one before; meanwhile the processor works on the other
/// register.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub(crate) struct Pair<R>([R; 2]);

/// Operations on each of the registers.
macro_rules! on_each {
    ({ $($one:ident)+ } { $($two:ident)+ } { $($compare:ident)+ } { $($on_answers:ident)+ }) => {
        $(
            #[inline(always)]
            fn $one(self) -> Self {
                let [a, b] = self.0;
                Pair([a.$one(), b.$one()])
            }
        )+
        $(
            #[inline(always)]
            fn $two(self, other: Self) -> Self {
                let ([a, b], [c, d]) = (self.0, other.0);
                Pair([a.$two(c), b.$two(d)])
            }
        )+
        $(
            #[inline(always)]
            fn $compare(self, other: Self) -> [R::Mask; 2] {
                let ([a, b], [c, d]) = (self.0, other.0);
                [a.$compare(c), b.$compare(d)]
            }
        )+
        $(
            #[inline(always)]
            fn $on_answers([a, b]: [R::Mask; 2], [c, d]: [R::Mask; 2]) -> [R::Mask; 2] {
                [R::$on_answers(a, c), R::$on_answers(b, d)]
            }
        )+
    };
}

// SAFETY: an array of two registers.
unsafe impl<R: Register> Register for Pair<R> {
    type Mask = [R::Mask; 2];
    const LANES: usize = 2 * R::LANES;
    const SEARCHES: bool = R::SEARCHES;

    on_each! {
        { negated magnitude root }
        { plus minus times over with_sign }
        { above at_least equals }
        { both one_of }
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Pair([R::splat(value); 2])
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0[lane / R::LANES].lane(lane % R::LANES)
    }
    #[inline(always)]
    fn each(mut value: impl FnMut(usize) -> f64) -> Self {
        let first = R::each(&mut value);
        Pair([first, R::each(|lane| value(R::LANES + lane))])
    }
    #[inline(always)]
    fn within(self, least: f64, most: f64) -> Self {
        let [a, b] = self.0;
        Pair([a.within(least, most), b.within(least, most)])
    }
    #[inline(always)]
    fn power(self, offset: u64) -> Self {
        let [a, b] = self.0;
        Pair([a.power(offset), b.power(offset)])
    }
    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        let [[a, b], [c, d]] = [self.0[0].halves(), self.0[1].halves()];
        [Pair([a, c]), Pair([b, d])]
    }
    #[inline(always)]
    fn select([a, b]: [R::Mask; 2], yes: Self, no: Self) -> Self {
        Pair([R::select(a, yes.0[0], no.0[0]), R::select(b, yes.0[1], no.0[1])])
    }
    #[inline(always)]
    fn answer(answer: bool) -> [R::Mask; 2] {
        [R::answer(answer); 2]
    }
    #[inline(always)]
    fn inverse([a, b]: [R::Mask; 2]) -> [R::Mask; 2] {
        [R::inverse(a), R::inverse(b)]
    }
    #[inline(always)]
    fn all([a, b]: [R::Mask; 2]) -> bool {
        R::all(R::both(a, b))
    }
    #[inline(always)]
    fn any([a, b]: [R::Mask; 2]) -> bool {
        R::any(R::one_of(a, b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Two = Pair<[f64; 2]>;

    /// Numbers in the order of their lanes.
    fn of(numbers: [f64; 4]) -> Two {
        Two::each(|lane| numbers[lane])
    }

    #[test]
    fn lanes_keep_their_order() {
        let numbers = of([1.0, 2.0, 3.0, 4.0]);
        assert_eq!([0, 1, 2, 3].map(|lane| numbers.lane(lane)), [1.0, 2.0, 3.0, 4.0]);
        let chosen = Two::select(numbers.above(of([0.0, 5.0, 0.0, 5.0])), numbers, numbers.negated());
        assert_eq!(chosen, of([1.0, -2.0, 3.0, -4.0]));
    }

    #[test]
    fn one_lane_decides_whether_any_or_all_agree() {
        for lane in 0..Two::LANES {
            let one = Two::each(|other| f64::from(u8::from(other == lane))).above(Two::splat(0.5));
            assert!(Two::any(one) && !Two::all(one) && !Two::all(Two::inverse(one)) && Two::any(Two::inverse(one)));
        }
        assert!(Two::all(Two::answer(true)) && !Two::any(Two::answer(false)));
    }
}
