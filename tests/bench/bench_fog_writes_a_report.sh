#!/bin/sh
# ew-bench-fog writes a page with two tables, of each scene at either resolution: a time without, and five positive numbers. Behind a
# pane and among balls, where a source takes several legs, frames do take longer.
# Usage: bench_fog_writes_a_report.sh EW_BENCH_FOG
set -e
rm -rf bench_fog && mkdir bench_fog && cd bench_fog
"$1" --size 64x36 --report docs --name test
test "$(ls docs | tr '\n' ' ')" = 'fog-and-media-test.md '
awk -F'|' '
    /^\| `/ {
        rows[$2]++
        for (i = 3; i <= 8; i++) if (!($i + 0 > 0)) { print "FAILED: line " NR ": field " i " is no time: " $0; failed = 1 }
        for (i = 7; i <= 8; i++) sum[i] += $i
        count++
    }
    END {
        for (row in rows) if (rows[row] != 2) { print "FAILED:" row "has " rows[row] " rows"; failed = 1 }
        for (i = 7; i <= 8; i++) if (!(sum[i] > 1.3 * count)) { print "FAILED: field " i " costs next to nothing"; failed = 1 }
        if (count < 20) { print "FAILED: there are " count " rows"; failed = 1 }
        exit failed
    }' docs/fog-and-media-test.md
