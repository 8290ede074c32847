package rigibo.lab.bench.query;

import rigibo.lab.bench.moving.Contestant;
import rigibo.lab.report.Amount;
import rigibo.lab.report.Report;
import rigibo.lab.report.Table;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The report about queries, for a terminal and for a page. */
final class QueryReport {

    /** Least time of the fastest peer, in times of ours. */
    private static final double FASTER = 2;

    /** The most that sensors may add to a step, ns. */
    private static final double MOST_SENSING = 0.3e6;

    /** The allowed difference of mean paths: engines in floats miss some rims. */
    private static final double SAME = 1e-3;

    private final Map<Contestant, Answers> found;

    QueryReport(Map<Contestant, Answers> found) {
        this.found = found;
    }

    Report report() {
        return Report.of(table(), sentences());
    }

    private Table table() {
        List<String> head = new ArrayList<>(List.of("engine"));
        for (Rays kind : Rays.values()) {
            head.add(kind.words + " ray");
        }
        head.add("mean way of random rays");
        return new Table(
                head, found.entrySet().stream().map(e -> row(e.getKey(), e.getValue())).toList());
    }

    private static List<String> row(Contestant contestant, Answers answers) {
        List<String> cells = new ArrayList<>(List.of(contestant.engine()));
        for (Rays kind : Rays.values()) {
            cells.add(Amount.time(answers.nanos()[kind.ordinal()]));
        }
        cells.add(Amount.percent(100 * answers.met()[Rays.RANDOM.ordinal()]) + " %");
        return cells;
    }

    private List<String> sentences() {
        List<String> sentences = new ArrayList<>();
        Optional<Answers> ours = of(true);
        Optional<Answers> peer = of(false);
        if (ours.isPresent() && peer.isPresent()) {
            for (Rays kind : Rays.values()) {
                sentences.add(compare(kind, ours.get(), peer.get()));
            }
        }
        ours.ifPresent(our -> sentences.add(sensing(our.sensing())));
        return sentences;
    }

    private Optional<Answers> of(boolean isOurs) {
        return found.entrySet().stream()
                .filter(entry -> entry.getKey().isOurs() == isOurs)
                .map(Map.Entry::getValue)
                .findFirst();
    }

    private static String compare(Rays kind, Answers ours, Answers peer) {
        int i = kind.ordinal();
        double ratio = peer.nanos()[i] / ours.nanos()[i];
        boolean isSame = Math.abs(peer.met()[i] / ours.met()[i] - 1) <= SAME;
        return "A "
                + kind.words
                + " ray takes gdx-box2d "
                + Amount.digits(ratio)
                + " × as long as ours (≥ "
                + (int) FASTER
                + met(ratio >= FASTER)
                + ", and goes "
                + (isSame ? "as far." : "another way.");
    }

    private static String sensing(double nanos) {
        return QueryProbe.SENSORS
                + " sensors among "
                + QueryProbe.VISITORS
                + " bodies add "
                + Amount.time(nanos)
                + " to a step (≤ "
                + Amount.time(MOST_SENSING)
                + met(nanos <= MOST_SENSING)
                + ".";
    }

    private static String met(boolean isMet) {
        return isMet ? ": met)" : ": not met)";
    }
}
