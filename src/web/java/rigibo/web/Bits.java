package rigibo.web;

import rigibo.frontend.puzzle.Replays;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.fuzz.program.Operation;
import rigibo.fuzz.program.Program;
import rigibo.fuzz.program.Programs;
import rigibo.fuzz.program.Stage;
import rigibo.fuzz.program.Witness;
import rigibo.web.game.Brought;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * Prints the findings of proofs, the hashes of the states that some random programs leave, and
 * whether recorded runs of levels replay: the same lines on the JVM and in a browser.
 */
public final class Bits {

    /** Beginning of all lines. */
    public static final String MARK = "bits of ";

    /** Name of the folder of recorded runs among the page's files. */
    public static final String RUNS = "runs";

    private static final Path HOME = Path.of("/game");

    /** Number of programs. */
    private static final int COUNT = 100;

    private static final long SEED = 25;

    /** Most bodies of a program: with more, a single step may take a minute at its accuracy. */
    private static final int MOST_BODIES = 12;

    private Bits() {}

    /** Runs in a browser, with the page's files. */
    public static void main(String[] arguments) throws IOException {
        System.setProperty("rigibo.home", HOME.toString());
        Brought.unpackTo(HOME);
        print(HOME.resolve(RUNS));
    }

    /** Prints all lines, with the recorded runs of a folder. */
    public static void print(Path runs) throws IOException {
        Proofs.print();
        for (int index = 0; index < COUNT; index++) {
            System.out.println(
                    MARK + "program " + index + ": " + outcome(Programs.of(SEED, index)));
        }
        Replays replays = Replays.ofGame();
        try (Stream<Path> files = Files.list(runs)) {
            for (Path file : files.filter(Bits::isRun).sorted().toList()) {
                LoadedReplay loaded = replays.load(file);
                String outcome =
                        loaded.recording()
                                .map(run -> Proof.of(run).toString())
                                .orElse(loaded.problems().toString());
                System.out.println(MARK + file.getFileName() + ": " + outcome);
            }
        }
    }

    private static boolean isRun(Path file) {
        return file.toString().endsWith(ReplayShelf.ENDING);
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

    /**
     * Whether the engine accepted an operation; programs also ask for operations that it must
     * refuse.
     */
    private static boolean isDone(Operation operation, Stage stage) {
        try {
            operation.act().accept(stage);
            return true;
        } catch (IllegalArgumentException | IllegalStateException refusal) {
            return false;
        }
    }
}
