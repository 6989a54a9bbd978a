# awk -v seed=N -v rows=N -f draw.awk FILE…: draws changes from the laws in C++ sources; draw.sh calls it.
BEGIN {
    # What else a line may be than arithmetic: text for people, a compile-time constant, a size of memory, a sentinel, a loop's
    # head, words of a matrix library that another way to write the law would not have.
    no_law = "[\"]|assert|(^|[^a-z_])for [(]|^ *(template|using|case|typedef|friend)|operator|nullptr|[.>]r?c?end[(]|npos"
    no_law = no_law "|constexpr .*k[A-Z]|array<|sizeof|_bytes[(]|prefetch|reserve[(]|printf|<<|>>"
    no_law = no_law "|Eigen|transpose|array[(]|cwise|block|segment|head<|tail<|Corner|[.]col[(]|[.]row[(]|[.]sum[(]"
    no_law = no_law "|asDiagonal|noalias|eval[(]|emplate |Constant[(]|Zero[(]|Vector3[(]|stableNorm"
    operand = "[A-Za-z_][A-Za-z0-9_.]*|[0-9]+[.]?[0-9]*"
}

function without_blanks(text) {
    gsub(/[ \t]/, "", text)
    return text
}

# Park and Miller's generator, the same with any awk: a whole number from 1 to n.
function one_of(n) {
    seed = (16807 * seed) % 2147483647
    return int(seed / 2147483647 * n) + 1
}

# The line with texts and comments blotted out, every character in its place.
function masked(line, i, c, quote, out) {
    out = ""
    quote = ""
    for (i = 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        if (in_comment) {
            if (substr(line, i, 2) == "*/") {
                in_comment = 0
                out = out "\001"
                ++i
            }
            c = "\001"
        } else if (quote != "") {
            if (c == "\\") {
                out = out "\001"
                ++i
                c = "\001"
            } else if (c == quote) {
                quote = ""
            } else {
                c = "\001"
            }
        } else if (substr(line, i, 2) == "//") {
            break
        } else if (substr(line, i, 2) == "/*") {
            in_comment = 1
            c = "\001"
        } else if (c == "\"" || (c == "'" && substr(line, i - 1, 1) !~ /[0-9A-Za-z]/)) {
            quote = c
        }
        out = out c
    }
    return out
}

# A change of the line: n characters from `at` become `new`.
function offer(kind, at, n, new) {
    n_offered[FILENAME]++
    offered[FILENAME, n_offered[FILENAME]] = kind "\t" text "\t" substr(text, 1, at - 1) new substr(text, at + n)
}

# Each place of `old` in the code between two operands.
function swap(kind, old, new, from, at) {
    from = 1
    while ((at = index(substr(code, from), old)) > 0) {
        at += from - 1
        if (old ~ /^[a-z]/ || (substr(code, at - 1, 1) ~ /[A-Za-z0-9_)\]]/ && substr(code, at + length(old), 1) ~ /^[A-Za-z0-9_(.!-]?$/)) {
            offer(kind, at, length(old), new)
        }
        from = at + length(old)
    }
}

