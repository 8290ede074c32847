package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Display;
import rigibo.frontend.display.Move;
import rigibo.frontend.display.Tour;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Guest;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Settings;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Lets the game play itself, every scene and level in turn, and keeps pictures. */
@Command(name = "tour", description = "The game plays itself in real windows and keeps pictures.")
final class TourCommand implements Callable<Integer> {

    /** A level that cannot be played: boxes overlap, and a word stands where a number must be. */
    private static final String BROKEN =
            """
            {
              "format": 2,
              "id": "broken",
              "title": {"en": "Broken", "de": "Kaputt"},
              "world": {"width": 9, "height": 10, "gravity": [0, -9.81],
                        "effects": ["gravity", "contacts", "sleep", "thrust"]},
              "rules": {"cooldown": 1, "hold": "long", "contactGrace": 0.25, "par": 2},
              "ball": {"x": 4, "y": 12, "radius": 0.3},
              "platform": {"x": 4.5, "y": 1, "w": 3},
              "bodies": [
                {"id": "left", "material": "rigibo", "deletable": true,
                 "shape": {"type": "box", "w": 1, "h": 1}, "x": 3.4, "y": 1.6},
                {"id": "right", "material": "rigibo", "deletable": true,
                 "shape": {"type": "box", "w": 1, "h": 1}, "x": 4.1, "y": 1.6}
              ],
              "solutions": [{"clicks": [{"t": 1, "body": "rihgt"}]}]
            }
            """;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "build/tour",
            description = "Where the pictures go (default: ${DEFAULT-VALUE}).")
    private Path out;

    @Option(
            names = "--scale",
            paramLabel = "S",
            defaultValue = "1",
            description = "Scale of the windows, 0.5 to 3 (default: ${DEFAULT-VALUE}).")
    private double scale;

    @Option(
            names = "--window",
            paramLabel = "WxH",
            description = "Size of the windows in pixels, such as 1366x768.")
    private String window = "";

    @Option(names = "--full-screen", description = "Lets windows fill the screen.")
    private boolean isFullScreen;

    @Option(names = "--lite", description = "Draws in less detail, as on a slow machine.")
    private boolean isLite;

    @Option(
            names = "--language",
            paramLabel = "L",
            defaultValue = "en",
            description = "Language, en or de (default: ${DEFAULT-VALUE}).")
    private String language;

    @Option(
            names = "--exhibits",
            description = "Also plays every exhibit of the gallery for a few seconds.")
    private boolean hasExhibits;

    @Option(
            names = "--scenes",
            paramLabel = "A,B",
            split = ",",
            description = "Plays only these, named as their pictures are.")
    private Set<String> scenes = Set.of();

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter words = spec.commandLine().getOut();
        PrintWriter complaints = spec.commandLine().getErr();
        try {
            List<String> failures = tour(words).run(display());
            failures.forEach(complaints::println);
            words.println("Pictures are in " + out);
            return failures.isEmpty() ? 0 : 1;
        } catch (DisplayException e) {
            complaints.println(e.getMessage());
            return 1;
        }
    }

    private Tour tour(PrintWriter words) {
        int[] size = window.isEmpty() ? scaled() : size();
        return new Tour(stops(), size[0], size[1], out, words);
    }

    private Display display() {
        Display display = new Display(Catalog::menu, Catalog::levels, new Guest(settings()));
        display.opensFilesBy(Catalog::dropped);
        display.opensCodesBy(Catalog::pasted);
        return display;
    }

    /** The menus, then everything that they lead to. */
    private List<Tour.Stop> stops() {
        List<Tour.Stop> all = new ArrayList<>();
        all.add(still("menu", Catalog::menu));
        all.add(still("levels", Catalog::levels));
        all.add(still("settings", Catalog::settings));
        all.add(still("keys", Catalog::keys));
        Catalog.sheets().forEach(entry -> all.add(still(entry.name(), entry.open())));
        Catalog.entries().forEach(entry -> all.add(stop(entry)));
        all.addAll(reached());
        Set<String> exhibits =
                Catalog.exhibits().stream().map(SceneEntry::name).collect(Collectors.toSet());
        Catalog.exhibits().forEach(entry -> all.add(stop(entry)));
        List<String> names = all.stream().map(Tour.Stop::name).toList();
        Options.requireKnown(spec, "--scenes", scenes, names);
        return all.stream()
                .filter(stop -> isWanted(stop.name(), exhibits.contains(stop.name())))
                .toList();
    }

    /** What no list of scenes holds, since only moves of the player lead there. */
    private List<Tour.Stop> reached() {
        Move play = new Move.Click("menu.play");
        Move endless = new Move.Click("scene.endless");
        Move watch = new Move.Watch();
        Move daily = new Move.Click("scene.daily");
        Move copy = new Move.Press(Key.C);
        Move toLevels = new Move.Click("puzzle.command.levels");
        Move paste = new Move.Click("menu.paste");
        Path broken = broken();
        return List.of(
                still("elements", Catalog::levels, new Move.Click("world.4")),
                still("statistics", Catalog::menu, new Move.Click("menu.statistics")),
                moving("endless", Catalog::levels, endless, play),
                moving("daily", Catalog::levels, daily, play),
                moving("replay", Catalog::levels, daily, play, watch, copy, toLevels, paste),
                still("broken-file", Catalog::menu, new Move.Drop(broken)),
                still(
                        "broken-draft",
                        director -> Catalog.edit(broken).apply(director),
                        new Move.Click("editor.problem.E120")));
    }

    /** A file with mistakes that authors make. */
    private static Path broken() {
        try {
            Path file = Files.createTempDirectory("rigibo").resolve("broken.json");
            file.toFile().deleteOnExit();
            return Files.writeString(file, BROKEN);
        } catch (IOException e) {
            throw new DisplayException("cannot write a level to be refused: " + e.getMessage());
        }
    }

    private static Tour.Stop still(String name, Function<Director, Scene> open, Move... moves) {
        return new Tour.Stop(name, open, List.of(moves), Tour.Stop.WAITING);
    }

    private static Tour.Stop moving(String name, Function<Director, Scene> open, Move... moves) {
        return new Tour.Stop(name, open, List.of(moves), Tour.Stop.MOVING);
    }

    private static Tour.Stop stop(SceneEntry entry) {
        return moving(entry.name(), entry.open());
    }

    private boolean isWanted(String name, boolean isExhibit) {
        return scenes.isEmpty() ? hasExhibits || !isExhibit : scenes.contains(name);
    }

    /** Full detail, however slow the machine is, unless less is asked for. */
    private Settings settings() {
        if (!Settings.LANGUAGES.contains(language)) {
            throw Options.refused(
                    spec,
                    "--language",
                    "must be one of " + Settings.LANGUAGES + ", was " + language);
        }
        return Settings.initial(language)
                .withDetail(isLite ? Settings.Detail.LITE : Settings.Detail.FULL)
                .withFullScreen(isFullScreen);
    }

    private int[] scaled() {
        if (!(scale >= 0.5 && scale <= 3)) {
            throw Options.refused(spec, "--scale", "must be 0.5 to 3, was " + scale);
        }
        return new int[] {
            (int) Math.round(scale * Scene.WIDTH), (int) Math.round(scale * Scene.HEIGHT)
        };
    }

    /** Width and height, 200 to 9999 px each. */
    private int[] size() {
        if (!window.matches("([2-9]\\d\\d|[1-9]\\d{3})x([2-9]\\d\\d|[1-9]\\d{3})")) {
            String why = "must be width x height, 200 to 9999 px each, such as 1366x768, was ";
            throw Options.refused(spec, "--window", why + window);
        }
        return Arrays.stream(window.split("x")).mapToInt(Integer::parseInt).toArray();
    }
}
