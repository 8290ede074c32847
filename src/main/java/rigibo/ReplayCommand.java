package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import rigibo.frontend.puzzle.Replays;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.Verdict;
import rigibo.frontend.scene.Words;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;

/** Plays replays without a window, and prints whether they are the same to the last bit. */
@Command(
        name = "replay",
        description = "Plays replays without a window, and checks that every bit is the same.")
final class ReplayCommand implements Callable<Integer> {
    @Option(
            names = "--level",
            paramLabel = "LEVEL.json",
            description = "The level of the replays, if it is not one of the game's.")
    private Path level;

    @Parameters(arity = "1..*", paramLabel = "FILE", description = "Replay files.")
    private List<Path> files;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        try {
            Replays replays = level == null ? Replays.ofGame() : Replays.of(level);
            boolean areSame = true;
            for (Path file : files) {
                areSame &= isSame(file, replays.load(file));
            }
            return areSame ? 0 : 1;
        } catch (IllegalArgumentException brokenLevel) {
            spec.commandLine().getErr().println(brokenLevel.getMessage());
            return 1;
        }
    }

    private boolean isSame(Path file, LoadedReplay loaded) {
        PrintWriter complaints = spec.commandLine().getErr();
        loaded.problems().forEach(complaints::println);
        Optional<Verdict> verdict = loaded.recording().map(Proof::of);
        verdict.ifPresent(
                found ->
                        spec.commandLine()
                                .getOut()
                                .println(file + ": " + found.in(new Words("en"))));
        return verdict.isPresent() && verdict.get().isSame();
    }
}
