//! What the summary says of a film.

use crate::Film;
use crate::goal::is_reached;

/// "16 samples", or "24 (16 to 40) samples", where the first is the average.
pub(crate) fn samples(film: &Film) -> String {
    match film.samples().into() {
        (1, 1) => "1 sample".to_owned(),
        (fewest, most) if fewest == most => format!("{most} samples"),
        (fewest, most) => format!("{} ({fewest} to {most}) samples", film.average_samples()),
    }
}

/// ", estimated error 0.901 % (relMSE 8.1e-5)", or nothing if it is not known.
pub(crate) fn error(film: &Film) -> String {
    film.estimated_error().map_or_else(String::new, |error| {
        format!(", estimated error {} (relMSE {:.1e})", percent(error), error * error)
    })
}

/// What to say of a picture that Ctrl-C ended, which was to have `wanted` samples a pixel.
pub(crate) fn interruption(film: &Film, wanted: Option<u32>) -> String {
    let wanted = wanted.map_or_else(String::new, |wanted| format!(" of {wanted}"));
    format!("interrupted: the picture holds {} a pixel{wanted}", samples(film))
}

/// What to say of an error that was asked for and not reached.
pub(crate) fn missed_error(film: &Film, wanted: Option<f64>) -> Option<String> {
    let wanted = wanted.filter(|&wanted| !is_reached(film, wanted))?;
    let reason = match film.estimated_error() {
        None => "there are too few finite samples to estimate it".to_owned(),
        Some(0.0) => "no sample has found any light yet".to_owned(),
        Some(error) => format!("the estimated error is {}", percent(error)),
    };
    // As it was typed: an f32 forgets that 7 % became 0.07 in between.
    let wanted = (100.0 * wanted) as f32;
    Some(format!(
        "`--error {wanted}%` was not reached, {reason}; allow more `--samples` or `--time`"
    ))
}

/// What to say of samples that are not finite.
pub(crate) fn non_finite(film: &Film) -> Option<String> {
    let [x, y] = film.first_non_finite_pixel()?;
    let count = film.non_finite_samples();
    Some(format!(
        "{count} samples were not finite and are left out, the first at `--pixel {x},{y}`"
    ))
}

/// A fraction of 1 as a percentage with three digits: 0.901 %, 12.5 %, 340 %.
pub(crate) fn percent(fraction: f64) -> String {
    let percent = 100.0 * fraction;
    let decimals = match percent {
        p if p >= 99.95 || p == 0.0 => 0,
        p if p >= 9.995 => 1,
        p if p >= 0.9995 => 2,
        p if p >= 0.0995 => 3,
        _ => return format!("{percent:.1e} %"),
    };
    format!("{percent:.decimals$} %")
}

#[cfg(test)]
mod tests {
    use super::{error, interruption, missed_error, percent, samples};
    use crate::portion::Portion;
    use crate::{Film, Sampler};

    /// A film with `count` samples of brightness 0 or `brightness`, at even odds.
    fn film(count: u32, brightness: f32) -> Film {
        let mut film = Film::estimating([8, 8]).expect("a small film");
        let coin = |_, sampler: &mut Sampler| [(2.0 * sampler.next_1d()).floor() * brightness; 3];
        film.expose(0, Portion::Even(count), &coin, &|| false, &|_| ());
        film
    }

    #[test]
    fn percentages_have_three_digits() {
        let texts = [0.0, 4e-6, 0.001_23, 0.009_01, 0.0999, 0.099_96, 0.5, 3.4].map(percent);
        let expected =
            ["0 %", "4.0e-4 %", "0.123 %", "0.901 %", "9.99 %", "10.0 %", "50.0 %", "340 %"];
        assert_eq!(texts, expected, "the texts");
    }

    #[test]
    fn the_error_is_said_as_soon_as_it_is_known() {
        assert_eq!(error(&film(3, 1.0)), "", "after three samples");
        let text = error(&film(64, 1.0));
        assert!(text.starts_with(", estimated error 2") && text.contains(" % (relMSE "), "{text}");
        assert_eq!(samples(&film(1, 1.0)), "1 sample", "a single sample");
    }

    #[test]
    fn an_error_that_was_missed_is_said_with_its_reason() {
        let missed = |count, brightness| missed_error(&film(count, brightness), Some(0.05));
        assert_eq!(missed_error(&film(16, 1.0), None), None, "none was asked for");
        assert_eq!(missed(4096, 1.0), None, "after 4096 samples");
        let texts =
            [missed(3, 1.0), missed(16, 1.0), missed(16, 0.0)].map(Option::unwrap_or_default);
        for (text, reason) in texts.iter().zip(["too few", "estimated error is ", "any light"]) {
            assert!(text.starts_with("`--error 5%` was not reached, "), "{text}");
            assert!(text.contains(reason), "no `{reason}` in: {text}");
        }
    }

    #[test]
    fn an_interruption_is_said_with_what_was_wanted_if_anything_was() {
        let film = film(3, 1.0);
        let texts = [Some(8), None].map(|wanted| interruption(&film, wanted));
        let held = "interrupted: the picture holds 3 samples a pixel";
        assert_eq!(texts, [format!("{held} of 8"), held.to_owned()], "the sentences");
    }
}
