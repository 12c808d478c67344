//! The command line, and what the environment and a file add to `serve`: flags come first, then the environment, then the file, then
//! defaults.
//!
//! The file's keys are the names of the flags. What it says takes the place of the flags' defaults, so that there is one reader for all of
//! them; every fault of all three is told at once.

use std::env;
use std::error::Error as _;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::cli::terminal::output::warn;
use crate::cli::terminal::paint::{BAD, painted};
use clap::builder::{OsStringValueParser, Resettable};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, ArgMatches, Command, CommandFactory, Error, FromArgMatches};
use document::MAX_BYTES;
use document::fault::Fault;
use service::study_document::text_files::read_text;
use toml::{Table, Value};

/// The command that has settings, and the flag that names their file.
const SERVE: &str = "serve";
const FILE: &str = "config";

/// Reads the command line. Prints what is wrong with it and ends the program, unless it is values of `serve` alone.
///
/// # Errors
/// Every value of `serve` that can't be used, with where it stands.
pub fn parse<C: CommandFactory + FromArgMatches>() -> Result<C, Vec<Fault>> {
    let matches = resolve(C::command(), env::args_os().collect())?;
    C::from_arg_matches(&matches).or_else(|error| end(&error))
}

fn resolve(mut command: Command, arguments: Vec<OsString>) -> Result<ArgMatches, Vec<Fault>> {
    let (mut matches, mut faults) = matches(&command, &arguments);
    let serve = matches.subcommand_matches(SERVE);
    // The path is of another type where the flag itself was at fault.
    let file = serve.and_then(|serve| serve.try_get_one::<PathBuf>(FILE).ok().flatten());
    if let Some(path) = file.cloned() {
        let settings = match read(&path) {
            Ok(table) => settings(&command, &path, table, &mut faults),
            Err(fault) => {
                faults.push(fault);
                Vec::new()
            }
        };
        for Setting { id, values } in settings {
            let with_default = |arg: Arg| arg.default_values(values);
            command = command.mut_subcommand(SERVE, |serve| serve.mut_arg(id, with_default));
        }
        matches = self::matches(&command, &arguments).0;
    }
    if faults.is_empty() {
        Ok(matches)
    } else {
        Err(faults)
    }
}

/// Reads the arguments, taking values that can't be used for what they are after noting them.
fn matches(command: &Command, arguments: &[OsString]) -> (ArgMatches, Vec<Fault>) {
    let (mut command, mut seen, mut faults) = (command.clone(), Vec::new(), Vec::new());
    loop {
        let error = match command.clone().try_get_matches_from(arguments) {
            Ok(matches) => return (matches, faults),
            Err(error) => error,
        };
        let serving = arguments.get(1).is_some_and(|name| name == SERVE);
        let arg =
            wrong_value(&command, &error).filter(|arg| serving && !seen.contains(arg.get_id()));
        let Some(arg) = arg else { end(&error) };
        faults.push(Fault {
            pointer: whence(&arg, arguments),
            detail: why(&error),
        });
        let id = arg.get_id().clone();
        seen.push(id.clone());
        let lenient = |arg: Arg| arg.value_parser(OsStringValueParser::new());
        command = command.mut_subcommand(SERVE, |serve| serve.mut_arg(id, lenient));
    }
}

/// Ends the program with its help, or with what is wrong with the arguments, which may hold any text.
fn end(error: &Error) -> ! {
    if matches!(
        error.kind(),
        ErrorKind::DisplayHelp
            | ErrorKind::DisplayVersion
            | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
    ) {
        error.exit();
    }
    let said = error.render().to_string();
    match said.strip_prefix(ERROR) {
        Some(why) => warn(&(painted(BAD, ERROR) + why)),
        None => warn(&said),
    }
    std::process::exit(error.exit_code())
}

/// Word with which what is wrong begins.
const ERROR: &str = "error:";

/// The setting of `serve` whose value is at fault, when it is that.
fn wrong_value(command: &Command, error: &Error) -> Option<Arg> {
    if !matches!(
        error.kind(),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation
    ) {
        return None;
    }
    let shown = said(error, ContextKind::InvalidArg);
    let long = shown.strip_prefix("--")?.split([' ', '=']).next()?;
    flag(command, long)
}

