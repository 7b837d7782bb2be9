# Reads the paths of files and prints each arrow that `table` forbids: see arrows.sh.

# The line without comments and strings, which name what they do not call. What a comment leaves open is kept for the next line.
function code_of(line,    start, end)
{
    if (in_comment) {
        end = index(line, "*/")
        if (!end) return ""
        line = substr(line, end + 2)
        in_comment = 0
    }
    gsub(/\\./, "", line)
    gsub(/"[^"]*"/, "\"\"", line)
    while ((start = index(line, "/*")) > 0) {
        end = index(substr(line, start + 2), "*/")
        if (!end) {
            in_comment = 1
            return substr(line, 1, start - 1)
        }
        line = substr(line, 1, start - 1) " " substr(line, start + end + 3)
    }
    sub(/\/\/.*/, "", line)
    return line
}

function folder_of(path)
{
    return match(path, /.*\//) ? substr(path, 1, RLENGTH) : ""
}

# path with each FOLDER/../ taken out.
function without_detours(path)
{
    while (match(path, /[^\/.]+\/\.\.\//)) path = substr(path, 1, RSTART - 1) substr(path, RSTART + RLENGTH)
    return path
}

# Remembers what a line includes, and by which names it calls or declares functions. A function is declared in column 0.
function read_line(file, line,    code, name, is_outside)
{
    if (line ~ /^[ \t]*#[ \t]*include[ \t]*[<"]/ && !in_comment) {
        match(line, /[<"].*[>"]/)
        includes[file] = includes[file] substr(line, RSTART, RLENGTH) " "
        return
    }
    code = code_of(line)
    if (code ~ /^[ \t]*#/) return
    is_outside = code ~ /^[A-Za-z_]/
    while (match(code, /[A-Za-z_][A-Za-z_0-9]*[ ]*\(/)) {
        name = substr(code, RSTART, RLENGTH - 1)
        sub(/ +$/, "", name)
        if (name == "void" || name == "sizeof") name = "" # a pointer to a function, or a size in a static assertion
        if (!is_outside)
            calls[file] = calls[file] name " "
        else if (substr(code, RSTART + RLENGTH, 1) != "*") { # else the type of a pointer to a function
            own[file, name] = 1
            if (file ~ /[.]h$/) in_header[name] = 1
            if (code !~ /^static / || file ~ /[.]h$/) declares[file] = declares[file] name " "
        }
        code = substr(code, RSTART + RLENGTH)
    }
}

function read_file(file,    line)
{
    in_comment = 0
    while ((getline line < file) > 0) read_line(file, line)
    close(file)
}

# The path of what `file` includes: from its own folder, or from the nearest one of the repository.
function resolve(file, included,    path, i, found)
{
    if (included ~ /^</) return included
    included = substr(included, 2, length(included) - 2)
    path = without_detours(folder_of(file) included)
    if (path in is_file) return path
    for (i = 1; i <= file_count; i++) {
        path = files[i]
        if (path != included && substr(path, length(path) - length(included)) != "/" included) continue
        if (substr(path, 1, index(path, "/")) == substr(file, 1, index(file, "/"))) return path
        if (!found) found = path
    }
    return found ? found : included
}

function complain(file, what, reason)
{
    printf "%s %s: %s\n", file, what, reason
    wrong = 1
}

function check_includes(file, forbidden, reason,    list, count, i, path)
{
    count = split(includes[file], list, " ")
    for (i = 1; i <= count; i++) {
        path = resolve(file, list[i])
        if (path != file && path ~ forbidden) complain(file, "includes " path, reason)
    }
}

function check_calls(file, forbidden, reason,    list, count, i, seen, path)
{
    count = split(calls[file], list, " ")
    for (i = 1; i <= count; i++) {
        path = place_of[list[i]]
        if (!path || (file, list[i]) in own || list[i] in seen) continue
        seen[list[i]] = 1
        complain(file, "calls " list[i] " of " path, reason)
    }
}

# The functions of the forbidden part that a header declares, its own or another one, but for the public ones and those of which
# another part has its own.
function collect_names(forbidden,    i, j, list, count, is_forbidden)
{
    split("", place_of)
    for (is_forbidden = 1; is_forbidden >= 0; is_forbidden--)
        for (i = 1; i <= file_count; i++) {
            if ((files[i] ~ forbidden) != is_forbidden || (!is_forbidden && files[i] ~ /[.]h$/)) continue
            count = split(declares[files[i]], list, " ")
            for (j = 1; j <= count; j++)
                place_of[list[j]] = is_forbidden && list[j] in in_header && !(("src/energywave.h", list[j]) in own) ? files[i] : ""
        }
}

function check_rule(from, forbidden, reason,    i)
{
    collect_names(forbidden)
    for (i = 1; i <= file_count; i++) {
        if (files[i] !~ from) continue
        check_includes(files[i], forbidden, reason)
        check_calls(files[i], forbidden, reason)
    }
}

function check_row(row,    column, reason, count, i, j, kind, from, forbidden)
{
    split(row, column, " ")
    reason = row
    sub(/^[^ ]+ +[^ ]+ +/, "", reason)
    if (row !~ /KIND/) {
        check_rule(column[1], column[2], reason)
        return
    }
    count = split(kinds, kind, " ")
    for (i = 1; i <= count; i++)
        for (j = 1; j <= count; j++) {
            if (i == j) continue
            from = column[1]
            forbidden = column[2]
            sub(/KIND/, kind[i], from)
            sub(/OTHER/, kind[j], forbidden)
            check_rule(from, forbidden, reason)
        }
}

{
    files[++file_count] = $0
    is_file[$0] = 1
    read_file($0)
}

END {
    row_count = split(table, rows, "\n")
    for (i = 1; i <= row_count; i++)
        if (rows[i] != "") check_row(rows[i])
    exit wrong
}
