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

            A scene declares its effects. Every effect's code sits in classes of its own, and this \
            page shows what they cost: (a) with the classes of all undeclared effects taken out of \
            the engine's archive, (b) with all of them there; then, in a scene that suits each \
            effect, (c) declared and used by no body, (d) used by one, (e) by half, (f) by all; \
            and what each scene would save without each of its effects.

            Every figure is the median of runs in a Java process of their own (`%s`), made in \
            pairs whose order changes (a b, b a) so that what drifts on the machine falls on both. \
            A process builds the scene, runs it warm, and then times periods of %s: after each the \
            bodies are put back where the period began, so that they never come to rest for good. \
            Of the periods' times per step, of the processor time that the thread used, it tells the \
            median; of their bytes the least, for all do the same, and what comes on top in some \
            is what the compiler allocates on the thread it holds up. A comparison is the median \
            of the ratios or differences of its pairs, %d for a and b, %d for everything else, \
            with the interval of order statistics that holds the true median with %s %% at least, \
            whatever the distribution (%s %% for the shorter comparisons). Work and bits are \
            compared after two periods, the same number of steps on every machine.

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
                "c to f are ns per step more than the same bodies cost where the effect is not"
                        + " declared. Per user: (f − c) by the number of users; half/all: (e − c)"
                        + " over (f − c), 0.5 where the cost is proportional to the users; both"
                        + " only where c and f are told apart.");
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
