use super::*;
use crate::document::path::scratch::with_scratch;
use crate::joints::Cut;

/// How long a document becomes, or the byte of the element with which it becomes longer than so many bytes.
fn length(text: &str, most: usize) -> core::result::Result<usize, usize> {
    let options = Options {
        cut: Cut::Count(1000),
        ..Options::default()
    };
    let pass = with_scratch(&options, |scratch| {
        run(text.into(), &options, None, scratch, most)
    });
    match pass.map_err(|fault| fault.at)? {
        Pass::Done(done) => Ok(done.text.unwrap_or_default().len()),
        Pass::NeedsFacts => Ok(0),
    }
}

#[test]
fn what_becomes_too_large_is_refused_where_it_does() {
    let circles = |count| format!("<svg>{}</svg>", "<circle r='5'/>".repeat(count));
    let two = length(&circles(2), usize::MAX).unwrap();
    assert!(length(&circles(9), usize::MAX).unwrap() > 4 * two);
    let third = "<svg>".len() + 2 * "<circle r='5'/>".len();
    assert_eq!(length(&circles(9), two), Err(third));
    let arcs = "A5 5 0 0 1 9 9A5 5 0 0 1 0 0".repeat(9);
    let path = format!("<svg><path d='M0 0{arcs}'/></svg>");
    assert!(length(&path, usize::MAX).unwrap() > two);
    assert_eq!(length(&path, two), Err("<svg>".len()));
}
