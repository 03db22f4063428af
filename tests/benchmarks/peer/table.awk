# results.csv -> the table: median and best of the repeats, and LAMMPS' median
# over ours. Also a file of the medians for the plot
BEGIN { FS = "," }
NR == 1 || $1 == "cloud" || $1 == "check" { next }
{
    row = $1 "," $3 "," $4 "," $2 "," $5
    if (!(row in count)) order[++rows] = row
    time[row, ++count[row]] = $7
    rebuilds[row] = $8; listed[row] = $9; bytes[row] = $10
}
END {
    for (r = 1; r <= rows; ++r) sortTimes(order[r])

    print "\nns per platelet and step, median and best; lists `moved`: made anew when platelets"
    print "have moved far enough; `every20`: every 20 steps, skin 0.3 d, in both. listed:"
    print "neighbours that are looked at for a platelet (ours: lanes of vectors)\n"
    printf "%8s %-8s %5s  %-10s %-8s %8s %8s %8s %7s %9s %s\n", "N", "lists", "ranks",
        "program", "instr.", "median", "best", "rebuilds", "listed", "B/plate", "LAMMPS/it"
    for (r = 1; r <= rows; ++r) {
        row = order[r]
        split(row, is, ",")
        peer = is[1] "," is[2] "," is[3] ",LAMMPS,-"
        printf "%8d %-8s %5d  %-10s %-8s %8.1f %8.1f %8d %7.1f %9s %8.2f\n", is[2], is[1],
            is[3], is[4], is[5], median(row), time[row, 1], rebuilds[row], listed[row],
            bytes[row] == "" ? "-" : bytes[row], median(peer)/median(row)
        print is[1] "," is[4] "," is[2] "," is[3] "," is[5] "," median(row) > medians
        cost[is[1], is[2], is[3], is[4], is[5]] = median(row)
    }
    for (r = 1; r <= rows; ++r) {
        split(order[r], is, ",")
        if (is[2] == 1000000 && (is[1], 100000, is[3], is[4], is[5]) in cost)
            printf "%s %s, %d ranks: a platelet and step at 1000000 costs %.2f times that at 100000\n",
                is[4], is[5], is[3], cost[is[1], 1000000, is[3], is[4], is[5]] \
                    /cost[is[1], 100000, is[3], is[4], is[5]]
    }
}
function sortTimes(row,    i, j, t) {
    for (i = 2; i <= count[row]; ++i) {
        t = time[row, i]
        for (j = i - 1; j > 0 && time[row, j] > t; --j) time[row, j + 1] = time[row, j]
        time[row, j + 1] = t
    }
}
function median(row,    m) {
    m = count[row]
    return m % 2 ? time[row, (m + 1)/2] : (time[row, m/2] + time[row, m/2 + 1])/2
}
