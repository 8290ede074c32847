package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import java.nio.file.Path;
import java.util.concurrent.Callable;

/** Lets the game play itself, every scene and level in turn, and keeps pictures of it. */
@Command(name = "tour", description = "The game plays itself in real windows and keeps pictures.")
final class TourCommand implements Callable<Integer> {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "build/tour",
            description = "Where the pictures go (default: ${DEFAULT-VALUE}).")
    private Path out;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        spec.commandLine().getErr().println("There is no scene to tour yet.");
        return 1;
    }
}
