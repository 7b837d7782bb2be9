#!/bin/sh
# Draws every picture of docs/gallery.md and writes the page itself, so that each picture stands above the very command that
# drew it. Needs ffmpeg for the animation, and ImageMagick to tell which pictures have changed.
# Usage: gallery.sh FOLDER_OF_PROGRAMS, from the top of the repository.
set -eu
programs=$1
page=docs/gallery.md
pictures=docs/gallery
mkdir -p $pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r $pictures "$scratch/before"

text() {
    cat >> $page
    echo >> $page
}

# picture NAME COMMAND...: runs the command, one of this project's, to draw the picture, and records both for the page.
picture() {
    name=$1
    shift
    echo "$name"
    commands="$commands    $* -o $name.png
"
    program=$1
    shift
    "$programs/$program" "$@" -o $pictures/"$name".png > /dev/null
    cells="$cells ![$name](gallery/$name.png) |"
}

# row HEADING...: starts a row of pictures under these headings.
row() {
    commands=
    cells='|'
    heads='|'
    rule='|'
    for heading; do
        heads="$heads $heading |"
        rule="$rule---|"
    done
}

end_row() {
    printf '%s\n%s\n%s\n\n%s\n' "$heads" "$rule" "$cells" "$commands" >> $page
}

# views NAME VIEW...: draws a scene from each side.
views() {
    scene=$1
    shift
    row "$@"
    for view in "$@"; do
        picture "$scene-$view" ew-render demo/scenes/"$scene-$view".json --size 256x256
    done
    end_row
}

# banding NAME: draws a scene with both integrators.
banding() {
    row 'adaptive (ours)' 'Simpson, 64 divisions' 128 256
    for integrator in adaptive simpson:64 simpson:128 simpson:256; do
        picture "$1-$(echo $integrator | tr -d :)" ew-render demo/scenes/"$1".json --size 240x240 --integrator $integrator
    done
    end_row
}

# pulse_weights FRAME: prints the 7 weights of thesis (5.1) as a JSON list.
pulse_weights() {
    awk -v frame="$1" 'BEGIN {
        pi = atan2(0, -1)
        for (i = 0; i < 7; i++) {
            theta = (frame - 7 * i) / 25 * pi
            weight = theta < 0 || theta > 2 * pi ? 0 : (0.8 - cos(theta)) / 1.5
            weight = weight < 0 ? 0 : weight > 1 ? 1 : weight
            list = list (i ? ", " : "") sprintf("%.4g", weight)
        }
        print "[" list "]"
    }'
}

rm -f $page
text << 'TEXT'
# Gallery

Each picture stands above the command that drew it. `./run gallery` redraws all of them and rewrites this page. The programs are
`build/demo/ew-render` and `build/demo/ew-demo`. Figure numbers are those of Watanabe's thesis; the scenes follow its figures.
[Your first wave](first-wave.md) shows how to make such a picture by hand, in ten steps.

## The court

`./run demo` shows the court in a window. You can fly through it, and switch between the integrators by keys while it runs. Every
light is of the world integral, in metres, and drawn with the composite `soft` as the library gives it: the demo grades nothing.
The stone beneath it is the demo's own, with its moonlight, reflection and tone mapping; what glows lights it, with shadows, by
`EW_OUTPUT_SURFACES`. Mist lies on the floor: the frame's `fog` dims the light in it, and the demo dims its stone by the same. The gas
round the emitters is `media`, and so is the force field that flares up where the beam hits.

![The court: lightning charges an orb, the orb fires a beam, and a ring spreads](gallery/court.webp)

    ew-demo --offscreen --fps 15 --frames 0-149 --size 480x270 --samples 2 -o court-%03d.png
TEXT

row 'a slash' 'charged' 'half a second after the shot'
picture court-slash ew-demo --offscreen --frames 97 --size 480x270 --samples 2
picture court-charged ew-demo --offscreen --frames 148 --size 480x270 --samples 2
picture court-fired ew-demo --offscreen --frames 165 --size 480x270 --samples 2
end_row

