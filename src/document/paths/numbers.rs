//! Lists of numbers in attributes.

use crate::number::read as number;
use crate::path_data::grammar::{after_separator, after_space, is_space};

/// The numbers of a list with white space and at most one comma between them; else the byte where one is missing.
pub(super) fn list(text: &str) -> Result<Vec<f64>, usize> {
    let bytes = text.trim_end_matches(is_space).as_bytes();
    let (mut at, mut numbers) = (after_space(bytes, 0), Vec::new());
    while at < bytes.len() {
        let (number, end) = number::read(bytes, at).ok_or(at)?;
        numbers.push(number);
        at = after_separator(bytes, end);
        // After a comma another one has to follow.
        if at == bytes.len() && end < at {
            return Err(at);
        }
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_read_to_its_end() {
        for (text, numbers) in [
            ("", Ok(vec![])),
            (" \n", Ok(vec![])),
            (" 1,2 3-4\n.5.5 ", Ok(vec![1.0, 2.0, 3.0, -4.0, 0.5, 0.5])),
            ("1 ,\t2", Ok(vec![1.0, 2.0])),
            ("1,", Err(2)),
            ("1 , ", Err(3)),
            ("1,,2", Err(2)),
            (",1", Err(0)),
            ("1 inf", Err(2)),
            ("1px", Err(1)),
        ] {
            assert_eq!(list(text), numbers, "{text:?}");
        }
    }
}
