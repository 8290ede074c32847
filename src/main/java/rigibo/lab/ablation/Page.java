package rigibo.lab.ablation;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.child.Interval;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Locale;

/** The findings as a page of Markdown. */
final class Page {

    private static final String MEASURED =
            """
            # What is not declared costs nothing

            A scene declares its effects, and the code of every effect is in classes of its own. \
            This page shows what effects cost in time. For undeclared effects a scene runs (a) \
            without their classes in the engine's archive and (b) with them. For declared ones a \
            scene that suits the effect declares it, and it is used by (c) no body, (d) one, (e) \
            half of them, (f) all. The last tables show what each scene would save without each of \
            its effects.

            Each run is a Java process of its own (`%s`). Runs come in pairs of alternating order \
            (a b, b a), so that a drift of the machine affects both. A process builds the scene, \
            warms up, and then times periods of %s. After each period the bodies are put back to \
            its start, so that they do not come to rest for good. The time of a run is the median \
            over its periods: the thread's processor time per step. Its bytes are those of the \
            period that allocated least, since all do the same work and the compiler may allocate \
            on that thread too. A comparison is the median ratio or difference of its pairs, %d \
            for a and b, %d for all others. Its interval of order statistics holds the true median \
            with a probability of at least %s %%, whatever the distribution (%s %% for the \
            others). Work and bits are compared after two periods, the same number of steps on \
            every machine.

            Made by `./rigibo lab --figures effects%s` on %s, %s.

            """;

    private final Findings findings;
    private final Provenance provenance;
    private final String method;
    private final MarkdownTables tables;
    private final List<String> lines = new ArrayList<>();

    Page(Findings findings, Provenance provenance, String method) {
        this.findings = findings;
        this.provenance = provenance;
        this.method = method;
        tables = new MarkdownTables(findings);
    }

    String text() {
        lines.clear();
        lines.addAll(Sentences.of(findings).stream().map(words -> "- " + words).toList());
        section("Undeclared effects", tables.ablation());
        lines.add("");
        findings.ablations().forEach(one -> lines.add("- " + one.scene() + ": " + one.words()));
        section("Work and columns", tables.work());
        addUses();
        addSavings();
        addPlans();
        return introduction() + String.join("\n", lines) + "\n";
    }

    private String introduction() {
        Ablation first = findings.ablations().get(0);
        Interval ratio = first.pairs().ratio();
        Interval cost = findings.savings().get(0).percent();
        return String.format(
                Locale.ROOT,
                MEASURED,
                method,
                periods(),
                first.pairs().first().size(),
                findings.savings().get(0).pairs().first().size(),
                Amount.percent(100 * ratio.coverage()),
                Amount.percent(100 * cost.coverage()),
                provenance.options(),
                provenance.machine(),
                provenance.date());
    }

    /** The lengths of the shortest and the longest period. */
    private String periods() {
        IntSummaryStatistics steps =
                findings.ablations().stream().mapToInt(Ablation::period).summaryStatistics();
        return steps.getMin() == steps.getMax()
                ? steps.getMin() + " steps"
                : steps.getMin() + " to " + steps.getMax() + " steps";
    }

    private void section(String title, List<String> table) {
        lines.add("");
        lines.add("## " + title);
        lines.add("");
        lines.addAll(table);
    }

    private void addUses() {
        if (findings.uses().isEmpty()) {
            return;
        }
        section("What a declared effect costs, by how many use it", tables.uses());
        lines.add("");
        lines.add(
                "Columns c to f give the extra time per step, compared with the same bodies where"
                        + " the effect is not declared. Per user: (f − c) divided by the number of"
                        + " users. Half/all: (e − c)/(f − c), 0.5 if the cost is proportional to"
                        + " the users. Both are given only where the intervals of c and f do not"
                        + " overlap.");
    }

    private void addSavings() {
        section("What each scene would save", List.of());
        for (Ablation one : findings.ablations()) {
            lines.add("### " + one.scene());
            lines.add("");
            lines.addAll(tables.savings(one.scene()));
            lines.add("");
        }
    }

    private void addPlans() {
        lines.add("## What the demos run");
        for (String demo : provenance.demos().keySet()) {
            lines.add("");
            lines.add("### " + demo);
            lines.add("");
            lines.add("```");
            lines.addAll(plan(provenance.demos().get(demo)));
            lines.add("```");
        }
    }

    private static List<String> plan(Effects effects) {
        return new Pool(effects, Accuracy.GAME).plan().lines().toList();
    }
}
