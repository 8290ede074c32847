package rigibo.web;

import rigibo.fuzz.program.Operation;
import rigibo.fuzz.program.Program;
import rigibo.fuzz.program.Programs;
import rigibo.fuzz.program.Stage;
import rigibo.fuzz.program.Witness;

/**
 * Runs random programs and prints the hash of the state that each leaves: the same lines on the JVM
 * and in a browser.
 */
public final class Bits {

    /** What all lines begin with. */
    public static final String MARK = "program ";

    /** Programs that are run. */
    private static final int COUNT = 100;

    private static final long SEED = 25;

    /** A program of more bodies may take a minute in a single step, at its accuracy. */
    private static final int MOST_BODIES = 12;

    private Bits() {}

    public static void main(String[] arguments) {
        for (int index = 0; index < COUNT; index++) {
            System.out.println(MARK + index + ": " + outcome(Programs.of(SEED, index)));
        }
    }

    private static String outcome(Program program) {
        Stage stage = program.stage(Witness.NONE);
        int refused = 0;
        for (Operation operation : program.operations()) {
            if (stage.added() > MOST_BODIES) {
                break;
            }
            if (operation.canBeDone(stage) && !isDone(operation, stage)) {
                refused++;
            }
        }
        return Long.toHexString(stage.pool().stateHash()) + ", refused " + refused;
    }

    /** Programs also ask for what the engine must refuse. */
    private static boolean isDone(Operation operation, Stage stage) {
        try {
            operation.act().accept(stage);
            return true;
        } catch (IllegalArgumentException | IllegalStateException refusal) {
            return false;
        }
    }
}
