package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.nio.file.Path;
import java.util.concurrent.Callable;

/** Opens the game: its menu, one scene by name, or one level by file. */
@Command(name = "play", description = "Opens the main menu, the named scene or the level.")
final class PlayCommand implements Callable<Integer> {
    @Option(names = "--scene", paramLabel = "NAME", description = "Opens this scene at once.")
    private String scene;

    @Parameters(arity = "0..1", paramLabel = "LEVEL.json", description = "Opens this level.")
    private Path level;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        spec.commandLine().getErr().println("There is no scene to play yet.");
        return 1;
    }
}
