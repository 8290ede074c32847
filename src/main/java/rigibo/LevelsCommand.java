package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.check.LevelsCheck;

import java.nio.file.Path;
import java.util.List;

/** Works on level files, without a window. */
@Command(name = "levels", description = "Works on level files, without a window.")
final class LevelsCommand implements Runnable {
    @Spec private CommandSpec spec;

    /** {@code levels} alone asks for nothing. */
    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "What to do with the levels?");
    }

    /** Checks the files, or every level of the game when none is named; returns the exit code. */
    @Command(
            name = "check",
            description = {
                "Validates level files and plays them without a window: stored solutions must win,"
                        + " also with",
                "everything up to 10 mm aside, and no single click may."
            })
    int check(
            @Option(
                            names = "--accuracy",
                            paramLabel = "PRESET",
                            defaultValue = "GAME",
                            description = "DRAFT, GAME, FINE or EXACT; GAME unless said otherwise.")
                    Preset accuracy,
            @Parameters(
                            paramLabel = "FILE",
                            description = "Level files; without any, all of the game's own.")
                    List<Path> files) {
        LevelsCheck check = new LevelsCheck(accuracy.knobs, spec.commandLine().getOut());
        return check.run(files == null ? List.of() : files);
    }

    /** What the engine's presets are called on the command line. */
    enum Preset {
        DRAFT(Accuracy.DRAFT),
        GAME(Accuracy.GAME),
        FINE(Accuracy.FINE),
        EXACT(Accuracy.EXACT);

        private final Accuracy knobs;

        Preset(Accuracy knobs) {
            this.knobs = knobs;
        }
    }
}
