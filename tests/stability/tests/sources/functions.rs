//! No function whose last digits depend on the platform: sines, powers and logarithms come from one
//! pinned library, through `ray_casting::math`.

use crate::code::is_name;
use crate::{Exception, check};

/// Functions of the standard library on floats whose precision it does not promise, and `mul_add`, which
/// is slow where the processor has no instruction for it.
const FLOAT: [&str; 28] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh",
    "asinh", "acosh", "atanh", "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10",
    "powf", "powi", "hypot", "cbrt", "gamma", "mul_add",
];

/// What glam makes of them.
const GLAM: [&str; 12] = [
    "from_axis_angle",
    "from_scaled_axis",
    "from_euler",
    "to_euler",
    "to_axis_angle",
    "from_angle",
    "to_angle",
    "angle_between",
    "angle_to",
    "rotate_towards",
    "slerp",
    "from_rotation_",
];

/// The calls in a line of code that are not the same everywhere.
fn unportable(line: &str) -> Vec<String> {
    let float = FLOAT
        .iter()
        .flat_map(|name| [format!(".{name}("), format!("f32::{name}"), format!("f64::{name}")]);
    let glam = GLAM.iter().map(|name| (*name).to_owned());
    let library = ["libm::", "core::intrinsics"].map(str::to_owned);
    float.chain(glam).chain(library).filter(|call| calls(line, call)).collect()
}

/// Whether `call` stands in the line, not as the beginning or the end of a longer name.
fn calls(line: &str, call: &str) -> bool {
    let ends_whole = call.ends_with(|c: char| !is_name(c) || c == '_');
    line.match_indices(call).any(|(i, _)| {
        let before = line[..i].chars().next_back();
        let after = line[i + call.len()..].chars().next();
        let begins = call.starts_with('.') || !before.is_some_and(is_name);
        begins && (ends_whole || !after.is_some_and(is_name))
    })
}

#[test]
fn every_function_gives_the_same_digits_everywhere() {
    check(
        |file| file != "01-ray-casting/src/math.rs",
        |_, line| unportable(line),
        &[Exception {
            file: "00-workbench/src/srgb.rs",
            line: "libm::pow(",
            reason: "the workbench depends on no chapter, so it cannot use `math`",
        }],
    );
}

#[test]
fn a_planted_function_is_found() {
    for line in [
        "let y = x.sin();",
        "let (s, c) = angle.sin_cos();",
        "x.powf(2.2)",
        "x.powi(2)",
        "xs.iter().map(|x| x.ln())",
        "y.atan2(x)",
        "a.mul_add(b, c)",
        "xs.map(f32::sin)",
        "f64::powi(x, 3)",
        "let q = Quat::from_rotation_y(0.3);",
        "Mat3::from_axis_angle(axis, angle)",
        "a.angle_between(b)",
        "libm::sinf(x)",
        "color.powf(1.0 / 2.2)",
    ] {
        assert_eq!(unportable(line).len(), 1, "{:?} in `{line}`", unportable(line));
    }
}

#[test]
fn what_is_the_same_everywhere_is_not_found() {
    for line in [
        "math::sin_cos(x)",
        "x.sqrt() + x.abs()",
        "surface.cos_theta(wi)",
        "let sin = 0.5;",
        "gamma(4) * reach",
        "u32::pow(2, 5) + 2_u32.pow(3)",
        "expect(x).exposure()",
        "angle.to_radians()",
        "f64::consts::PI",
        "record.log_line()",
    ] {
        assert!(unportable(line).is_empty(), "{:?} in `{line}`", unportable(line));
    }
}
