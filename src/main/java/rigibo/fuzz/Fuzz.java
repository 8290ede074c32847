package rigibo.fuzz;

import rigibo.fuzz.judge.Tally;
import rigibo.fuzz.judge.Watch;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Tries random programs and mutated files. */
public final class Fuzz {

    /** The part of the project that is tried. */
    public enum Only {
        ENGINE,
        FILES,
        BOTH,
        /** One pool for as long as it lasts. */
        SOAK
    }

    private final Tally tally = new Tally();
    private final Watch watch = new Watch();
    private final Only only;
    private final Path wrong;

    /**
     * A fuzzer.
     *
     * @param only which part is tried
     * @param wrong the folder where files that go wrong are kept
     */
    public Fuzz(Only only, Path wrong) {
        this.only = only;
        this.wrong = wrong;
    }

    /** The counts of what was tried so far. */
    public Tally tally() {
        return tally;
    }

    /**
     * Carries out an order.
     *
     * @param progress is told now and then how far it is
     * @return the failures, and how to repeat them; may be empty
     */
    public List<String> run(Order order, Consumer<String> progress) throws InterruptedException {
        return new Campaign(order, tally, watch, progress).run(subjects());
    }

    private List<Subject> subjects() {
        List<Subject> subjects = new ArrayList<>();
        if (only == Only.SOAK) {
            return List.of(new SoakSubject(tally, watch));
        }
        if (only != Only.FILES) {
            subjects.add(new EngineSubject(tally, watch));
        }
        if (only != Only.ENGINE) {
            subjects.add(new FilesSubject(tally, watch, wrong));
        }
        return subjects;
    }
}
