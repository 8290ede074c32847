package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Display;
import rigibo.frontend.save.Places;
import rigibo.frontend.save.SavedPlayer;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Opens the game: its menu, a scene by its name, or a level or replay by its file. */
@Command(name = "play", description = "Opens the game: its menu, a scene, a level or a replay.")
final class PlayCommand implements Callable<Integer> {
    @Option(
            names = "--scene",
            paramLabel = "NAME",
            description = "Opens this scene; an unknown name lists them all.")
    private String scene;

    @Option(
            names = "--home",
            paramLabel = "DIR",
            defaultValue = "${env:RIGIBO_HOME}",
            description =
                    "Where settings and progress are kept (default: RIGIBO_HOME, or else the"
                            + " system's folder for such files).")
    private Path home;

    @Option(
            names = "--edit",
            paramLabel = "FILE.json",
            description =
                    "Opens the editor with this level, or with a new one if there is no such file.")
    private Path edited;

    @Parameters(
            paramLabel = "FILE",
            description =
                    "A level or a replay; a replay of a level that is not the game's needs the"
                            + " level too.")
    private List<Path> files = List.of();

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        try (SavedPlayer player = new SavedPlayer(places(), Locale.getDefault().getLanguage())) {
            Display display = new Display(Catalog::menu, Catalog::levels, player);
            display.plugIn();
            // Read on a thread of its own while the window's library starts.
            CompletableFuture.runAsync(Catalog::entries);
            display.opensFilesBy(Catalog::dropped);
            display.opensCodesBy(Catalog::pasted);
            display.run(first());
            return 0;
        } catch (DisplayException | IllegalArgumentException e) {
            spec.commandLine().getErr().println(e.getMessage());
            return 1;
        }
    }

    private Places places() {
        return home == null ? Places.ofSystem() : Places.in(home);
    }

    /** The scene asked for, or null for the menu. */
    private Function<Director, Scene> first() {
        if (edited != null) {
            return Catalog.edit(edited);
        }
        if (!files.isEmpty()) {
            return Catalog.files(files);
        }
        if (scene == null) {
            return null;
        }
        return Catalog.linked(scene)
                .orElseThrow(() -> new ParameterException(spec.commandLine(), unknown()));
    }

    private String unknown() {
        String names =
                Catalog.entries().stream().map(SceneEntry::name).collect(Collectors.joining(", "));
        return "There is no scene '" + scene + "'; there are: " + names;
    }
}
