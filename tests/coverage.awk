# Reads the Cobertura reports of several test projects; prints a table of covered lines by product project and writes the lines that no test
# ran to artifacts/coverage/missed.txt. The lines of a file follow its <class> element, possibly twice (under the method, under the class).
match($0, /filename="[^"]*"/) {
    file = substr($0, RSTART + 10, RLENGTH - 11)
    sub(root, "", file)
    counts = file ~ /^src\/Engraver\.[A-Za-z]*\// && file !~ /\/obj\/|\.g\.cs$|\.axaml$/
}
counts && match($0, /<line number="[0-9]*" hits="[0-9]*"/) {
    split(substr($0, RSTART, RLENGTH), part, "\"")
    place = file ":" part[2]
    if (!(place in hits)) { hits[place] = 0; project = substr(file, 14); sub(/\/.*/, "", project); of[place] = project; lines[project]++ }
    if (part[4] > 0 && hits[place] == 0) { hits[place] = 1; run[project = of[place]]++ }
}
END {
    printf "%-20s %8s %8s %8s\n", "project", "lines", "run", "share"
    sorter = "sort"
    for (project in lines) printf "%-20s %8d %8d %7.1f %%\n", project, lines[project], run[project], 100 * run[project] / lines[project] | sorter
    close(sorter)
    sorter = "sort -t: -k1,1 -k2,2n >artifacts/coverage/missed.txt"
    for (place in hits) if (hits[place] == 0) print place | sorter
    close(sorter)
}
