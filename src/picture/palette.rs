//! Colours that colour-blind people can tell apart: Okabe & Ito, "Color Universal Design", 2008. Their yellow is left out: it is too
//! light for a line on white.

use super::paint::Paint;

pub(super) const ORANGE: Paint = Paint::rgb(0xe6, 0x9f, 0x00);
pub(super) const SKY_BLUE: Paint = Paint::rgb(0x56, 0xb4, 0xe9);
pub(super) const GREEN: Paint = Paint::rgb(0x00, 0x9e, 0x73);
pub(super) const BLUE: Paint = Paint::rgb(0x00, 0x72, 0xb2);
pub(super) const VERMILION: Paint = Paint::rgb(0xd5, 0x5e, 0x00);
pub(super) const PURPLE: Paint = Paint::rgb(0xcc, 0x79, 0xa7);

/// In the order in which lines take them.
pub(super) const LINES: [Paint; 7] = [
    BLUE,
    VERMILION,
    GREEN,
    PURPLE,
    ORANGE,
    SKY_BLUE,
    Paint::BLACK,
];
