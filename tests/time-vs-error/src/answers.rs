//! One sentence for each question, said by the data.

use std::fmt::Write;

use statistics::grouped;

use crate::comparison::{Ratio, best};
use crate::curve::{Curve, Point};
use crate::markdown::{factor, percent, scientific};
use crate::report::Outcome;
use crate::tables::Gain;

/// Sentences with names, each of which a page can include: `answers.md:NAME`.
#[derive(Clone, Debug, Default)]
pub struct Answers(String);

impl Answers {
    /// Adds a sentence, if there is one.
    pub fn add(&mut self, name: &str, sentence: Option<String>) {
        if let Some(sentence) = sentence {
            // Writing to a String cannot fail.
            let _ = writeln!(self.0, "ANCHOR: {name}\n{sentence}\nANCHOR_END: {name}");
        }
    }

    /// The file.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0
    }
}

/// Which setting needs least time for an error, and how much longer the others take.
#[must_use]
pub fn efficiency(outcome: &Outcome<'_>) -> Option<String> {
    let fastest = best(&outcome.curves)?;
    let fast = fastest.last()?;
    let other = |curve: &Curve| {
        let ratio = Ratio::of_times(curve.last()?, fast);
        let interval = format!("{} to {}", factor(ratio.low), factor(ratio.high));
        let name = &curve.setting.name;
        let verdict = if ratio.is_open() { ", which is no clear difference" } else { "" };
        Some(format!("`{name}` takes {} times as long ({interval}{verdict})", factor(ratio.value)))
    };
    let others = outcome.curves.iter().filter(|curve| curve.setting != fastest.setting);
    let others: Vec<String> = others.filter_map(other).collect();
    let name = &fastest.setting.name;
    (!others.is_empty())
        .then(|| format!("`{name}` needs least time for the same error; {}.", enumerated(&others)))
}

/// Which settings have a mean that is certainly wrong.
#[must_use]
pub fn bias(outcome: &Outcome<'_>) -> Option<String> {
    let points = || outcome.curves.iter().filter_map(|c| Some((&c.setting.name, c.last()?)));
    let is_biased = |point: &Point| point.bias.value.abs() > point.bias.interval;
    let listed = |biased: bool| -> Vec<String> {
        let chosen = points().filter(|(_, point)| is_biased(point) == biased);
        chosen.map(|(name, point)| format!("`{name}` {}", percent(point.bias))).collect()
    };
    let (biased, fine) = (listed(true), listed(false));
    let certain = match biased.len() {
        0 => "No mean is certainly off".to_owned(),
        _ => format!("The mean is certainly off with {}", enumerated(&biased)),
    };
    let open = match fine.len() {
        0 => String::new(),
        _ => format!("; it may be right with {}", enumerated(&fine)),
    };
    points().next().map(|_| format!("{certain}{open}."))
}

/// How the error falls with the samples.
#[must_use]
pub fn slopes(outcome: &Outcome<'_>) -> Option<String> {
    let slope = |curve: &Curve| {
        let law = curve.law().ok()?;
        let value = format!("{:.3} ± {:.3}", law.exponent, law.standard_error).replace('-', "−");
        Some(format!("`{}` {value}", curve.setting.name))
    };
    let slopes: Vec<String> = outcome.curves.iter().filter_map(slope).collect();
    (!slopes.is_empty()).then(|| enumerated(&slopes))
}

/// A ratio of times that no noise explains: a twentieth more.
const CLEARLY: f64 = 1.05;

/// From which triangle on the tree pays, by more than the clock's noise.
#[must_use]
pub fn trees(gains: &[Gain]) -> Option<String> {
    let largest = gains.last()?;
    let from = |value: fn(&Gain) -> f64| {
        let losing = gains.iter().rposition(|gain| value(gain) <= CLEARLY);
        gains.get(losing.map_or(0, |i| i + 1)).map(|gain| grouped(u64::from(gain.triangles)))
    };
    let from_render = from(|gain| gain.render)?;
    let from_building = from(|gain| gain.with_building)?;
    Some(format!(
        "From {from_render} triangles on, a render with the tree is clearly faster; with the time \
         of building it, for one sample a pixel, from {from_building} on. At {} triangles the \
         render without tree takes {} times as long.",
        grouped(u64::from(largest.triangles)),
        factor(largest.render)
    ))
}

/// What shading ignores and what sampling adds, with the fewest and with the most samples.
#[must_use]
pub fn whitted(outcome: &Outcome<'_>) -> Option<String> {
    let curve = outcome.curves.first()?;
    let (first, last) = (curve.points.first()?, curve.last()?);
    let [a, b] = [first, last].map(|point| scientific(point.sampling.value));
    Some(format!(
        "What shading ignores is a relMSE of {}, however many samples; what sampling adds falls \
         from {a} with {} to {b} with {}.",
        scientific(last.shading.value),
        samples(first.samples),
        samples(last.samples)
    ))
}

fn samples(n: u32) -> String {
    if n == 1 { "one sample".to_owned() } else { format!("{n} samples") }
}

/// The items in a row, with "and" before the last.
pub(crate) fn enumerated(items: &[String]) -> String {
    match items.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::{Answers, enumerated, trees};
    use crate::tables::Gain;

    fn gain(triangles: u32, render: f64, with_building: f64) -> Gain {
        Gain { triangles, render, with_building, same_picture: true }
    }

    #[test]
    fn the_tree_pays_from_where_it_never_loses_again() {
        let gains =
            [gain(2, 1.1, 1.0), gain(8, 1.04, 0.5), gain(32, 1.5, 0.9), gain(128, 5.0, 3.0)];
        let sentence = trees(&gains).expect("it pays");
        assert!(sentence.starts_with("From 32 triangles on"), "{sentence}");
        assert!(sentence.contains("from 128 on"), "{sentence}");
        assert!(sentence.contains("5.0 times"), "{sentence}");
        assert_eq!(trees(&[gain(2, 0.9, 0.9)]), None, "it never pays");
    }

    #[test]
    fn a_sentence_has_an_anchor() {
        let mut answers = Answers::default();
        answers.add("a-b", Some("Yes.".into()));
        answers.add("c", None);
        assert_eq!(answers.text(), "ANCHOR: a-b\nYes.\nANCHOR_END: a-b\n", "the file");
        let list = ["a", "b", "c"].map(str::to_owned);
        let texts = [0, 1, 2, 3].map(|n| enumerated(&list[..n]));
        assert_eq!(texts, ["", "a", "a and b", "a, b and c"], "enumerations");
    }
}
