//! `--no-skip`: what is done although the picture does not need it.

use std::str::FromStr;

use crate::Counter;

/// Kinds of work that are done although they could be skipped; read from keys of the statistics
/// file, with commas between, or from `all`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSkip(pub Vec<Counter>);

impl FromStr for NoSkip {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let counters = text.split(',').map(counters).collect::<Result<Vec<_>, _>>()?;
        Ok(Self(counters.concat()))
    }
}

/// What one word names; else why it names nothing.
fn counters(word: &str) -> Result<Vec<Counter>, String> {
    let skipped = Counter::ALL.into_iter().filter(|counter| counter.name().0 == "skipped");
    if let Some(option) = skipped.clone().find(|c| c.name().1 == word).and_then(option) {
        return Err(format!("`{word}` has an option of its own: `{option}`"));
    }
    let known = skipped.filter(|&counter| option(counter).is_none());
    let counters: Vec<_> = known.clone().filter(|c| word == "all" || word == c.name().1).collect();
    if counters.is_empty() {
        let keys: Vec<_> = known.map(|counter| format!("`{}`", counter.name().1)).collect();
        return Err(format!("there is no `{word}`; known: `all`, {}", keys.join(", ")));
    }
    Ok(counters)
}

/// The option that switches this skip off, if it is not `--no-skip`: these skips do change the
/// picture, if only below what can be seen, or on the average.
const fn option(counter: Counter) -> Option<&'static str> {
    match counter {
        Counter::BranchesBelowThreshold => Some("--cutoff 0"),
        Counter::PathsEndedByRoulette => Some("--roulette off"),
        Counter::PathsEndedByDepth => Some("--depth"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::NoSkip;
    use crate::Counter;

    #[test]
    fn all_is_every_skip_without_an_option_of_its_own() {
        let NoSkip(all) = "all".parse().expect("`all` is known");
        let skipped = Counter::ALL.into_iter().filter(|counter| counter.name().0 == "skipped");
        assert_eq!(all.len() + 3, skipped.count(), "{all:?}");
        for counter in all {
            assert_eq!(counter.name().1.parse(), Ok(NoSkip(vec![counter])), "{counter:?}");
        }
    }

    #[test]
    fn an_unknown_key_is_answered_with_the_known_ones() {
        for wrong in ["", "trees", "any_hit_exits,", "camera"] {
            let complaint = wrong.parse::<NoSkip>().expect_err(wrong);
            assert!(complaint.contains("`all`, `shadow_rays_facing_away`, "), "{complaint}");
            assert!(!complaint.contains("paths_ended_by_depth"), "{complaint}");
        }
    }

    #[test]
    fn a_skip_with_an_option_of_its_own_is_answered_with_that() {
        for (key, option) in [
            ("branches_below_threshold", "`--cutoff 0`"),
            ("paths_ended_by_roulette", "`--roulette off`"),
            ("paths_ended_by_depth", "`--depth`"),
        ] {
            let complaint = format!("all,{key}").parse::<NoSkip>().expect_err(key);
            assert!(complaint.contains(option), "{complaint}");
        }
    }
}
