package rigibo.fuzz.judge;

import rigibo.fuzz.program.Operation;
import rigibo.fuzz.program.Program;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Shrinks a program while it breaks the same law. */
public final class Shrinking {

    /** The processor time in s after which shrinking stops. */
    private static final double LONGEST = 15;

    private final Watch watch;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

    /** A watch reports programs that hang while shrinking. */
    public Shrinking(Watch watch) {
        this.watch = watch;
    }

    /** The shortest program found in the time that still breaks the law of a failure. */
    public Program of(Program program, Failure failure) {
        Program small = upTo(program, failure.operation());
        small = breaks(small, failure) ? small : program;
        int part = small.operations().size();
        double end = seconds() + LONGEST;
        while (part > 0 && seconds() < end) {
            Optional<Program> smaller = withoutOne(small, part, failure);
            small = smaller.orElse(small);
            part = smaller.isPresent() ? Math.min(part, small.operations().size()) : part / 2;
        }
        return small;
    }

    private double seconds() {
        return 1e-9 * threads.getCurrentThreadCpuTime();
    }

    private static Program upTo(Program program, int last) {
        int count = Math.min(last + 1, program.operations().size());
        return program.with(program.operations().subList(0, count));
    }

    private Optional<Program> withoutOne(Program program, int part, Failure failure) {
        List<Operation> all = program.operations();
        for (int end = all.size(); end > 0; end -= part) {
            List<Operation> left = new ArrayList<>(all);
            left.subList(Math.max(0, end - part), end).clear();
            Program smaller = program.with(left);
            if (breaks(smaller, failure)) {
                return Optional.of(smaller);
            }
        }
        return Optional.empty();
    }

    private boolean breaks(Program program, Failure failure) {
        return new Judge(new Tally(), watch)
                .judge(program)
                .filter(found -> found.law().equals(failure.law()))
                .isPresent();
    }
}
