//! The promises of tests/all/judges/promises.rs, for the fuzz targets: a target is broken where a promise is.

#![allow(dead_code, unused_imports)]

#[path = "../../tests/all/judges"]
pub mod judges {
    mod exact;
    mod independent;
    mod oracle;
    pub mod promises;
    mod way_back;
}

pub use judges::promises::hold;
