#!/bin/sh
# The benchmark's peers integrate correctly: with more samples, each comes nearer to the truth, on every kind of source, with
# weights and behind opaque shapes. (How many samples are enough is what the benchmark measures.)
# Usage: bench_peers_converge.sh EW_BENCH SCENE...
bench=$1
shift
rm -rf bench_peers && mkdir bench_peers && cd bench_peers || exit 1
"$bench" "$@" --size 24x24 --integrators simpson:64,simpson:4096,marching:64,marching:4096,equiangular:64,equiangular:4096 \
    --repetitions 3 --error-samples 128 --csv table.csv || exit 1
sed 's/"[^"]*"/quoted/' table.csv | awk -F, '
    NR > 1 {
        split($2, name, ":")
        scenes[$1]; peers[name[1]]; error[$1, name[1], name[2]] = $8; rows++
    }
    END {
        for (scene in scenes)
            for (peer in peers) {
                few = error[scene, peer, 64]; many = error[scene, peer, 4096]
                if (many + 0 <= 0.05 && many <= few / 4) continue
                print "FAILED: " scene ": " peer " is wrong by " few " with 64 samples and by " many " with 4096"
                failed = 1
            }
        exit failed || rows == 0
    }'
