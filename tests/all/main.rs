//! All tests of the library and of the program, in one crate with a module a topic, so that the judges are compiled and linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
// The judges ask the platform's functions.
#![allow(clippy::disallowed_methods)]

mod arcs;
#[cfg(target_os = "linux")]
mod bad_input;
mod batch;
mod batch_picture;
mod bites;
mod chen_rounds;
mod chen_uneven;
mod cli;
mod conic;
mod conic_truth;
mod convert;
mod convert_cli;
mod convert_meaning;
mod corpora;
mod dependencies;
#[cfg(all(target_os = "linux", target_env = "gnu"))]
mod determinism;
mod diff;
mod documented_commands;
mod documents;
mod edges;
mod ellipse_methods;
mod every_method;
mod everyday;
mod examples;
mod exchange;
mod explore;
#[cfg(target_os = "linux")]
mod faults;
mod fewest_arcs;
mod fewest_segments;
#[cfg(unix)]
mod files;
mod format_goldens;
mod formats;
mod fuzz;
mod gallery;
mod golden;
mod help;
mod house;
mod judges;
mod known_answers;
mod lanes;
mod laws;
mod machines;
mod measure;
mod measure_cli;
#[cfg(target_os = "linux")]
mod memory;
mod method_values;
mod methods_to_256_bits;
mod mistakes;
mod oracle_checks;
mod oracle_reference;
mod output_options;
#[cfg(target_os = "linux")]
mod packages;
mod pdf;
mod peers;
mod pictures;
mod pipeline;
mod promises;
mod quadratics;
mod refused_numbers;
mod renderers;
mod same_numbers;
mod schema;
mod seldom;
mod sphere;
mod spline;
mod stated_errors;
mod truth;
mod way_back;
