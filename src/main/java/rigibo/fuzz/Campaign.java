package rigibo.fuzz;

import rigibo.fuzz.judge.Attempt;
import rigibo.fuzz.judge.Tally;
import rigibo.fuzz.judge.Watch;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * Tries things in turn until one fails or all are tried. A try that takes too long can only be
 * reported, not stopped, so the tries run on a daemon thread.
 */
final class Campaign {

    /** The processor time that one step or file may take, s, far more than the longest needs. */
    private static final double PATIENCE = 20;

    /**
     * The size of the stack in B, that of a usual main thread, which deeply nested input may
     * exhaust.
     */
    private static final long STACK = 8 << 20;

    private static final long LOOK_MILLIS = 200;

    private final Order order;
    private final Tally tally;
    private final Watch watch;
    private final Consumer<String> progress;
    private final List<String> wrong = new CopyOnWriteArrayList<>();

    /** The command that repeats the present try. */
    private volatile String present = "";

    Campaign(Order order, Tally tally, Watch watch, Consumer<String> progress) {
        this.order = order;
        this.tally = tally;
        this.watch = watch;
        this.progress = progress;
    }

    /** Makes all tries; returns what failed and how to repeat each. */
    List<String> run(List<Subject> subjects) throws InterruptedException {
        Thread trying = new Thread(null, () -> tryAll(subjects), "fuzz", STACK);
        trying.setDaemon(true);
        trying.setUncaughtExceptionHandler(
                (thread, ours) -> wrong.add("the fuzzer itself: " + Attempt.trace(ours)));
        trying.start();
        Optional<String> hanging = Optional.empty();
        while (trying.isAlive() && hanging.isEmpty()) {
            trying.join(LOOK_MILLIS);
            hanging = watch.overdue(PATIENCE);
        }
        hanging.ifPresent(what -> wrong.add(hang(what, trying)));
        return wrong;
    }

    private String hang(String what, Thread trying) {
        StringBuilder words = new StringBuilder("hangs: " + what + System.lineSeparator());
        for (StackTraceElement frame : trying.getStackTrace()) {
            words.append("    at ").append(frame).append(System.lineSeparator());
        }
        return words + present;
    }

    private void tryAll(List<Subject> subjects) {
        Progress told = new Progress(progress, tally);
        for (long round = 0; isToGoOn() && order.goesOn(round); round++) {
            for (Subject subject : subjects) {
                if (isToGoOn() && round < order.most(subject.title())) {
                    tryOut(subject, order.first() + round);
                }
            }
            told.tell();
        }
    }

    private boolean isToGoOn() {
        return wrong.size() < order.failures();
    }

    private void tryOut(Subject subject, long index) {
        present = "again: ./rigibo fuzz " + subject.again(order.seed(), index);
        subject.tried(order.seed(), index).ifPresent(this::note);
    }

    private void note(String found) {
        wrong.add(found + System.lineSeparator() + present);
        progress.accept("found: " + found.lines().findFirst().orElse("") + ", " + present);
    }
}
