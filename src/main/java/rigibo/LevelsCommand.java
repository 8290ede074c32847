package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import rigibo.frontend.puzzle.check.LevelsCheck;
import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.generate.LevelsGenerate;
import rigibo.frontend.scene.accuracy.Preset;

import java.nio.file.Path;
import java.util.List;

/** Works on level files, without a window. */
@Command(name = "levels", description = "Works on level files, without a window.")
final class LevelsCommand implements Runnable {
    /** Most levels that a call makes: some days of one core. */
    private static final int MOST_LEVELS = 100_000;

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

    /** Makes levels from seeds; returns the exit code. */
    @Command(
            name = "generate",
            description = {
                "Makes the level of a seed and prints it as a level file, and on the error output",
                "what a check finds out about it. A seed has the same level on every machine. Only",
                "what 'levels check --accuracy GAME' passes is kept, with a par of 2 to 5, at most"
                        + " 30 %%",
                "of the orders that win, and a first click that looks right and loses the ball."
            })
    int generate(
            @Option(
                            names = "--seed",
                            required = true,
                            paramLabel = "N",
                            description = "Decides the level; 0 to 999999999999.")
                    long seed,
            @Option(
                            names = "--count",
                            paramLabel = "K",
                            defaultValue = "1",
                            description =
                                    "Levels of this many seeds in a row, from N on; 1 to 100000.")
                    int count,
            @Option(
                            names = "--summary",
                            description =
                                    "No levels, only what they are like, a line each, and"
                                            + " together.")
                    boolean isSummary) {
        requireBetween("--count", count, 1, MOST_LEVELS);
        requireBetween("--seed", seed, 0, Generator.LAST_SEED - count + 1);
        LevelsGenerate generate =
                new LevelsGenerate(spec.commandLine().getOut(), spec.commandLine().getErr());
        return isSummary ? generate.summary(seed, count) : generate.print(seed, count);
    }

    private void requireBetween(String option, long value, long least, long most) {
        if (value < least || value > most) {
            throw Options.refused(
                    spec, option, "must be " + least + " to " + most + ", was " + value);
        }
    }
}
