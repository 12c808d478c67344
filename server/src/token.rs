//! The secret that lets a client in.

use std::fmt;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use fem_client::hexadecimal::hexadecimal;
use sha2::{Digest, Sha256};
use subtle::ConstantTimeEq;

/// Twice the 128 bits that nobody can try out.
const RANDOM_BYTES: usize = 32;
/// Shorter ones could be guessed by someone who has time.
const SHORTEST: usize = 16;
const LONGEST: usize = 512;

/// A secret text. It has no `Display`, and its `Debug` says nothing, so that it can't end in a log by oversight.
#[derive(Clone)]
pub struct Token(String);

impl Token {
    /// A new one, from the system's random numbers.
    ///
    /// # Errors
    /// When the system has none.
    pub fn random() -> Result<Self, TokenError> {
        let mut bytes = [0; RANDOM_BYTES];
        getrandom::fill(&mut bytes).map_err(|_| TokenError::NoRandomNumbers)?;
        Ok(Self(hexadecimal(&bytes)))
    }

    /// A token that somebody chose.
    ///
    /// # Errors
    /// [`TokenError::Unfit`] when it is too short, too long, or couldn't be sent in a header.
    pub fn chosen(text: &str) -> Result<Self, TokenError> {
        let text = text.trim_end_matches(['\n', '\r']);
        let fits = (SHORTEST..=LONGEST).contains(&text.len())
            && text.bytes().all(|byte| byte.is_ascii_graphic());
        fits.then(|| Self(text.to_owned())).ok_or(TokenError::Unfit)
    }

    /// The token in a file, alone on its line.
    ///
    /// # Errors
    /// When the file can't be read, or holds something else.
    pub(crate) fn in_file(path: &Path) -> Result<Self, TokenError> {
        // A longer text is no token, however long it is.
        let (longest, mut text) = (LONGEST as u64 + 3, String::new());
        let read = File::open(path).and_then(|file| file.take(longest).read_to_string(&mut text));
        read.map_err(|error| TokenError::File(error.kind()))?;
        Self::chosen(&text)
    }

    /// Whether somebody knows it. Takes as long for a nearly right text as for any other.
    pub fn is(&self, said: &[u8]) -> bool {
        // Hashes are of one length, whatever is said.
        let (own, said) = (Sha256::digest(self.0.as_bytes()), Sha256::digest(said));
        own.as_slice().ct_eq(said.as_slice()).into()
    }

    /// A secret of its own, made of this one: it is the same after a restart, and doesn't give this one away.
    pub(crate) fn derived(&self, purpose: &str) -> Self {
        let mut hasher = Sha256::new();
        for part in [purpose, &self.0] {
            hasher.update((part.len() as u64).to_le_bytes());
            hasher.update(part);
        }
        Self(hexadecimal(&hasher.finalize()))
    }

    /// The secret itself, for whoever is to have it.
    pub(crate) fn reveal(&self) -> &str {
        &self.0
    }
}

impl fmt::Debug for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Token")
    }
}

/// Reason why there is no token. None of them says anything of what stood in its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum TokenError {
    /// Text that isn't a token.
    #[error(
        "a token has {SHORTEST} to {LONGEST} visible ASCII characters and no space, as `openssl rand -hex 32` makes one"
    )]
    Unfit,
    /// The file can't be read.
    #[error("the token's file can't be read: {0}")]
    File(std::io::ErrorKind),
    /// The system has no random numbers.
    #[error("the system gives no random numbers to make a token of")]
    NoRandomNumbers,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_whole_token_is_right() {
        let token = Token::chosen("correct-horse-battery\n").expect("fits");
        assert!(token.is(b"correct-horse-battery"));
        for wrong in ["", "correct-horse-batter", "correct-horse-battery "] {
            assert!(!token.is(wrong.as_bytes()), "{wrong:?}");
        }
    }

    #[test]
    fn tokens_that_are_easily_guessed_or_can_not_be_sent_are_refused() {
        for text in [
            "",
            "secret",
            "fifteen-letters",
            "with a space in the middle",
            "späte-umlaute-im-wort",
        ] {
            assert_eq!(
                Token::chosen(text).err(),
                Some(TokenError::Unfit),
                "{text:?}"
            );
        }
        assert_eq!(
            Token::chosen(&"x".repeat(513)).err(),
            Some(TokenError::Unfit)
        );
        let missing = Token::in_file(Path::new("no/such/file")).expect_err("isn't there");
        assert_eq!(missing, TokenError::File(std::io::ErrorKind::NotFound));
    }

    #[test]
    fn drawn_tokens_are_long_and_never_alike() {
        let [one, other] = [(); 2].map(|()| Token::random().expect("random numbers"));
        assert_eq!(one.reveal().len(), 2 * RANDOM_BYTES);
        assert_ne!(one.reveal(), other.reveal());
    }

    #[test]
    fn what_is_made_of_a_token_stays_the_same_and_does_not_show_it() {
        let token = Token::random().expect("random numbers");
        let cookie = token.derived("cookie");
        assert!(token.derived("cookie").is(cookie.reveal().as_bytes()));
        assert!(!cookie.is(token.reveal().as_bytes()));
        assert!(!token.derived("link").is(cookie.reveal().as_bytes()));
        assert_eq!(format!("{token:?}"), "Token");
    }
}
