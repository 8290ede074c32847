package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.DisplayException;
import rigibo.frontend.display.Tour;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
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
        PrintWriter words = spec.commandLine().getOut();
        PrintWriter complaints = spec.commandLine().getErr();
        try {
            List<String> failures = new Tour(Catalog.entries(), out, words).run(Catalog::menu);
            failures.forEach(complaints::println);
            words.println("Pictures are in " + out);
            return failures.isEmpty() ? 0 : 1;
        } catch (DisplayException e) {
            complaints.println(e.getMessage());
            return 1;
        }
    }
}
