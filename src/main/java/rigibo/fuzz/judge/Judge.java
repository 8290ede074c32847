package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import rigibo.backend.Pool;
import rigibo.fuzz.program.Operation;
import rigibo.fuzz.program.Operation.Kind;
import rigibo.fuzz.program.Program;
import rigibo.fuzz.program.Stage;
import rigibo.fuzz.program.Witness;

import java.util.Arrays;
import java.util.Optional;

/** Runs programs and reports which law they break. */
public final class Judge {

    /** The number of operations for which a restored copy runs beside the pool. */
    private static final int COPY_LASTS = 8;

    private final Tally tally;
    private final Watch watch;
    private final Attempt attempt = new Attempt();

    /** The index of the present operation. */
    private int at;

    private Stage copy;
    private int copyLeft;

    /** A judge with a tally of its checks and a watch for operations that hang. */
    public Judge(Tally tally, Watch watch) {
        this.tally = tally;
        this.watch = watch;
    }

    /** The law that a program breaks; empty if all hold. */
    public Optional<Failure> judge(Program program) {
        tally.count(Tally.Of.PROGRAMS);
        copy = null;
        try {
            long[] hashes = first(program);
            again(program, hashes);
            return Optional.empty();
        } catch (LawBroken broken) {
            return Optional.of(new Failure(broken.law, at, broken.getMessage()));
        }
    }

    private long[] first(Program program) {
        Stage stage = program.stage(new Observer(tally, watch));
        long[] hashes = new long[program.operations().size()];
        for (at = 0; at < hashes.length; at++) {
            Operation operation = program.operations().get(at);
            if (operation.canBeDone(stage)) {
                look(operation, stage);
            }
            hashes[at] = stage.pool().stateHash();
        }
        return hashes;
    }

    private void look(Operation operation, Stage stage) {
        watch.begins(operation.java());
        tally.count(Tally.Of.OPERATIONS);
        long before = stage.pool().stateHash();
        boolean isOfTheRemoved = operation.namesTheRemoved(stage);
        String refusal = attempt.make(operation, stage);
        if (!refusal.isEmpty()) {
            tally.count(Tally.Of.REFUSALS);
        }
        requireOutcome(operation, refusal, isOfTheRemoved);
        boolean mayChange = refusal.isEmpty() && operation.kind() != Kind.ASKED;
        unless(
                mayChange || stage.pool().stateHash() == before,
                "what is refused or only asked changes nothing",
                "the hash is another after %s %s",
                operation.java(),
                refusal);
        States.requireSound(stage.pool());
        goOnBeside(operation, stage, refusal);
    }

    /** The verbs of a removed body are refused, whatever else is wrong with the call. */
    private static void requireOutcome(Operation operation, String refusal, boolean ofTheRemoved) {
        boolean mustRefuse = ofTheRemoved || operation.kind() == Kind.REFUSED;
        boolean mayRefuse = mustRefuse || operation.kind() == Kind.TRIED;
        boolean namesField = ofTheRemoved || refusal.contains(operation.refusal());
        unless(
                mayRefuse || refusal.isEmpty(),
                "what is allowed is done",
                "%s was refused: %s",
                operation.java(),
                refusal);
        unless(
                !mustRefuse || namesField && !refusal.isEmpty(),
                "what is not allowed is refused, naming the field",
                "%s was to be refused with \"%s\", was: %s",
                operation.java(),
                operation.refusal(),
                refusal);
    }

    /** Runs the operation in the restored copy too, if there is one. */
    private void goOnBeside(Operation operation, Stage stage, String refusal) {
        if (operation.kind() == Kind.COPIED) {
            copy = stage.copy();
            copyLeft = COPY_LASTS;
            tally.count(Tally.Of.COPIES);
            requireSameBytes(stage);
        } else if (copy != null && operation.kind() != Kind.ASKED) {
            String refusalOfCopy = attempt.make(operation, copy);
            unless(
                    refusalOfCopy.equals(refusal),
                    "a restored pool goes on alike",
                    "refused is \"%s\", by the copy \"%s\"",
                    refusal,
                    refusalOfCopy);
        }
        requireSameHash(stage);
        if (copy != null && --copyLeft < 0) {
            requireSameBytes(stage);
            copy = null;
        }
    }

    private void requireSameHash(Stage stage) {
        unless(
                copy == null || copy.pool().stateHash() == stage.pool().stateHash(),
                "a restored pool goes on alike",
                "its hash is another");
    }

    private void requireSameBytes(Stage stage) {
        unless(
                Arrays.equals(stage.pool().snapshot(), copy.pool().snapshot()),
                "a restored pool goes on alike",
                "its snapshot is another");
    }

    /**
     * Runs the program again without checks: neither another run nor the checks may change a bit.
     */
    private void again(Program program, long[] hashes) {
        Stage stage = program.stage(Witness.NONE);
        for (at = 0; at < hashes.length; at++) {
            Operation operation = program.operations().get(at);
            boolean changes = operation.kind() == Kind.DONE || operation.kind() == Kind.TRIED;
            if (changes && operation.canBeDone(stage)) {
                watch.begins(operation.java());
                attempt.make(operation, stage);
            }
            Pool pool = stage.pool();
            unless(
                    pool.stateHash() == hashes[at],
                    "the same calls give the same bits",
                    "the hash is another in the second run, without questions");
        }
    }
}
