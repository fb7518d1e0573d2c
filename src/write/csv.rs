//! Comma-separated values, after RFC 4180.

/// A line of names and a line for each row.
pub(super) fn lines<R: AsRef<[String]>>(names: &str, rows: impl IntoIterator<Item = R>) -> String {
    let mut out = names.to_owned() + "\n";
    for row in rows {
        let fields: Vec<String> = row.as_ref().iter().map(|text| field(text)).collect();
        out += &(fields.join(",") + "\n");
    }
    out
}

/// In quotes where it holds a comma, a quote or a line break.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_end_a_field_is_in_quotes() {
        let row = ["plain", "a,b", "5\" wide", "two\nlines", ""].map(str::to_owned);
        let text = lines("v,w,x,y,z", [row]);
        let right = "v,w,x,y,z\nplain,\"a,b\",\"5\"\" wide\",\"two\nlines\",\n";
        assert_eq!(text, right);
    }
}
