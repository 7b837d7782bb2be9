#!/bin/sh
# Prints the names of a folder's files, sorted; of files with the same content one will do.
# Usage: distinct_files.sh FOLDER
find "$1" -type f | sort | xargs md5sum | sort -u -k1,1 | sed 's/^[^ ]* *//' | sort
