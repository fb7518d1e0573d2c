//! The format of a file: the one that was named, or the one that its extension tells.

use std::path::Path;

use clap::ValueEnum;
use curveto::write::{Format, Image};

use super::failure::Failure;
use super::remedies::in_a_sentence;

/// A format of one of the commands.
pub(crate) trait FileFormat: ValueEnum + PartialEq {
    /// The extensions of its files, in lower case.
    fn extensions(&self) -> &'static [&'static str];
}

impl FileFormat for Format {
    fn extensions(&self) -> &'static [&'static str] {
        Self::extensions(*self)
    }
}

impl FileFormat for Image {
    fn extensions(&self) -> &'static [&'static str] {
        Self::extensions(*self)
    }
}

/// The format that was named, or that the extension of the output tells; the default where there is neither.
pub(crate) fn choose<F: FileFormat + Default>(
    named: Option<F>,
    output: Option<&Path>,
) -> Result<F, Failure> {
    choose_but(None, named, output)
}

/// The same for a command that cannot make this format.
pub(crate) fn choose_but<F: FileFormat + Default>(
    left_out: Option<&F>,
    named: Option<F>,
    output: Option<&Path>,
) -> Result<F, Failure> {
    match (named, output.and_then(extension)) {
        (Some(format), _) => Ok(format),
        (None, None) => Ok(F::default()),
        (None, Some(extension)) => by_extension(&extension).ok_or_else(|| {
            Failure::request_with_hint(
                format!("no format of this command has the extension .{extension}"),
                format!(
                    "its formats are {}; -f names one, whatever the file is called",
                    list_but(left_out)
                ),
            )
        }),
    }
}

/// The format of a plot, which the extension of its file tells; SVG where it has none, such as `/dev/fd/3`.
pub(crate) fn of_plot(file: &Path) -> Result<Image, Failure> {
    let Some(extension) = extension(file) else {
        return Ok(Image::Svg);
    };
    by_extension(&extension).ok_or_else(|| {
        Failure::request_with_hint(
            format!(
                "the extension of {} tells no format of a plot",
                file.display()
            ),
            format!(
                "its formats are {}, and svg without an extension",
                list::<Image>()
            ),
        )
    })
}

/// The format of drawings that the extension of a file tells.
pub(crate) fn of_extension(file: &Path) -> Option<Format> {
    by_extension(&extension(file)?)
}

fn extension(file: &Path) -> Option<String> {
    let extension = file.extension()?.to_string_lossy().to_ascii_lowercase();
    (!extension.is_empty()).then_some(extension)
}

fn by_extension<F: FileFormat>(extension: &str) -> Option<F> {
    let mut formats = F::value_variants().iter();
    formats
        .find(|format| format.extensions().contains(&extension))
        .cloned()
}

/// All of them in a sentence.
pub(crate) fn list<F: FileFormat>() -> String {
    list_but::<F>(None)
}

fn list_but<F: FileFormat>(left_out: Option<&F>) -> String {
    let names: Vec<String> = F::value_variants()
        .iter()
        .filter(|&format| left_out != Some(format))
        .filter_map(|format| Some(format.to_possible_value()?.get_name().to_owned()))
        .collect();
    in_a_sentence(&names, "and")
}