text << 'TEXT'
A flight from 100 metres away into the orb. Light looks the same from everywhere: it only grows. A core is at least 1.5 pixels
wide, and pales where it would be thinner.
TEXT
row '100 m' '32 m' '10 m' '4 m' '1 m'
for frame in 0 50 100 140 200; do
    picture court-flight-$frame ew-demo --offscreen --flight --frames $frame --size 320x180 --samples 2
done
end_row

text << 'TEXT'
How often each pixel's ray was evaluated half a second after the shot, from black (0) to pale yellow (4096): light costs only
where it reaches.
TEXT
row 'adaptive'
picture court-evaluations ew-demo --offscreen --frames 165 --size 480x270 --show evaluations
end_row

text << 'TEXT'
## Light on surfaces

One more call lights the opaque scene: from its depth alone, and with shadows on request.
TEXT
row 'glow alone' 'light on surfaces' 'with shadows'
sed '/"light":/d' demo/scenes/lit-beam.json > "$scratch/lit-beam-off.json"
sed 's/, "shadow_thickness": 0.7//' demo/scenes/lit-beam.json > "$scratch/lit-beam-unshaded.json"
for variant in -off -unshaded; do
    echo "lit-beam$variant"
    "$programs"/ew-render "$scratch/lit-beam$variant.json" --size 320x214 -o $pictures/lit-beam$variant.png > /dev/null
    cells="$cells ![lit-beam$variant](gallery/lit-beam$variant.png) |"
