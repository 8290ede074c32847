package rigibo.fuzz;

import rigibo.fuzz.judge.Failure;
import rigibo.fuzz.judge.Judge;
import rigibo.fuzz.judge.Shrinking;
import rigibo.fuzz.judge.Tally;
import rigibo.fuzz.judge.Watch;
import rigibo.fuzz.program.Program;
import rigibo.fuzz.program.Programs;

import java.util.Optional;

/** Tries programs in the engine. */
final class EngineSubject implements Subject {

    private final Judge judge;
    private final Watch watch;

    EngineSubject(Tally tally, Watch watch) {
        judge = new Judge(tally, watch);
        this.watch = watch;
    }

    @Override
    public String title() {
        return "engine";
    }

    @Override
    public String again(long seed, long index) {
        return Subject.super.again(seed, index) + " --programs 1";
    }

    @Override
    public Optional<String> tried(long seed, long index) {
        Program program = Programs.of(seed, index);
        return judge.judge(program).map(failure -> words(program, failure));
    }

    private String words(Program program, Failure failure) {
        Program small = new Shrinking(watch).of(program, failure);
        Failure left = new Judge(new Tally(), watch).judge(small).orElse(failure);
        return String.format(
                "law: %s%nseen: %s%nafter operation %d of the %d left of %d:%n%s",
                left.law(),
                left.words(),
                left.operation(),
                small.operations().size(),
                program.operations().size(),
                small.java());
    }
}
