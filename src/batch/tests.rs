//! Inputs that come in pieces, and lines that are too long.

use super::*;

/// Gives one piece a read, or an error.
struct PieceReads(std::vec::IntoIter<io::Result<Vec<u8>>>);

fn pieces<const N: usize>(pieces: [io::Result<&[u8]>; N]) -> PieceReads {
    let pieces = pieces.map(|piece| piece.map(<[u8]>::to_vec));
    PieceReads(Vec::from(pieces).into_iter())
}

impl Read for PieceReads {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let Some(piece) = self.0.next().transpose()? else {
            return Ok(0);
        };
        buffer[..piece.len()].copy_from_slice(&piece);
        Ok(piece.len())
    }
}

/// What is written for this input, by one thread and by several, and the lines that failed.
fn answered(input: impl Fn() -> PieceReads, on_error: OnError) -> io::Result<(String, Vec<u64>)> {
    let of = |jobs| {
        let options = Options {
            on_error,
            jobs,
            ..Options::default()
        };
        let (mut out, mut failed) = (Vec::new(), Vec::new());
        run(input(), &mut out, &options, |line, _| failed.push(line))?;
        Ok((String::from_utf8(out).unwrap(), failed))
    };
    let alone = of(1);
    if let (Ok(alone), Ok(together)) = (&alone, &of(3)) {
        assert_eq!(alone, together);
    }
    alone
}

#[test]
fn a_byte_order_mark_is_left_out_at_the_beginning_only() {
    let input = || {
        pieces([
            Ok(b"\xef\xbb\xbf#\n"),
            Ok(b"#\n"),
            Ok(b"\xef\xbb\xbf#\n#\n"),
        ])
    };
    let (text, failed) = answered(input, OnError::Skip).unwrap();
    assert_eq!((text.as_str(), failed), ("\n\n\n", vec![3]));
}

#[test]
fn an_interrupted_read_is_tried_again_and_a_failed_one_ends_the_run() {
    let input = || {
        let interrupted = io::ErrorKind::Interrupted.into();
        pieces([Ok(b"# a"), Err(interrupted), Ok(b" b\n#\n")])
    };
    assert_eq!(answered(input, OnError::Stop).unwrap().0, "\n\n");
    let input = || pieces([Ok(b"#\n"), Err(io::ErrorKind::TimedOut.into()), Ok(b"#\n")]);
    let error = answered(input, OnError::Stop).unwrap_err();
    assert_eq!(error.kind(), io::ErrorKind::TimedOut);
}

#[test]
fn a_line_may_be_four_mebibytes_long() {
    let comment = |length: usize| {
        let mut input = vec![b'#'; length];
        input.extend_from_slice(b"\narc 0 0 1 0 90\n");
        io::Cursor::new(input)
    };
    let lines = |length| {
        let mut out = Vec::new();
        run(comment(length), &mut out, &Options::default(), |_, _| ()).map(|_| out)
    };
    let short = lines(1).unwrap();
    assert!(short.starts_with(b"\nM"));
    for length in [
        3 * CHUNK - 1,
        3 * CHUNK,
        3 * CHUNK + 1,
        LONGEST_LINE - CHUNK,
    ] {
        assert_eq!(lines(length).unwrap(), short, "{length}");
    }
    let error = lines(LONGEST_LINE + 3 * CHUNK).unwrap_err();
    assert_eq!(error.kind(), io::ErrorKind::InvalidData);
}

#[test]
fn a_line_that_is_too_long_is_named_and_ends_every_run() {
    for before in [0, 1, 2, 70_000] {
        for jobs in [1, 3] {
            let options = Options {
                on_error: OnError::Blank,
                jobs,
                ..Options::default()
            };
            let mut input = b"#\n".repeat(before);
            input.resize(input.len() + LONGEST_LINE + 3 * CHUNK, b'#');
            let mut out = Vec::new();
            let input = io::Cursor::new(input);
            let alone = run(input.clone(), &mut out, &options, |_, _| ()).unwrap_err();
            let picture = figure(input, &options, |_, _| ()).unwrap_err();
            let number = format!("{}: the line is longer than 4 MiB", before + 1);
            for error in [alone, picture] {
                assert!(error.to_string().starts_with(&number), "{error}");
                assert_eq!(error.kind(), io::ErrorKind::InvalidData);
            }
            assert_eq!(out, b"\n".repeat(before));
        }
    }
}

#[test]
fn the_first_of_the_worst_lines_is_named() {
    let input = &b"circle 0 0 1\ncircle 0 0 50\ncircle 0 0 9\ncircle 0 0 50\n"[..];
    for jobs in [1, 2] {
        let options = Options {
            jobs,
            measure: true,
            ..Options::default()
        };
        let summary = run(input, io::sink(), &options, |_, _| ()).unwrap();
        assert_eq!(summary.worst.unwrap().0, 2);
    }
}
