#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| curveto_fuzz::hold("documents", input));
