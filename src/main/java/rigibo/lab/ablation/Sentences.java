package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.ablation.Findings.Saving;
import rigibo.lab.ablation.Findings.Verdict;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/** The main findings in sentences. */
final class Sentences {

    private Sentences() {}

    static List<String> of(Findings findings) {
        List<String> sentences = new ArrayList<>();
        sentences.add(ratios(findings));
        sentences.add(sameness(findings));
        sentences.add(bytes(findings));
        findings.savings().stream()
                .max(Comparator.comparingDouble(saving -> saving.percent().median()))
                .ifPresent(saving -> sentences.add(greatest(saving)));
        return sentences;
    }

    private static String ratios(Findings findings) {
        List<Ablation> scenes = findings.ablations();
        long equal = count(scenes, one -> one.verdict() == Verdict.EQUAL);
        long different = count(scenes, one -> one.verdict() == Verdict.DIFFERENT);
        return String.format(
                "The time with the classes of undeclared effects, divided by that without them: in"
                        + " %d of %d scenes its whole interval is within %.0f %% of 1; in %d its"
                        + " interval excludes 1.",
                equal, scenes.size(), 100 * Findings.TOLERANCE, different);
    }

    private static String sameness(Findings findings) {
        List<Ablation> scenes = findings.ablations();
        return String.format(
                "Bits and work are the same in every run, with and without the classes, in %d of %d"
                        + " scenes.",
                count(scenes, Ablation::isSame), scenes.size());
    }

    private static String bytes(Findings findings) {
        double most =
                findings.ablations().stream()
                        .mapToDouble(one -> one.pairs().mostBytes())
                        .max()
                        .orElse(0);
        return "The most that a warm step allocated is " + Amount.digits(most) + " bytes.";
    }

    private static String greatest(Saving saving) {
        return String.format(
                "The most that leaving out an effect saves is %s %%: %s, without %s.",
                Amount.percent(saving.percent().median()),
                saving.scene(),
                String.join(", ", MarkdownTables.leftOut(saving)));
    }

    private static long count(List<Ablation> scenes, Predicate<Ablation> which) {
        return scenes.stream().filter(which).count();
    }
}
