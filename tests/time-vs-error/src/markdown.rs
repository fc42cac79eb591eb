//! Tables and numbers, as Markdown to be included into a page.

use crate::curve::Mean;

/// A table whose first column names things and whose others hold numbers.
#[must_use]
pub fn table(header: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let header: Vec<String> = header.iter().map(|&cell| cell.to_owned()).collect();
    let border = format!("|---|{}\n", "---:|".repeat(header.len() - 1));
    format!("{}{border}{}", line(&header), rows.iter().map(|row| line(row)).collect::<String>())
}

/// A ratio with as many digits as it is worth: 1.04, 3.2, 25, 1300.
#[must_use]
pub fn factor(value: f64) -> String {
    match value {
        v if !v.is_finite() => "–".to_owned(),
        v if v < 0.01 => scientific(v),
        v if v < 2.0 => format!("{v:.2}"),
        v if v < 10.0 => format!("{v:.1}"),
        v if v < 100.0 => format!("{v:.0}"),
        v => {
            let step = libm::pow(10.0, libm::floor(libm::log10(v)) - 1.0);
            format!("{:.0}", (v / step).round() * step)
        }
    }
}

/// Two digits and a power of ten: 3.1 · 10⁻⁵.
#[must_use]
pub fn scientific(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let text = format!("{value:.1e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = digits.replace('-', "−");
    match power {
        "0" => digits,
        power => format!("{digits}·10<sup>{}</sup>", power.replace('-', "−")),
    }
}

/// A value with half the width of its interval, in percent: −1.20 ± 0.31 %.
#[must_use]
pub fn percent(mean: Mean) -> String {
    if !mean.value.is_finite() {
        return "–".to_owned();
    }
    let width = 100.0 * mean.interval;
    let digits = if width < 0.1 {
        3
    } else if width < 1.0 {
        2
    } else {
        1
    };
    let value = format!("{:.digits$}", 100.0 * mean.value).replace('-', "−");
    format!("{value} ± {width:.digits$} %")
}

#[cfg(test)]
mod tests {
    use super::{factor, percent, scientific, table};
    use crate::curve::Mean;

    #[test]
    fn numbers_are_as_long_as_they_are_worth() {
        let factors = [1.0, 1.043, 3.24, 25.4, 1312.0, f64::NAN].map(factor);
        assert_eq!(factors, ["1.00", "1.04", "3.2", "25", "1300", "–"], "ratios");
        let numbers = [3.14e-5, -2.0, f64::INFINITY].map(scientific);
        assert_eq!(numbers, ["3.1·10<sup>−5</sup>", "−2.0", "–"], "powers");
        let mean = Mean { value: -0.012, error: 0.001, interval: 0.0031 };
        assert_eq!(percent(mean), "−1.20 ± 0.31 %", "percent");
    }

    #[test]
    fn a_table_is_markdown() {
        let text = table(&["a", "b"], &[vec!["x".into(), "1".into()]]);
        assert_eq!(text, "| a | b |\n|---|---:|\n| x | 1 |\n", "the table");
    }
}
