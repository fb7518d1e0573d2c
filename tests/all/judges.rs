//! What judges the library and the program without sharing their code.

pub(crate) mod chain;
pub(crate) mod exact;
pub(crate) mod ghostscript;
pub(crate) mod independent;
pub(crate) mod oracle;
pub(crate) mod program;
pub(crate) mod promises;
pub(crate) mod random;
pub(crate) mod raster;
pub(crate) mod way_back;
