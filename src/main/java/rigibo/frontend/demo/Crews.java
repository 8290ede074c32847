package rigibo.frontend.demo;

import rigibo.backend.StepReport;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Choice;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Widget;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;

/**
 * The switch for the number of workers, and its result: the figures of one worker beside those of
 * the number chosen last.
 */
final class Crews {

    private static final int MOST_WORKERS = 8;
    private static final String NOT_MEASURED = "–";

    private final Words words;
    private final int most;
    private final Crew alone = new Crew(1);

    /** The last choice of more than one worker, or null. */
    private Crew several;

    private Crew chosen = alone;

    /** The crews whose greatest number of bodies is still to be found, the present one first. */
    private final Queue<Crew> searching = new ArrayDeque<>();

    /** A switch up to the number of processors. */
    Crews(Words words, int processors) {
        this.words = words;
        most = Math.min(MOST_WORKERS, processors);
    }

    /** The switch; on one processor there is nothing to choose. */
    Widget choice() {
        return most == 1
                ? new Readout(words.of("flood.workers"), () -> words.of("flood.one-processor"))
                : new Choice(
                        words,
                        "flood.workers",
                        IntStream.rangeClosed(1, most).mapToObj(Integer::toString).toList(),
                        () -> chosen.workers - 1,
                        index -> choose(index + 1));
    }

    /** Figures of a crew chosen again are measured again, since the scene has gone on. */
    private void choose(int workers) {
        searching.clear();
        if (workers > 1 && (several == null || several.workers != workers)) {
            several = new Crew(workers);
        }
        chosen = workers == 1 ? alone : several;
        chosen.times.forget();
    }

    /** The crew that makes the next step. */
    Crew present() {
        return isSearching() ? searching.element() : chosen;
    }

    boolean isSearching() {
        return !searching.isEmpty();
    }

    /** Begins the search for the most bodies, by one worker first and then by those chosen. */
    void search() {
        searching.clear();
        searching.add(alone);
        if (chosen != alone) {
            searching.add(chosen);
        }
        searching.forEach(Crew::beginSearch);
    }

    /**
     * Takes in a step with a number of bodies; returns whether the next crew begins its search.
     *
     * @param isFull whether no more bodies can be poured
     */
    boolean goesOnWithTheNext(StepReport report, int bodies, boolean isFull) {
        if (!isSearching()) {
            chosen.times.step(report);
            return false;
        }
        if (present().goesOn(report, bodies) && !isFull) {
            return false;
        }
        searching.remove();
        return isSearching();
    }

    /** Whom the columns of figures are of. */
    String numbers() {
        return columns(crew -> "" + crew.workers);
    }

    /**
     * Median times of steps, ms. Figures measured with another number of bodies are not shown,
     * since they would mislead beside the present one.
     */
    String medians() {
        return columns(
                crew ->
                        crew.times.isMeasured() && crew.times.isAsLoadedAs(present().times)
                                ? digits(crew.times.step(50))
                                : NOT_MEASURED);
    }

    /** The times that one step in twenty, and one in a hundred, of the present crew exceeds. */
    String lateSteps() {
        FrameTimes times = present().times;
        return String.format("%s %4s", digits(times.step(95)), digits(times.step(99)));
    }

    /** Three digits, so that two times have room beside each other. */
    private String digits(double millis) {
        int decimals = millis < 10 ? 2 : millis < 100 ? 1 : 0;
        return words.number("%." + decimals + "f", millis);
    }

    /** Numbers of bodies; that of a search that goes on ends in dots. */
    String held(ToIntFunction<Crew> bodies) {
        return columns(
                crew -> {
                    int most = bodies.applyAsInt(crew);
                    String dots = isSearching() && crew == present() ? "…" : "";
                    String none = crew.isSearched() ? words.of("flood.none") : NOT_MEASURED;
                    return most == 0 ? none : most + dots;
                });
    }

    private String columns(Function<Crew, String> figure) {
        return several == null
                ? figure.apply(alone)
                : String.format("%s %4s", figure.apply(alone), figure.apply(several));
    }
}
