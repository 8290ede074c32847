package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

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
            description = "Validates level files and replays their stored solutions.")
    int check(
            @Parameters(
                            paramLabel = "FILE",
                            description = "Level files; without any, all of the game's own.")
                    List<Path> files) {
        spec.commandLine().getErr().println("There is no level to check yet.");
        return 1;
    }
}
