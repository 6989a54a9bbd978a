# awk -v root=FOLDER [-v id=ID] -f apply.awk changes.tsv: finds each change's text in its file, whatever the white space in
# between, and says which rows are no good: a text that stands there not exactly once, or that would stay as it is.
# With an ID that row's change is written into the file.
BEGIN { FS = "\t" }

function without_blanks(text) {
    gsub(/[ \t]/, "", text)
    return text
}

function complain(what) {
    print "changes.tsv, row " $1 ": " what
    bad = 1
}

# Reads the file: its lines, where each begins in the text without blanks, and that text.
function read_source(path, text) {
    n_lines = 0
    squeezed = ""
    while ((getline text <path) > 0) {
        lines[++n_lines] = text
        begins[n_lines] = length(squeezed) + 1
        squeezed = squeezed without_blanks(text)
    }
    close(path)
    begins[n_lines + 1] = length(squeezed) + 1
}

# Position in lines[line] of the n-th character that is no blank.
function place_of(line, n, i) {
    for (i = 1; i <= length(lines[line]); ++i) {
        if (substr(lines[line], i, 1) !~ /[ \t]/ && --n == 0) {
            return i
        }
    }
    return i
}

function write_changed(path, first, n, i, from, to) {
    for (i = 1; i <= n_lines; ++i) {
        if (begins[i] <= first && first < begins[i + 1]) {
            from = i
        }
        if (begins[i] < first + n && first + n <= begins[i + 1]) {
            to = i
        }
    }
    for (i = 1; i < from; ++i) {
        print lines[i] >path
    }
    print substr(lines[from], 1, place_of(from, first - begins[from] + 1) - 1) $5 \
        substr(lines[to], place_of(to, first + n - begins[to]) + 1) >path
    for (i = to + 1; i <= n_lines; ++i) {
        print lines[i] >path
    }
    close(path)
}

FNR > 1 && (id == "" || $1 == id) {
    ++n_rows
    if (NF != 6 || seen[$1]++) {
        complain("must have six columns and an id of its own")
        next
    }
    path = root "/" $3
    read_source(path)
    wanted = without_blanks($4)
    first = wanted == "" ? 0 : index(squeezed, wanted)
    if (n_lines == 0) {
        complain($3 " is not there: strike the row, or name the file that its law moved to")
    } else if (first == 0) {
        complain($3 " has no \"" $4 "\": write both texts as the law is written now")
    } else if (index(substr(squeezed, first + 1), wanted) > 0) {
        complain($3 " has \"" $4 "\" more than once: take in more of what stands around it")
    } else if (without_blanks($5) == wanted) {
        complain("changes nothing")
    } else if (id != "") {
        write_changed(path, first, length(wanted))
    }
}

END {
    if (n_rows == 0) {
        print "changes.tsv has no row" (id == "" ? "" : " " id)
        bad = 1
    }
    exit bad
}
