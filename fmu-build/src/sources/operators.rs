//! The C of operators that compute a value from values.

use wasmparser::Operator;

use super::kind::Kind::{self, F32, F64, I32, I64};

/// Types of the operands, type of the result, and the expression, in which `a` and `b` in braces stand for the operands.
pub type Expression = (&'static [Kind], Kind, &'static str);

/// The expression of an operator, if it computes a value from values and does nothing else.
pub fn expression(operator: &Operator) -> Option<Expression> {
    of_i32(operator).or_else(|| of_i64(operator)).or_else(|| of_floats(operator)).or_else(|| conversion(operator))
}

fn of_i32(operator: &Operator) -> Option<Expression> {
    let two = |text| Some((&[I32, I32][..], I32, text));
    let one = |text| Some((&[I32][..], I32, text));
    match operator {
        Operator::I32Add => two("({a} + {b})"),
        Operator::I32Sub => two("({a} - {b})"),
        Operator::I32Mul => two("({a} * {b})"),
        Operator::I32And => two("({a} & {b})"),
        Operator::I32Or => two("({a} | {b})"),
        Operator::I32Xor => two("({a} ^ {b})"),
        Operator::I32Shl => two("({a} << ({b} & 31))"),
        Operator::I32ShrU => two("({a} >> ({b} & 31))"),
        Operator::I32ShrS => two("(u32)((s32){a} >> ({b} & 31))"),
        Operator::I32Rotl => two("rotate32({a}, {b})"),
        Operator::I32Rotr => two("rotate32({a}, 32 - ({b} & 31))"),
        Operator::I32Eq => two("(u32)({a} == {b})"),
        Operator::I32Ne => two("(u32)({a} != {b})"),
        Operator::I32LtU => two("(u32)({a} < {b})"),
        Operator::I32LeU => two("(u32)({a} <= {b})"),
        Operator::I32GtU => two("(u32)({a} > {b})"),
        Operator::I32GeU => two("(u32)({a} >= {b})"),
        Operator::I32LtS => two("(u32)((s32){a} < (s32){b})"),
        Operator::I32LeS => two("(u32)((s32){a} <= (s32){b})"),
        Operator::I32GtS => two("(u32)((s32){a} > (s32){b})"),
        Operator::I32GeS => two("(u32)((s32){a} >= (s32){b})"),
        Operator::I32Eqz => one("(u32)({a} == 0)"),
        Operator::I32Clz => one("leading32({a})"),
        Operator::I32Ctz => one("trailing32({a})"),
        Operator::I32Popcnt => one("ones32({a})"),
        Operator::I32Extend8S => one("(u32)(s32)(s8){a}"),
        Operator::I32Extend16S => one("(u32)(s32)(s16){a}"),
        _ => None,
    }
}