fn flag(command: &Command, long: &str) -> Option<Arg> {
    let mut flags = command.find_subcommand(SERVE)?.get_arguments();
    flags.find(|arg| arg.get_long() == Some(long)).cloned()
}

/// Returns the names that a file can set: every flag but those that are about the call itself.
fn names(command: &Command) -> Vec<String> {
    let serve = command.find_subcommand(SERVE);
    let longs = serve
        .into_iter()
        .flat_map(|serve| serve.get_arguments().filter_map(Arg::get_long));
    let own = |long: &&str| ![FILE, "help", "version"].contains(long);
    longs
        .filter(own)
        .map(|long| long.replace('-', "_"))
        .collect()
}

/// Says where the value stands: in the flag, or else in the environment.
fn whence(arg: &Arg, arguments: &[OsString]) -> String {
    let flag = format!("--{}", arg.get_long().unwrap_or_default());
    let assigned = format!("{flag}=");
    let given = arguments
        .iter()
        .any(|argument| *argument == *flag || argument.to_string_lossy().starts_with(&assigned));
    match arg.get_env() {
        Some(variable) if !given => variable.to_string_lossy().into_owned(),
        _ => flag,
    }
}

fn why(error: &Error) -> String {
    let value = said(error, ContextKind::InvalidValue);
    let why = match error.source() {
        Some(cause) => cause.to_string(),
        None => format!("it is one of {}", said(error, ContextKind::ValidValue)),
    };
    format!("{value:?} can't be used: {why}")
}

fn said(error: &Error, kind: ContextKind) -> String {
    match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    }
}

fn read(path: &Path) -> Result<Table, Fault> {
    let fault = |detail: String| Fault {
        pointer: path.display().to_string(),
        detail,
    };
    let text = read_text(path, MAX_BYTES).map_err(|detail| Fault {
        pointer: String::new(),
        detail,
    })?;
    text.parse()
        .map_err(|error: toml::de::Error| fault(format!("isn't TOML: {error}")))
}

/// A flag and what the file says of it.
struct Setting {
    id: String,
    values: Vec<String>,
}

/// Returns what the file says, as far as it can be used.
fn settings(command: &Command, path: &Path, table: Table, faults: &mut Vec<Fault>) -> Vec<Setting> {
    let mut settings = Vec::new();
    for (key, value) in table {
        match setting(command, &key, &value) {
            Ok(setting) => settings.push(setting),
            Err(detail) => faults.push(Fault {
                pointer: format!("{}: {key}", path.display()),
                detail,
            }),
        }
    }
    settings
}

fn setting(command: &Command, key: &str, value: &Value) -> Result<Setting, String> {
    let names = names(command);
    let known = names.iter().any(|name| name == key);
    let arg = known
        .then(|| flag(command, &key.replace('_', "-")))
        .flatten();
    let arg =
        arg.ok_or_else(|| format!("there is no such setting; there are {}", names.join(", ")))?;
    let values = match arg.get_action() {
        ArgAction::SetTrue => {
            let on = value.as_bool().ok_or("it is true or false")?;
            return Ok(Setting {
                id: arg.get_id().to_string(),
                values: vec![on.to_string()],
            });
        }
        ArgAction::Append => match value {
            Value::Array(values) => values.iter().map(text).collect::<Result<Vec<_>, _>>()?,
            single => vec![text(single)?],
        },
        _ => vec![text(value)?],
    };
    check(&arg, &values)?;
    Ok(Setting {
        id: arg.get_id().to_string(),
        values,
    })
}

fn text(value: &Value) -> Result<String, String> {
    match value {
        Value::String(text) => Ok(text.clone()),
        Value::Integer(number) => Ok(number.to_string()),
        Value::Float(number) => Ok(number.to_string()),
        _ => Err("it is a text or a number".to_owned()),
    }
}

/// Has the flag's own reader read the values, the environment aside.
fn check(arg: &Arg, values: &[String]) -> Result<(), String> {
    let name = arg.get_long().unwrap_or_default();
    let alone = Command::new(SERVE)
        .no_binary_name(true)
        .arg(arg.clone().env(Resettable::Reset));
    let arguments = values.iter().map(|value| format!("--{name}={value}"));
    let read = alone.try_get_matches_from(arguments);
    read.map(|_| ()).map_err(|error| why(&error))
}

#[cfg(test)]
mod tests {
    use std::num::NonZeroUsize;

    use super::*;

