#!/bin/sh
# Draws the pictures of docs/spline.md, docs/sphere.md and docs/lancaster.md anew.
# Run in the root of the repository after `make build`; CURVETO names another program.
set -eu
curveto=${CURVETO:-target/release/curveto}
out=docs/images
uneven=0,30,90,120,180,210,270,300
zigzag='0,0 1,2 1.3,2.1 4,2 4.2,0.2 7,0 7.1,1.8'

# Chen's Figures 5, 6 and 7, and the circle that his Formulation III makes of the same points.
figure() {
    name=$1
    shift
    "$curveto" circle 100 "$@" --show joints,truth --stroke-width 1.6 --background white -o "$out/$name.svg"
}
figure chen-figure-5 -m chen-1
figure chen-figure-6 -m chen-1 --joints $uneven
figure chen-figure-7 -m chen-2 --joints $uneven
figure chen-formulation-3 -m chen-3 --joints $uneven

# One set of points, four parametrizations.
for parametrization in uniform centripetal chord arc-length; do
    "$curveto" spline --points "$zigzag" --parametrization $parametrization \
        --show joints --stroke-width 0.05 --margin 0.1 --background white -o "$out/spline-$parametrization.svg"
done

# Chen's Figure 1.
"$curveto" sphere 100 --meridians 12 --parallels 7 --view 30,20 --hidden dash \
    --margin 3 --background white --size 480x480 -o "$out/sphere.png"
"$curveto" sphere 100 --meridians 24 --parallels 11 --view=-20,35 --hidden none \
    --stroke '#234' --fill '#e8f1fa' --margin 3 --background white --size 480x480 -o "$out/sphere-solid.png"

# Lancaster's eight splines, their error drawn 10000 times as large.
"$curveto" circle 100 -n 8 -m lancaster-best -p 12 --show joints,handles,error=10000 \
    --stroke-width 1 --background white -o "$out/lancaster-eight.svg"

# An emblem of ellipses by Lancaster's procedure, set by Ghostscript.
{
    "$curveto" procset -m lancaster-drawellipse
    cat docs/emblem.ps
} | gs -q -dBATCH -dNOPAUSE -dSAFER -sDEVICE=png16m -r96 -dGraphicsAlphaBits=4 \
    -dDEVICEWIDTHPOINTS=320 -dDEVICEHEIGHTPOINTS=220 -sOutputFile="$out/lancaster-emblem.png" -
