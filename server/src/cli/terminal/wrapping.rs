//! Text in lines that fit.

use anstyle::Style;

use crate::cli::terminal::paint::painted;

/// Columns of everything that is printed for people, on a terminal or not: half of a wide screen.
pub const COLUMNS: usize = 100;

/// A text in lines, broken between words; lines after the first are indented by so many spaces. A longer word stays whole.
pub fn wrapped(text: &str, indent: usize) -> String {
    let (mut lines, mut line, mut width) = (String::new(), String::new(), 0);
    for word in text.split(' ') {
        let length = word.chars().count();
        if width > 0 && width + 1 + length > COLUMNS {
            lines.push_str(line.trim_end());
            lines.push('\n');
            line = " ".repeat(indent);
            line.push_str(word);
            width = indent + length;
        } else {
            if width > 0 {
                line.push(' ');
            }
            line.push_str(word);
            width = line.chars().count();
        }
    }
    lines + &line + "\n"
}

/// A text behind its label, which stands out: `tied: ...`.
pub fn labelled(style: Style, label: &str, text: &str) -> String {
    let lines = wrapped(&format!("{label}: {text}"), 2);
    let rest = lines.strip_prefix(label).unwrap_or_default();
    painted(style, label) + rest
}

/// A text of at most so many characters; a longer one ends in dots.
pub fn cut(text: String, most: usize) -> String {
    if text.chars().count() <= most {
        return text;
    }
    let kept = text.chars().take(most.saturating_sub(3));
    kept.chain("...".chars()).collect()
}

/// Names in at most so many characters each: a longer one loses its middle, and first what all of them begin with, so that what differs is seen.
pub(crate) fn told_apart(names: &[String], most: usize) -> Vec<String> {
    let longest = names.iter().map(|name| name.chars().count()).max();
    if longest.unwrap_or(0) <= most {
        return names.to_vec();
    }
    let shared = shared_words(names);
    let rest = |name: &String| -> String { name.chars().skip(shared).collect() };
    let rests = names.iter().map(|name| match shared {
        0 => name.clone(),
        _ => format!("... {}", rest(name)),
    });
    rests.map(|name| middle_cut(&name, most)).collect()
}

/// Characters of the words that all names begin with; 0 of a lone name, of which nothing differs.
fn shared_words(names: &[String]) -> usize {
    let Some((first, others)) = names.split_first().filter(|(_, others)| !others.is_empty()) else {
        return 0;
    };
    let agreed = others.iter().map(|other| {
        let both = first.chars().zip(other.chars());
        both.take_while(|(one, other)| one == other).count()
    });
    let agreed = agreed.min().unwrap_or(0);
    let words: Vec<char> = first.chars().take(agreed).collect();
    words.iter().rposition(|c| *c == ' ').map_or(0, |at| at + 1)
}

/// A text of at most so many characters, of a longer one its beginning and its end.
pub(crate) fn middle_cut(text: &str, most: usize) -> String {
    let letters: Vec<char> = text.chars().collect();
    if letters.len() <= most {
        return text.to_owned();
    }
    let kept = most.saturating_sub(3);
    let end = kept / 2;
    let (begin, rest) = (&letters[..kept - end], &letters[letters.len() - end..]);
    begin.iter().chain(&['.'; 3]).chain(rest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::terminal::paint::GOOD;
    use crate::cli::terminal::shown::{plain, shown};

    #[test]
    fn lines_fit_and_lose_no_word() {
        let text = "größer ".repeat(60);
        let lines = wrapped(text.trim_end(), 2);
        assert!(lines.lines().all(|line| line.chars().count() <= COLUMNS));
        assert!(lines.lines().skip(1).all(|line| line.starts_with("  g")));
        assert_eq!(lines.split_whitespace().count(), 60);
        let long = "x".repeat(120);
        assert_eq!(wrapped(&long, 2), format!("{long}\n"));
        assert_eq!(
            wrapped(&format!("a {long} b"), 2),
            format!("a\n  {long}\n  b\n")
        );
    }

    #[test]
    fn a_label_is_painted_and_counts_as_what_is_seen() {
        let told = labelled(GOOD, "certain", &"word ".repeat(40));
        assert!(shown(&told).starts_with("\u{1b}[32mcertain\u{1b}[0m: word "));
        let plain = plain(&told);
        assert!(plain.lines().count() > 1 && plain.lines().all(|line| line.len() <= COLUMNS));
    }

    #[test]
    fn what_is_too_long_ends_in_dots() {
        assert_eq!(cut("abcdef".to_owned(), 6), "abcdef");
        assert_eq!(cut("abcdefg".to_owned(), 6), "abc...");
    }

    #[test]
    fn long_names_lose_what_they_share_and_then_their_middles() {
        let names =
            |texts: &[&str]| -> Vec<String> { texts.iter().map(|&t| t.to_owned()).collect() };
        let designs = names(&[
            "a tire with a name of many words, wall_mm = 2.5",
            "a tire with a name of many words, wall_mm = 3.5",
        ]);
        assert_eq!(told_apart(&designs, 60), designs);
        assert_eq!(told_apart(&designs, 12), ["... 2.5", "... 3.5"]);
        assert_eq!(told_apart(&designs[..1], 14), ["a tire...= 2.5"]);
        let others = names(&["eins größer als zwei", "drei"]);
        assert_eq!(told_apart(&others, 11), ["eins...zwei", "drei"]);
    }
}