    /// A command as `serve` is, without its environment.
    fn command() -> Command {
        let number = |name: &'static str| {
            Arg::new(name)
                .long(name)
                .value_parser(clap::value_parser!(NonZeroUsize))
        };
        let serve = Command::new(SERVE)
            .arg(
                Arg::new(FILE)
                    .long(FILE)
                    .value_parser(clap::value_parser!(PathBuf)),
            )
            .arg(number("threads").default_value("1"))
            .arg(number("most-waiting").default_value("7"))
            .arg(Arg::new("token").long("token").action(ArgAction::SetTrue))
            .arg(Arg::new("host").long("host").action(ArgAction::Append))
            .arg(
                Arg::new("log-format")
                    .long("log-format")
                    .value_parser(["text", "json"]),
            );
        Command::new("strainsite").subcommand(serve)
    }

    fn resolved(file: &str, flags: &[&str]) -> Result<ArgMatches, Vec<String>> {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("settings.toml");
        std::fs::write(&path, file).expect("writes");
        let mut arguments: Vec<OsString> = ["strainsite", SERVE, "--config"]
            .map(OsString::from)
            .to_vec();
        arguments.push(path.into());
        arguments.extend(flags.iter().map(OsString::from));
        match resolve(command(), arguments) {
            Ok(matches) => Ok(matches.subcommand_matches(SERVE).expect("serve").clone()),
            Err(faults) => Err(faults.iter().map(ToString::to_string).collect()),
        }
    }

    #[test]
    fn flags_go_before_the_file_and_the_file_before_defaults() {
        let file = "most_waiting = 9\ntoken = true\nhost = [\"a.example\", \"b.example\"]\nlog_format = \"json\"\nthreads = 3";
        let found = resolved(file, &["--threads", "5", "--host", "c.example"]).expect("valid");
        let number = |name: &str| {
            found
                .get_one::<NonZeroUsize>(name)
                .map(|number| number.get())
        };
        let texts = |name: &str| {
            found
                .get_many::<String>(name)
                .expect("values")
                .cloned()
                .collect::<Vec<_>>()
        };
        assert_eq!(
            (number("threads"), number("most-waiting")),
            (Some(5), Some(9))
        );
        assert!(found.get_flag("token"));
        assert_eq!(
            (texts("host"), texts("log-format")),
            (vec!["c.example".to_owned()], vec!["json".to_owned()])
        );
        let default = resolved("", &[]).expect("valid");
        assert!(!default.get_flag("token"));
        assert_eq!(
            default
                .get_one::<NonZeroUsize>("most-waiting")
                .map(|number| number.get()),
            Some(7)
        );
    }

    #[test]
    fn every_fault_of_flags_and_file_is_told_at_once() {
        let file = "most_waiting = 0\ntoken = \"hush\"\nlog_format = \"xml\"\ncolour = \"black\"\nthreads = [1]\nconfig = \"other.toml\"";
        let faults = resolved(file, &["--threads", "many"]).expect_err("faults");
        assert_eq!(faults.len(), 7, "{faults:#?}");
        for (place, what) in [
            ("--threads", "\"many\" can't be used"),
            ("most_waiting", "\"0\" can't be used"),
            ("token", "it is true or false"),
            ("log_format", "it is one of text, json"),
            (
                "colour",
                "there are threads, most_waiting, token, host, log_format",
            ),
            ("threads", "it is a text or a number"),
            ("config", "there is no such setting"),
        ] {
            let told = faults
                .iter()
                .any(|fault| fault.contains(place) && fault.contains(what));
            assert!(told, "{place}: {what} is not in {faults:#?}");
        }
        assert!(
            !faults.concat().contains("hush"),
            "what should be secret isn't shown"
        );
    }

    #[test]
    fn a_file_that_can_not_be_read_is_named() {
        let faults = resolved("threads = ", &[]).expect_err("not TOML");
        assert!(
            faults[0].contains("settings.toml: isn't TOML"),
            "{faults:?}"
        );
        let missing = resolve(
            command(),
            ["strainsite", SERVE, "--config", "no/such.toml"]
                .map(OsString::from)
                .to_vec(),
        );
        let faults = missing.expect_err("not there");
        assert!(
            faults[0]
                .to_string()
                .starts_with("no/such.toml can't be read"),
            "{faults:?}"
        );
    }
}