# Each place where `sign` and an operand that is one name or number may be left out, for what follows binds no closer.
function drop(kind, sign, closer, from, at, rest, after) {
    from = 1
    while ((at = index(substr(code, from), " " sign " ")) > 0) {
        at += from - 1
        from = at + 3
        rest = substr(code, from)
        if (substr(code, at - 1, 1) ~ /[A-Za-z0-9_)\]]/ && match(rest, "^(" operand ")")) {
            after = substr(rest, RLENGTH + 1)
            if (after !~ /^[(\[{<:>'A-Za-z0-9_-]/ && after !~ closer) {
                offer(kind, at, 3 + RLENGTH, "")
            }
        }
    }
}

# Each place after `before` where a minus is taken away from an operand, or put before a number other than 0. What a name
# begins with is a setting, no law.
function turn_constant(before, from, at, rest) {
    from = 1
    while ((at = index(substr(code, from), before)) > 0) {
        from += at - 1 + length(before)
        rest = substr(code, from)
        if (before == "= " && rest ~ /^-?[0-9][0-9.e-]*[,;)]/) {
            continue
        }
        if (rest ~ /^-[A-Za-z0-9_(.]/) {
            offer("constant", from, 1, "")
        } else if (match(rest, /^[0-9]+[.][0-9]+/) && substr(rest, 1, RLENGTH) + 0 != 0) {
            offer("constant", from, 0, "-")
        }
    }
}

FNR == 1 {
    n_files++
    in_comment = 0
    in_assert = 0
    files[n_files] = FILENAME
    split(FILENAME, parts, "/")
    room = parts[1] "/" (parts[2] ~ /[.]/ ? "" : parts[2])
    if (!(room in n_in_room)) {
        rooms[++n_rooms] = room
    }
    in_room[room, ++n_in_room[room]] = FILENAME
    all[FILENAME] = ""
}

{
    code = masked($0)
    text = $0
    all[FILENAME] = all[FILENAME] without_blanks($0)
    sub(/[ \t]*$/, "", code)
    indent = match(code, /[^ \t]/) ? RSTART : 1
    code = substr(code, indent)
    text = substr(text, indent, length(code))
    if (code ~ /(^|[^A-Za-z_])(static_)?assert[(]/) {
        in_assert = 1
    }
    is_law = !(in_assert || code == "" || code ~ /^#/ || text ~ no_law || index(code, "\001"))
    if (code ~ /;$/) {
        in_assert = 0
    }
    if (!is_law) {
        next
    }
    swap("sign", " + ", " - ")
    swap("sign", " - ", " + ")
    swap("sign", " += ", " -= ")
    swap("sign", " -= ", " += ")
    swap("comparison", " < ", " > ")
    swap("comparison", " > ", " < ")
    swap("comparison", " <= ", " >= ")
    swap("comparison", " >= ", " <= ")
    swap("comparison", " == ", " != ")
    swap("comparison", " != ", " == ")
    drop("term", "+", "^ [*/%]")
    drop("term", "-", "^ [*/%]")
    drop("factor", "*", "^$a")
    drop("factor", "/", "^$a")
    swap("function", "std::sin(", "std::cos(")
    swap("function", "std::cos(", "std::sin(")
    swap("function", "std::min(", "std::max(")
    swap("function", "std::max(", "std::min(")
    turn_constant("= ")
    turn_constant("return ")
    turn_constant("(")
    turn_constant(", ")
    turn_constant("? ")
    turn_constant(" : ")
    turn_constant(" * ")
}

# Whether the offer may still be drawn: its line stands once in the file, and no row has it.
function is_free(file, offer_text, parts, line, first) {
    split(offer_text, parts, "\t")
    line = without_blanks(parts[2])
    if ((file, line) in taken) {
        return 0
    }
    first = index(all[file], line)
    return index(substr(all[file], first + 1), line) == 0
}

# draw_from FILE: one row, its kind drawn first, so that the commonest kind is not all there is; 0 where nothing is left.
function draw_from(file, i, k, n, kinds, n_kinds, of_kind, parts) {
    split("", of_kind)
    n_kinds = 0
    for (i = 1; i <= n_offered[file]; ++i) {
        if (is_free(file, offered[file, i])) {
            split(offered[file, i], parts, "\t")
            if (!((parts[1], 0) in of_kind)) {
                kinds[++n_kinds] = parts[1]
                of_kind[parts[1], 0] = 0
            }
            of_kind[parts[1], ++of_kind[parts[1], 0]] = i
        }
    }
    if (n_kinds == 0) {
        return 0
    }
    k = kinds[one_of(n_kinds)]
    i = of_kind[k, one_of(of_kind[k, 0])]
    split(offered[file, i], parts, "\t")
    taken[file, without_blanks(parts[2])] = 1
    printf "%03d\t%s\t%s\t%s\t%s\t\n", ++n_rows, parts[1], file, parts[2], parts[3]
    return 1
}

# draw_in ROOM: from a file that was drawn least, the one with more laws the likelier; two rows from one at most.
function draw_in(room, least, i, n, at, file, left) {
    for (least = 0; least < 2; ++least) {
        n = 0
        for (i = 1; i <= n_in_room[room]; ++i) {
            file = in_room[room, i]
            left[i] = n_drawn[file] == least ? n_offered[file] + 0 : 0
            n += left[i]
        }
        while (n > 0) {
            at = one_of(n)
            for (i = 1; at > left[i]; ++i) {
                at -= left[i]
            }
            n -= left[i]
            left[i] = 0
            if (draw_from(in_room[room, i])) {
                ++n_drawn[in_room[room, i]]
                return
            }
        }
    }
}

END {
    for (i = 0; i < 10; ++i) {
        one_of(1)
    }
    print "id\tkind\tfile\ttext\tchanged\tequivalent"
    for (file in all) {
        n_drawn[file] += 0
    }
    # One from each room in turn.
    for (turn = 1; n_rows < rows; ++turn) {
        before = n_rows
        for (r = 1; r <= n_rooms && n_rows < rows; ++r) {
            draw_in(rooms[r])
        }
        if (n_rows == before) {
            break
        }
    }
}
