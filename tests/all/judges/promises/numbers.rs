//! Digits, read and printed.

use curveto::number::{
    compact, decimals_of, push_fixed, push_shortest, round, rounded_up, significant, text,
};

use super::{Check, ensure};

/// A float and a count of decimals, as bytes: what is printed is that of the standard library, and read again.
pub fn numbers(input: &[u8]) -> Check {
    words(&String::from_utf8_lossy(input))?;
    let Some((bytes, rest)) = input.split_first_chunk() else {
        return Ok(());
    };
    let decimals = rest.first().map_or(3, |byte| byte % 31);
    // Any bits, and decimals of everyday numbers.
    let any = f64::from_le_bytes(*bytes);
    for x in [any, i64::from_le_bytes(*bytes) as f64 / 1e12] {
        let (mut fixed, mut shortest) = (Vec::new(), Vec::new());
        push_fixed(&mut fixed, x, decimals);
        push_shortest(&mut shortest, x);
        let plain = |text: &[u8]| text.iter().all(|b| b.is_ascii_digit() || b"-.".contains(b));
        ensure(plain(&fixed) && plain(&shortest), || {
            format!("{x:e} is not plain")
        })?;
        let (fixed, shortest) = (as_text(fixed)?, as_text(shortest)?);
        if x.is_finite() {
            is_printed(x, decimals, &fixed, &shortest)?;
        }
        let digits = decimals % 17 + 1;
        let _ = (compact(x, digits), significant(x, digits));
        ensure(!x.is_finite() || rounded_up(x, digits) >= x, || {
            format!("{x:e} is rounded down")
        })?;
    }
    Ok(())
}

fn as_text(bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

fn is_printed(x: f64, decimals: u8, fixed: &str, shortest: &str) -> Check {
    let theirs = format!("{x:.*}", usize::from(decimals));
    let theirs = if theirs.contains('.') {
        theirs.trim_end_matches('0').trim_end_matches('.')
    } else {
        &theirs
    };
    let theirs = if theirs == "-0" { "0" } else { theirs };
    ensure(fixed == theirs, || format!("{x:e}: {fixed}, not {theirs}"))?;
    ensure(shortest.parse() == Ok(x), || format!("{x:e}: {shortest}"))?;
    ensure(fixed.parse() == Ok(round(x, decimals)), || {
        format!("{x:e}: {fixed} is not {:e}", round(x, decimals))
    })?;
    let after = shortest
        .split_once('.')
        .map_or(0, |(_, digits)| digits.len());
    ensure(usize::from(decimals_of(x)) == after.min(255), || {
        format!("{shortest} has {after} decimals")
    })?;
    ensure(text(x) == shortest, || {
        format!("{} and {shortest}", text(x))
    })
}

/// A radius in words is the number of the standard library, if it is one.
fn words(input: &str) -> Check {
    let is_number = !input.is_empty()
        && input
            .bytes()
            .all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let line = format!("circle 0 0 {input}");
    let read = curveto::batch::spec::Spec::parse(&line);
    let Ok(Ok(x)) = is_number
        .then(|| input.parse::<f64>())
        .transpose()
        .map(|x| x.ok_or(()))
    else {
        return Ok(());
    };
    let subject = curveto::Circle::new((0.0, 0.0), x);
    ensure(read.is_ok() == subject.is_ok(), || {
        format!("{input}: {read:?}, {subject:?}")
    })?;
    let (Ok(read), Ok(circle)) = (read, subject) else {
        return Ok(());
    };
    let meant = curveto::batch::spec::LineContent::Shape(curveto::Shape::Circle(circle));
    ensure(read.subject == meant, || {
        format!("{:?}, not {meant:?}", read.subject)
    })
}
