//! Axes: from values to places, and from places to readable ticks.

/// An axis of a plot.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Quantity and unit, for example `triangles` or `time / s`.
    pub label: String,
    /// Equal steps or equal factors.
    pub scale: Scale,
    /// The smallest and the largest value shown; what the points need if left out.
    pub range: Option<[f64; 2]>,
}

/// How values are spread over an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Equal lengths are equal differences.
    Linear,
    /// Equal lengths are equal factors; all values must be positive.
    Log,
}

impl Axis {
    /// An axis with equal steps that shows all points.
    #[must_use]
    pub fn linear(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Linear, range: None }
    }

    /// An axis with equal factors that shows all points.
    #[must_use]
    pub fn log(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Log, range: None }
    }

    /// The same axis from `min` to `max`.
    #[must_use]
    pub fn within(mut self, min: f64, max: f64) -> Self {
        self.range = Some([min, max]);
        self
    }

    /// The range with limits that make good ticks, unless it was given.
    pub(crate) fn fit(&self, values: impl Iterator<Item = f64>) -> Span {
        let [min, max] = self.range.unwrap_or_else(|| {
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)])
        });
        let finite = min.is_finite() && max.is_finite() && min <= max;
        assert!(finite, "axis `{}` from {min} to {max}", self.label);
        match self.scale {
            Scale::Log => {
                assert!(min > 0.0, "logarithmic axis `{}` from {min}", self.label);
                let [low, high] = [libm::log10(min), libm::log10(max)];
                // A decade at least, so that a constant can be shown.
                let fitted = [libm::floor(low), libm::ceil(high).max(libm::floor(low) + 1.0)];
                let [low, high] = if self.range.is_some() { [low, high] } else { fitted };
                Span { scale: Scale::Log, low, high, step: 1.0 }
            }
            Scale::Linear => {
                let max = if max > min { max } else { min + 1.0 };
                let step = good_step((max - min) / 5.0);
                let fitted = [libm::floor(min / step) * step, libm::ceil(max / step) * step];
                let [low, high] = if self.range.is_some() { [min, max] } else { fitted };
                Span { scale: Scale::Linear, low, high, step }
            }
        }
    }
}

/// The smallest of 1, 2, 5, 10, 20, … (and 0.5, 0.2, …) that is at least `step`.
fn good_step(step: f64) -> f64 {
    let decade = power_of_ten(libm::floor(libm::log10(step)));
    // The factor tolerates rounding: a step of 0.2000…01 is 0.2.
    let fits = |m: &f64| m * decade * (1.0 + 1e-9) >= step;
    [1.0, 2.0, 5.0].into_iter().find(fits).unwrap_or(10.0) * decade
}

fn power_of_ten(exponent: f64) -> f64 {
    libm::pow(10.0, exponent)
}

/// What an axis shows; in powers of ten if it is logarithmic.
pub(crate) struct Span {
    scale: Scale,
    low: f64,
    high: f64,
    step: f64,
}

impl Span {
    /// The place of a value: 0 at the low end, 1 at the high end.
    pub(crate) fn place(&self, value: f64) -> f64 {
        let value = if self.scale == Scale::Log { libm::log10(value) } else { value };
        (value - self.low) / (self.high - self.low)
    }

    /// Places and texts of the ticks.
    pub(crate) fn ticks(&self) -> Vec<(f64, String)> {
        match self.scale {
            Scale::Linear => {
                let first = libm::ceil(self.low / self.step - 1e-9) as i64;
                let last = libm::floor(self.high / self.step + 1e-9) as i64;
                let tick = |i| i as f64 * self.step;
                (first..=last).map(|i| (self.place(tick(i)), decimal(tick(i), self.step))).collect()
            }
            Scale::Log => {
                let [first, last] = [libm::floor(self.low) as i32, libm::ceil(self.high) as i32];
                // Below three decades, 2 and 5 are worth a tick as well.
                let narrow: &[f64] = if last - first < 3 { &[1.0, 2.0, 5.0] } else { &[1.0] };
                let every = (last - first + 7) / 8;
                (first..=last)
                    .filter(|exponent| exponent % every == 0)
                    .flat_map(|exponent| narrow.iter().map(move |m| (*m, exponent)))
                    .map(|(m, exponent)| {
                        let value = m * power_of_ten(f64::from(exponent));
                        (self.place(value), magnitude(m, exponent))
                    })
                    .filter(|(place, _)| (-1e-9..=1.0 + 1e-9).contains(place))
                    .collect()
            }
        }
    }
}

/// A tick of a linear axis, with as many digits as its step needs.
fn decimal(value: f64, step: f64) -> String {
    let digits = (-libm::floor(libm::log10(step) + 1e-9)).clamp(0.0, 12.0) as usize;
    // Adding zero turns −0 into 0.
    format!("{:.digits$}", value + 0.0).replace('-', "−")
}

/// A tick of a logarithmic axis: plain numbers near 1, powers of ten elsewhere.
fn magnitude(m: f64, exponent: i32) -> String {
    match exponent {
        0..=3 => format!("{:.0}", m * power_of_ten(f64::from(exponent))),
        -3..0 => format!(
            "{:.*}",
            exponent.unsigned_abs() as usize,
            m * power_of_ten(f64::from(exponent))
        ),
        _ => {
            let digit = |c| match c {
                '-' => '⁻',
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                c => char::from_u32('⁰' as u32 + (c as u32 - '0' as u32)).unwrap_or(c),
            };
            let power: String = exponent.to_string().chars().map(digit).collect();
            if m == 1.0 { format!("10{power}") } else { format!("{m:.0}·10{power}") }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Scale, Span, decimal, good_step, magnitude};

    fn texts(span: &Span) -> Vec<String> {
        span.ticks().into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(good_step(0.2), 0.2, "0.2 stays");
        assert_eq!(good_step(0.21), 0.5, "above 0.2 comes 0.5");
        assert_eq!(good_step(7.0), 10.0, "above 5 comes 10");
        let linear = Axis::linear("x").fit([0.0, 1.0].into_iter());
        assert_eq!(texts(&linear), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"], "0 to 1");
        let negative = Axis::linear("x").fit([-3.0, 2.0].into_iter());
        assert_eq!(texts(&negative), ["−3", "−2", "−1", "0", "1", "2"], "−3 to 2");
        let log = Axis::log("x").fit([1e3, 1e6].into_iter());
        assert_eq!(texts(&log), ["1000", "10⁴", "10⁵", "10⁶"], "three decades");
        let narrow = Axis::log("x").fit([1.0, 8.0].into_iter());
        assert_eq!(texts(&narrow), ["1", "2", "5", "10"], "one decade");
    }

    #[test]
    fn a_tick_is_written_with_the_digits_it_needs() {
        assert_eq!(decimal(0.30000000000000004, 0.1), "0.3", "a tenth");
        assert_eq!(decimal(-0.0, 1.0), "0", "no minus zero");
        assert_eq!(magnitude(2.0, -3), "0.002", "thousandths");
        assert_eq!(magnitude(1.0, -7), "10⁻⁷", "tiny");
        assert_eq!(magnitude(5.0, 12), "5·10¹²", "huge");
    }

    #[test]
    fn equal_factors_are_equal_lengths_on_a_logarithmic_axis() {
        let span = Span { scale: Scale::Log, low: 0.0, high: 4.0, step: 1.0 };
        assert!((span.place(10.0) - 0.25).abs() < 1e-12, "10 at {}", span.place(10.0));
        assert!((span.place(1000.0) - 0.75).abs() < 1e-12, "1000 at {}", span.place(1000.0));
    }
}
