package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.ablation.Findings.Saving;
import rigibo.lab.ablation.Findings.UseCost;
import rigibo.lab.child.Interval;
import rigibo.lab.report.Csv;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The findings as CSV, one line per comparison. */
final class FindingsCsv {

    private static final String HEAD =
            "table,scene,effect,users,first_ns,second_ns,figure,median,low,high,coverage,"
                    + "most_bytes_per_step,counts_equal,bits_equal";

    private FindingsCsv() {}

    static List<String> lines(Findings findings) {
        List<String> lines = new ArrayList<>(List.of(HEAD));
        findings.ablations().forEach(one -> lines.add(line(one)));
        findings.uses().forEach(use -> lines.add(line(use)));
        findings.savings().forEach(saving -> lines.add(line(saving)));
        return lines;
    }

    private static String line(Ablation one) {
        Pairs pairs = one.pairs();
        Object[] same = {pairs.haveEqualWork(), pairs.haveEqualBits()};
        return line("undeclared", one.scene(), "", "", pairs, "ratio", pairs.ratio(), same);
    }

    private static String line(UseCost use) {
        return cost("use", use.scene(), use.effect(), "" + use.users(), use.pairs());
    }

    private static String line(Saving saving) {
        return cost("left_out", saving.scene(), saving.effect(), "", saving.pairs());
    }

    /** Bits and work are not compared here, since bodies that use an effect move differently. */
    private static String cost(
            String table, String scene, String effect, String users, Pairs pairs) {
        Interval nanos = pairs.difference();
        return line(table, scene, effect, users, pairs, "difference_ns", nanos, "", "");
    }

    private static String line(
            String table,
            String scene,
            String effect,
            String users,
            Pairs pairs,
            String figure,
            Interval value,
            Object... same) {
        Object[] cells = {
            table,
            scene,
            effect,
            users,
            pairs.firstNanos(),
            pairs.secondNanos(),
            figure,
            value.median(),
            value.low(),
            value.high(),
            value.coverage(),
            pairs.mostBytes()
        };
        return Csv.line(Stream.concat(Stream.of(cells), Stream.of(same)).toArray());
    }
}
