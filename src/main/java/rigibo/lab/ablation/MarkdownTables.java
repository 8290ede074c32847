package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.ablation.Findings.Saving;
import rigibo.lab.ablation.Findings.UseCost;
import rigibo.lab.ablation.probe.Share;
import rigibo.lab.child.Interval;
import rigibo.lab.child.Work;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The findings as tables of Markdown. */
final class MarkdownTables {

    private static final String NOT_MEASURED = "–";

    private final Findings findings;

    MarkdownTables(Findings findings) {
        this.findings = findings;
    }

    private static String row(Object... cells) {
        return Stream.of(cells).map(String::valueOf).collect(Collectors.joining(" | ", "| ", " |"));
    }

    /** A row for each scene, with and without the classes of undeclared effects. */
    List<String> ablation() {
        List<String> lines = new ArrayList<>();
        lines.add(
                "| scene | classes taken out | a, without them | b, with them | b/a | interval"
                        + " | | bytes per step | work equal | bits equal |");
        lines.add("|---|---:|---:|---:|---:|---|---|---:|---|---|");
        findings.ablations().forEach(one -> lines.add(row(one)));
        return lines;
    }

    private static String row(Ablation one) {
        Pairs pairs = one.pairs();
        Interval ratio = pairs.ratio();
        return row(
                one.scene(),
                one.takenOut(),
                Amount.time(pairs.firstNanos()),
                Amount.time(pairs.secondNanos()),
                Amount.ratio(ratio.median()),
                Amount.ratio(ratio.low()) + " to " + Amount.ratio(ratio.high()),
                one.verdict(),
                Amount.digits(pairs.mostBytes()),
                words(pairs.haveEqualWork()),
                words(pairs.haveEqualBits()));
    }

    private static String words(boolean isSo) {
        return isSo ? "yes" : "**no**";
    }

    /** A row for each scene: its counted work, and the sizes of a body and a contact. */
    List<String> work() {
        List<String> lines = new ArrayList<>();
        lines.add(
                "| scene | effects' columns, bits per body | pairs | contacts | impacts |"
                        + " evaluations | rows | rows per contact |");
        lines.add("|---|---:|---:|---:|---:|---:|---:|---:|");
        findings.ablations().forEach(one -> lines.add(workRow(one)));
        return lines;
    }

    private static String workRow(Ablation one) {
        Work work = one.sample().work();
        return row(
                one.scene(),
                one.sample().bitsPerBody(),
                work.pairs(),
                work.contacts(),
                work.impacts(),
                work.evaluations(),
                work.rows(),
                Amount.digits(work.contacts() == 0 ? 0 : (double) work.rows() / work.contacts()));
    }

    /** A row for each effect: its cost if no body, one, half of them or all use it. */
    List<String> uses() {
        List<String> lines = new ArrayList<>();
        lines.add(
                "| effect | scene | a body uses it when | undeclared | c, none | d, one | e, half |"
                        + " f, all | per user | half/all | bits per body |");
        lines.add("|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|");
        findings.effects().forEach(effect -> lines.add(useRow(findings.usesOf(effect))));
        return lines;
    }

    private static String useRow(List<UseCost> uses) {
        UseCost none = uses.get(0);
        UseCost all = uses.get(uses.size() - 1);
        return row(
                none.effect(),
                none.sceneWords(),
                none.words(),
                Amount.time(none.pairs().firstNanos()),
                cost(uses, Share.NONE),
                cost(uses, Share.ONE),
                cost(uses, Share.HALF),
                cost(uses, Share.ALL),
                perUser(uses),
                halfOverAll(uses),
                all.pairs().addedBits());
    }

    private static Optional<UseCost> of(List<UseCost> uses, Share share) {
        return uses.stream().filter(use -> use.share() == share).findFirst();
    }

    private static String cost(List<UseCost> uses, Share share) {
        return of(uses, share)
                .map(use -> Amount.signedTime(use.pairs().difference().median()))
                .orElse(NOT_MEASURED);
    }

    /** Whether the cost of using an effect can be distinguished from that of declaring it. */
    private static boolean isSeen(List<UseCost> uses) {
        Interval none = of(uses, Share.NONE).orElseThrow().pairs().difference();
        Interval all = of(uses, Share.ALL).orElseThrow().pairs().difference();
        boolean isApart = none.high() < all.low() || all.high() < none.low();
        return isApart && none.coverage() >= Findings.LEAST_COVERAGE;
    }

    private static double ofUse(List<UseCost> uses, Share share) {
        return of(uses, share).orElseThrow().pairs().difference().median()
                - of(uses, Share.NONE).orElseThrow().pairs().difference().median();
    }

    private static String perUser(List<UseCost> uses) {
        int users = of(uses, Share.ALL).orElseThrow().users();
        return isSeen(uses) ? Amount.signedTime(ofUse(uses, Share.ALL) / users) : NOT_MEASURED;
    }

    private static String halfOverAll(List<UseCost> uses) {
        boolean isKnown = isSeen(uses) && of(uses, Share.HALF).isPresent();
        return isKnown
                ? Amount.digits(ofUse(uses, Share.HALF) / ofUse(uses, Share.ALL))
                : NOT_MEASURED;
    }

    /** A row for each effect of a scene: the time saved without it. */
    List<String> savings(String scene) {
        List<String> lines = new ArrayList<>();
        lines.add("| without | saves per step | interval | saves % | interval, % |");
        lines.add("|---|---:|---|---:|---|");
        findings.savingsOf(scene).forEach(saving -> lines.add(row(saving)));
        return lines;
    }

    private static String row(Saving saving) {
        Interval nanos = saving.pairs().difference();
        Interval percent = saving.percent();
        return row(
                String.join(", ", leftOut(saving)),
                Amount.time(nanos.median()),
                Amount.times(nanos.low(), nanos.high()),
                Amount.percent(percent.median()),
                Amount.percent(percent.low()) + " to " + Amount.percent(percent.high()));
    }

    /** An effect and those left out with it. */
    static List<String> leftOut(Saving saving) {
        return Stream.concat(Stream.of(saving.effect()), saving.companions().stream()).toList();
    }
}
