package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import rigibo.film.Film;
import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Offscreen;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.Function;

/** Makes a moving picture of a level being solved, or of a replay. */
@Command(
        name = "record",
        description = "Makes a GIF of a level being solved, or of a replay, without a window.")
final class RecordCommand implements Callable<Integer> {

    /** Words in a narrower picture cannot be read. */
    private static final int LEAST_WIDTH = 180;

    /** No page shows a wider picture. */
    private static final int MOST_WIDTH = 1440;

    @Parameters(
            paramLabel = "LEVEL|FILE",
            description = "A level of the game by its name, a level file or a replay.")
    private String what;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "FILE.gif",
            description = "The file to write.")
    private Path out;

    @Option(
            names = "--width",
            paramLabel = "PX",
            defaultValue = "360",
            description = "Width of the picture, px (default: ${DEFAULT-VALUE}).")
    private int width;

    @Option(
            names = "--language",
            paramLabel = "LANGUAGE",
            defaultValue = "en",
            description = "Language of the words, en or de (default: ${DEFAULT-VALUE}).")
    private String language;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        Options.requireBetween(spec, "--width", width, LEAST_WIDTH, MOST_WIDTH);
        // Pictures are made without a screen; AWT must not look for one.
        System.setProperty("java.awt.headless", "true");
        int height = Math.round(width * (float) Scene.HEIGHT / Scene.WIDTH);
        PrintWriter complaints = spec.commandLine().getErr();
        try {
            return record(Catalog.film(what), height);
        } catch (DisplayException | IllegalArgumentException refused) {
            complaints.println(refused.getMessage());
        } catch (IOException broken) {
            complaints.println("cannot write " + out + ": " + broken.getMessage());
        }
        return 1;
    }

    private int record(Function<Director, Scene> scene, int height) throws IOException {
        try (Offscreen screen = new Offscreen(2 * width, 2 * height)) {
            int frames = new Film(scene, screen).write(out, language);
            screen.troubles().forEach(spec.commandLine().getErr()::println);
            String words = "%s: %d frames of %d × %d, %d kB%n";
            PrintWriter told = spec.commandLine().getOut();
            told.printf(words, out, frames, width, height, Files.size(out) / 1000);
            return screen.troubles().isEmpty() ? 0 : 1;
        }
    }
}
