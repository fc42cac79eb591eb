//! "Did you mean": the known name that is nearest to an unknown one.

/// Longer names, in bytes, are no typing errors and take too long to compare.
const LONGEST_NAME: usize = 100;

/// The name in `known` that differs least from `name`, if it is near enough to be a typing error.
pub(crate) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if name.len() > LONGEST_NAME {
        return None;
    }
    let limit = (name.chars().count() / 2).max(1);
    known
        .into_iter()
        .map(|candidate| (distance(name, candidate), candidate))
        .filter(|&(distance, _)| distance <= limit)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// The remark that follows "does not exist": the nearest known name, else all of them.
pub(crate) fn remark<'a>(name: &str, known: impl IntoIterator<Item = &'a str> + Clone) -> String {
    if let Some(near) = nearest(name, known.clone()) {
        return format!("did you mean `{near}`?");
    }
    let names: Vec<_> = known.into_iter().take(20).map(|name| format!("`{name}`")).collect();
    if names.is_empty() {
        "there is none".to_owned()
    } else {
        format!("known: {}", names.join(", "))
    }
}

/// The smallest number of letters to insert, delete, replace or swap with their neighbour.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut table = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            table[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = table[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let swapped = if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    table[i - 2][j - 2] + 1
                } else {
                    usize::MAX
                };
                replaced.min(swapped).min(table[i - 1][j] + 1).min(table[i][j - 1] + 1)
            };
        }
    }
    table[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::{nearest, remark};

    #[test]
    fn the_nearest_name_is_found_within_half_a_word() {
        let known = ["radius", "center", "material"];
        assert_eq!(nearest("raduis", known), Some("radius"), "two letters swapped");
        assert_eq!(nearest("centre", known), Some("center"), "the other spelling");
        assert_eq!(nearest("colour", known), None, "nothing is near");
    }

    #[test]
    fn without_a_near_name_all_are_listed() {
        assert_eq!(remark("zzz", ["kd", "ks"]), "known: `kd`, `ks`", "the remark");
    }
}