fn of_i64(operator: &Operator) -> Option<Expression> {
    let two = |text| Some((&[I64, I64][..], I64, text));
    let test = |text| Some((&[I64, I64][..], I32, text));
    let one = |text| Some((&[I64][..], I64, text));
    match operator {
        Operator::I64Add => two("({a} + {b})"),
        Operator::I64Sub => two("({a} - {b})"),
        Operator::I64Mul => two("({a} * {b})"),
        Operator::I64And => two("({a} & {b})"),
        Operator::I64Or => two("({a} | {b})"),
        Operator::I64Xor => two("({a} ^ {b})"),
        Operator::I64Shl => two("({a} << ({b} & 63))"),
        Operator::I64ShrU => two("({a} >> ({b} & 63))"),
        Operator::I64ShrS => two("(u64)((s64){a} >> ({b} & 63))"),
        Operator::I64Rotl => two("rotate64({a}, {b})"),
        Operator::I64Rotr => two("rotate64({a}, 64 - ({b} & 63))"),
        Operator::I64Eq => test("(u32)({a} == {b})"),
        Operator::I64Ne => test("(u32)({a} != {b})"),
        Operator::I64LtU => test("(u32)({a} < {b})"),
        Operator::I64LeU => test("(u32)({a} <= {b})"),
        Operator::I64GtU => test("(u32)({a} > {b})"),
        Operator::I64GeU => test("(u32)({a} >= {b})"),
        Operator::I64LtS => test("(u32)((s64){a} < (s64){b})"),
        Operator::I64LeS => test("(u32)((s64){a} <= (s64){b})"),
        Operator::I64GtS => test("(u32)((s64){a} > (s64){b})"),
        Operator::I64GeS => test("(u32)((s64){a} >= (s64){b})"),
        Operator::I64Eqz => Some((&[I64], I32, "(u32)({a} == 0)")),
        Operator::I64Clz => one("(u64)leading64({a})"),
        Operator::I64Ctz => one("(u64)trailing64({a})"),
        Operator::I64Popcnt => one("(u64)(ones32((u32){a}) + ones32((u32)({a} >> 32)))"),
        Operator::I64Extend8S => one("(u64)(s64)(s8){a}"),
        Operator::I64Extend16S => one("(u64)(s64)(s16){a}"),
        Operator::I64Extend32S => one("(u64)(s64)(s32){a}"),
        _ => None,
    }
}

fn of_floats(operator: &Operator) -> Option<Expression> {
    let two = |text| Some((&[F64, F64][..], F64, text));
    let test = |text| Some((&[F64, F64][..], I32, text));
    let one = |text| Some((&[F64][..], F64, text));
    match operator {
        Operator::F64Add => two("sum({a}, {b})"),
        Operator::F64Sub => two("difference({a}, {b})"),
        Operator::F64Mul => two("({a} * {b})"),
        Operator::F64Div => two("({a} / {b})"),
        Operator::F64Min => two("least({a}, {b})"),
        Operator::F64Max => two("most({a}, {b})"),
        Operator::F64Copysign => two("copysign({a}, {b})"),
        Operator::F64Eq => test("(u32)({a} == {b})"),
        Operator::F64Ne => test("(u32)({a} != {b})"),
        Operator::F64Lt => test("(u32)({a} < {b})"),
        Operator::F64Le => test("(u32)({a} <= {b})"),
        Operator::F64Gt => test("(u32)({a} > {b})"),
        Operator::F64Ge => test("(u32)({a} >= {b})"),
        Operator::F64Abs => one("fabs({a})"),
        Operator::F64Neg => one("(-{a})"),
        Operator::F64Ceil => one("ceil({a})"),
        Operator::F64Floor => one("floor({a})"),
        Operator::F64Trunc => one("trunc({a})"),
        Operator::F64Nearest => one("nearbyint({a})"),
        Operator::F64Sqrt => one("sqrt({a})"),
        _ => None,
    }
}

fn conversion(operator: &Operator) -> Option<Expression> {
    Some(match operator {
        Operator::I32WrapI64 => (&[I64], I32, "(u32){a}"),
        Operator::I64ExtendI32S => (&[I32], I64, "(u64)(s64)(s32){a}"),
        Operator::I64ExtendI32U => (&[I32], I64, "(u64){a}"),
        Operator::I32TruncSatF64S => (&[F64], I32, "(u32)to_s32({a})"),
        Operator::I32TruncSatF64U => (&[F64], I32, "to_u32({a})"),
        Operator::I64TruncSatF64S => (&[F64], I64, "(u64)to_s64({a})"),
        Operator::I64TruncSatF64U => (&[F64], I64, "to_u64({a})"),
        Operator::F64ConvertI32S => (&[I32], F64, "(double)(s32){a}"),
        Operator::F64ConvertI32U => (&[I32], F64, "(double){a}"),
        Operator::F64ConvertI64S => (&[I64], F64, "(double)(s64){a}"),
        Operator::F64ConvertI64U => (&[I64], F64, "(double){a}"),
        Operator::F64ReinterpretI64 => (&[I64], F64, "from_bits({a})"),
        Operator::I64ReinterpretF64 => (&[F64], I64, "to_bits({a})"),
        Operator::F32ReinterpretI32 => (&[I32], F32, "float_from_bits({a})"),
        Operator::I32ReinterpretF32 => (&[F32], I32, "float_to_bits({a})"),
        Operator::F64PromoteF32 => (&[F32], F64, "(double){a}"),
        Operator::F32DemoteF64 => (&[F64], F32, "(float){a}"),
        _ => return None,
    })
}