done
picture lit-beam ew-render demo/scenes/lit-beam.json --size 320x214
commands="$commands
The first two are of the same scene without \`light\`, and without \`shadow_thickness\`.
"
end_row

text << 'TEXT'
## In fog and behind glass

Light pales on its way to the eye, inside the integral. What fog does to the stone is the host's business, and is left out here; the
court above has both.
TEXT
row 'no fog' '"extinction": 0.03' 'by height: "extinction": 0.25, "scale": 1.2'
picture showpiece-clear ew-render demo/scenes/showpiece.json --size 320x180
for fog in '"extinction": 0.03' '"extinction": 0.25, "height": { "scale": 1.2 }'; do
    name=showpiece-fog
    [ "$fog" = '"extinction": 0.03' ] || name=showpiece-fog-low
    sed "s/\"composite\": \"soft\"/\"composite\": \"soft\", \"fog\": { $fog }/" demo/scenes/showpiece.json > "$scratch/$name.json"
    echo "$name"
    "$programs"/ew-render "$scratch/$name.json" --size 320x180 -o $pictures/$name.png > /dev/null
    cells="$cells ![$name](gallery/$name.png) |"
    commands="$commands    \"fog\": { $fog }
"
done
end_row

text << 'TEXT'
The scene of the light on surfaces, in fog, and among bodies that dim it and what is behind them: tinted glass, a force field, smoke.
TEXT
row 'in fog' 'behind glass'
sed 's/"composite": "soft"/"composite": "soft", "fog": { "extinction": 0.18 }/' demo/scenes/lit-beam.json > "$scratch/lit-beam-fog.json"
echo lit-beam-fog
"$programs"/ew-render "$scratch/lit-beam-fog.json" --size 480x321 -o $pictures/lit-beam-fog.png > /dev/null
cells="$cells ![lit-beam-fog](gallery/lit-beam-fog.png) |"
commands="    \"fog\": { \"extinction\": 0.18 }
"
picture behind-glass ew-render demo/scenes/behind-glass.json --size 480x321
end_row

text << 'TEXT'
## A torus from three sides (figures 5.1 and 5.2)
TEXT
views torus-0.9 front oblique edge
views torus-3.0 front oblique edge

text << 'TEXT'
## Two Bezier curves, joined (figures 5.3 and 5.4)
TEXT
views beziers-5.0 front oblique side
views beziers-7.5 front oblique side
text << 'TEXT'
The maps below are of the oblique view. On the left is the number of evaluations along each pixel's ray, from black (0) to pale
yellow (4096). On the right is the error of its luminance, from black (1e-6 or less) to pale yellow (0.1 or more), relative to
Simpson's rule with 16384 divisions.
TEXT
row 'evaluations: adaptive, then Simpson, 256 divisions' 'errors: adaptive, then Simpson, 256 divisions'
picture beziers-evaluations ew-demo demo/scenes/beziers-7.5-oblique.json --offscreen --frames 0 --size 256x256 \
    --split simpson:256 --show evaluations
picture beziers-error ew-demo demo/scenes/beziers-7.5-oblique.json --offscreen --frames 0 --size 256x256 \
    --split simpson:256 --show error
end_row

text << 'TEXT'
## Weights along a curve (figure 5.6)
TEXT
row 'all weights 1' 'W = [1, 0.2, 0.6, 1, 0.5, 0.8, 1]'
picture weights-ones ew-render demo/scenes/weights-ones.json --size 256x256
picture weights-seven ew-render demo/scenes/weights-seven.json --size 256x256
end_row

text << 'TEXT'
## A pulse runs along a curve (figure 5.7)

The weights are those of equation (5.1) at the frame number above each picture; in the library, `ew_fill_pulse_weights` computes
them. The scene is `weights-seven.json` with these weights instead of its own.
TEXT
row 15 25 35 45 55 65
for frame in 15 25 35 45 55 65; do
    weights=$(pulse_weights $frame)
    sed "s/\"weights\": \[[^]]*\]/\"weights\": $weights/" demo/scenes/weights-seven.json > "$scratch/pulse-$frame.json"
    echo "pulse-$frame"
    "$programs"/ew-render "$scratch/pulse-$frame.json" --size 160x160 -o $pictures/pulse-$frame.png > /dev/null
    cells="$cells ![frame $frame](gallery/pulse-$frame.png) |"
    commands="$commands    $frame: \"weights\": $weights
"
done
commands="$commands
    ew-render pulse.json --size 160x160 -o pulse.png
"
end_row
text << 'TEXT'
The cut under the arc is the field's own: each place takes its weight from the nearest point of the curve, which jumps there from
one side of the arc to the other. [The page for artists](artists.md#weights) shows how a reach hides it.
TEXT

text << 'TEXT'
## Too few divisions leave bands (figures 5.9 to 5.12)

With few divisions, the papers' rule leaves uneven bands. A high coefficient hides them in white. The adaptive integrator leaves
none.

A torus, with coefficient 8, then 4:
TEXT
banding banding-torus-8.0
banding banding-torus-4.0
echo 'A curve, with coefficient 8, then 4:' | text
banding banding-curve-8.0
banding banding-curve-4.0

text << 'TEXT'
## In use (figure 5.8)
TEXT
row 'the showpiece: an orb, its ring, beams, lightning, a slash and a spiral round a pillar'
picture showpiece ew-render demo/scenes/showpiece.json --size 640x360
end_row

echo 'court.webp'
"$programs"/ew-demo --offscreen --fps 15 --frames 0-149 --size 480x270 --samples 2 -o "$scratch/%03d.png"
# libwebp_anim leaves blocks of earlier frames where a glow fades, and its files are no smaller.
ffmpeg -loglevel error -y -framerate 15 -i "$scratch/%03d.png" -c:v libwebp -quality 72 -compression_level 6 -loop 0 \
    $pictures/court.webp

# Whether two pictures differ by 1/255 at the most.
is_alike() {
    compare -metric PAE "$1" "$2" null: 2>&1 | awk '{ exit !(/^[0-9.e+-]+ \(/ && substr($2, 2) + 0 < 1.5 / 255) }'
}

# Processors, and changes of the shaders, round differently. A picture that one cannot tell from the one before stays as it was.
for picture in "$pictures"/*.png; do
    before=$scratch/before/$(basename "$picture")
    [ ! -f "$before" ] || ! is_alike "$picture" "$before" || cp "$before" "$picture"
done
