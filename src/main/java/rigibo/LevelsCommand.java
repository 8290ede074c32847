package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import rigibo.frontend.puzzle.check.LevelsCheck;
import rigibo.frontend.scene.accuracy.Preset;

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
                "Validates level files and plays them without a window, at every accuracy: stored",
                "solutions must win, also with everything up to 10 mm aside, and a search among"
                        + " orders",
                "and times of clicks, a sample where there are many, must find none that wins with"
                        + " fewer",
                "than par; it tells how often others do."
            })
    int check(
            @Option(
                            names = "--accuracy",
                            paramLabel = "PRESET",
                            description = "Only DRAFT, GAME, FINE or EXACT, which is faster.")
                    Preset accuracy,
            @Parameters(
                            paramLabel = "FILE",
                            description = "Level files; without any, all of the game's own.")
                    List<Path> files) {
        List<Preset> presets = accuracy == null ? List.of(Preset.values()) : List.of(accuracy);
        LevelsCheck check = new LevelsCheck(presets, spec.commandLine().getOut());
        return check.run(files == null ? List.of() : files);
    }
}