/// Type of what is read, and the function of the runtime that reads it.
pub fn load(operator: &Operator) -> Option<(Kind, &'static str, u64)> {
    Some(match operator {
        Operator::I32Load { memarg } => (I32, "load32", memarg.offset),
        Operator::I32Load8U { memarg } => (I32, "load8", memarg.offset),
        Operator::I32Load8S { memarg } => (I32, "(u32)(s32)(s8)load8", memarg.offset),
        Operator::I32Load16U { memarg } => (I32, "load16", memarg.offset),
        Operator::I32Load16S { memarg } => (I32, "(u32)(s32)(s16)load16", memarg.offset),
        Operator::I64Load { memarg } => (I64, "load64", memarg.offset),
        Operator::I64Load8U { memarg } => (I64, "(u64)load8", memarg.offset),
        Operator::I64Load8S { memarg } => (I64, "(u64)(s64)(s8)load8", memarg.offset),
        Operator::I64Load16U { memarg } => (I64, "(u64)load16", memarg.offset),
        Operator::I64Load16S { memarg } => (I64, "(u64)(s64)(s16)load16", memarg.offset),
        Operator::I64Load32U { memarg } => (I64, "(u64)load32", memarg.offset),
        Operator::I64Load32S { memarg } => (I64, "(u64)(s64)(s32)load32", memarg.offset),
        Operator::F32Load { memarg } => (F32, "load_float", memarg.offset),
        Operator::F64Load { memarg } => (F64, "load_double", memarg.offset),
        _ => return None,
    })
}

/// Type of what is written, and the function of the runtime that writes it.
pub fn store(operator: &Operator) -> Option<(Kind, &'static str, u64)> {
    Some(match operator {
        Operator::I32Store { memarg } => (I32, "store32", memarg.offset),
        Operator::I32Store8 { memarg } => (I32, "store8", memarg.offset),
        Operator::I32Store16 { memarg } => (I32, "store16", memarg.offset),
        Operator::I64Store { memarg } => (I64, "store64", memarg.offset),
        Operator::I64Store8 { memarg } => (I64, "store8", memarg.offset),
        Operator::I64Store16 { memarg } => (I64, "store16", memarg.offset),
        Operator::I64Store32 { memarg } => (I64, "store32", memarg.offset),
        Operator::F32Store { memarg } => (F32, "store_float", memarg.offset),
        Operator::F64Store { memarg } => (F64, "store_double", memarg.offset),
        _ => return None,
    })
}

/// Divisions, which trap: as the others, with the instance as the first argument.
pub fn division(operator: &Operator) -> Option<Expression> {
    Some(match operator {
        Operator::I32DivU => (&[I32, I32], I32, "({a} / divisor32(m, {b}))"),
        Operator::I32RemU => (&[I32, I32], I32, "({a} % divisor32(m, {b}))"),
        Operator::I32DivS => (&[I32, I32], I32, "divide32(m, {a}, {b})"),
        Operator::I32RemS => (&[I32, I32], I32, "remain32(m, {a}, {b})"),
        Operator::I64DivU => (&[I64, I64], I64, "({a} / divisor64(m, {b}))"),
        Operator::I64RemU => (&[I64, I64], I64, "({a} % divisor64(m, {b}))"),
        Operator::I64DivS => (&[I64, I64], I64, "divide64(m, {a}, {b})"),
        Operator::I64RemS => (&[I64, I64], I64, "remain64(m, {a}, {b})"),
        _ => return None,
    })
}
