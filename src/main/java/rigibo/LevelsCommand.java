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
    /** Most levels of one call, which take days on one core. */
    private static final int MOST_LEVELS = 100_000;

    @Spec private CommandSpec spec;

    /** Refuses {@code levels} without a command of its own. */
    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "What to do with the levels?");
    }

    /** Checks the files, or every level of the game when none is named; returns the exit code. */
    @Command(
            name = "check",
            description = {
                "Validates level files and plays them at every accuracy. Stored solutions must win,"
                        + " also with every body up to 10 mm aside. A search among orders and times"
                        + " of clicks, by a sample where there are many, must find none that wins"
                        + " with fewer than par. The share of orders that win is printed."
            })
    int check(
            @Option(
                            names = "--accuracy",
                            paramLabel = "PRESET",
                            description = "Only at DRAFT, GAME, FINE or EXACT, which is faster.")
                    Preset accuracy,
            @Parameters(
                            paramLabel = "FILE",
                            description = "Level files (default: all levels of the game).")
                    List<Path> files) {
        List<Preset> presets = accuracy == null ? List.of(Preset.values()) : List.of(accuracy);
        LevelsCheck check = new LevelsCheck(presets, spec.commandLine().getOut());
        return check.run(files == null ? List.of() : files);
    }

    /** Makes levels from seeds; returns the exit code. */
    @Command(
            name = "generate",
            description = {
                "Makes the level of a seed and prints it as a level file; the result of its check"
                        + " goes to the error output. A seed gives the same level on every machine."
                        + " Each level passes 'levels check --accuracy GAME', has a par of 2 to 5,"
                        + " is won by at most 30 %% of all orders, and has a first click that looks"
                        + " right and loses the ball."
            })
    int generate(
            @Option(
                            names = "--seed",
                            required = true,
                            paramLabel = "N",
                            description = "Seed of the level, 0 to 999999999999.")
                    long seed,
            @Option(
                            names = "--count",
                            paramLabel = "K",
                            defaultValue = "1",
                            description =
                                    "Makes the levels of this many seeds, from N on, 1 to 100000"
                                            + " (default: ${DEFAULT-VALUE}).")
                    int count,
            @Option(
                            names = "--summary",
                            description =
                                    "Prints a line about each level, and one about all, in place"
                                            + " of the files.")
                    boolean isSummary) {
        Options.requireBetween(spec, "--count", count, 1, MOST_LEVELS);
        Options.requireBetween(spec, "--seed", seed, 0, Generator.LAST_SEED - count + 1);
        LevelsGenerate generate =
                new LevelsGenerate(spec.commandLine().getOut(), spec.commandLine().getErr());
        return isSummary ? generate.summary(seed, count) : generate.print(seed, count);
    }
}
