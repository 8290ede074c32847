package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Tour;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Settings;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;

/** Lets the game play itself, every scene and level in turn, and keeps pictures. */
@Command(name = "tour", description = "The game plays itself in real windows and keeps pictures.")
final class TourCommand implements Callable<Integer> {
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
            List<String> failures = tour(words).run();
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
        return new Tour(stops(), settings(), size[0], size[1], out, words);
    }

    /** The menus, then everything that they lead to. */
    private List<Tour.Stop> stops() {
        List<Tour.Stop> all = new ArrayList<>();
        all.add(new Tour.Stop("menu", Catalog::menu, true));
        all.add(new Tour.Stop("levels", Catalog::levels, true));
        all.add(new Tour.Stop("settings", Catalog::settings, true));
        all.add(new Tour.Stop("keys", Catalog::keys, true));
        Catalog.sheets().forEach(entry -> all.add(new Tour.Stop(entry.name(), entry.open(), true)));
        Catalog.entries().forEach(entry -> all.add(stop(entry)));
        Set<String> exhibits =
                Catalog.exhibits().stream().map(SceneEntry::name).collect(Collectors.toSet());
        Catalog.exhibits().forEach(entry -> all.add(stop(entry)));
        List<String> names = all.stream().map(Tour.Stop::name).toList();
        Options.requireKnown(spec, "--scenes", scenes, names);
        return all.stream()
                .filter(stop -> isWanted(stop.name(), exhibits.contains(stop.name())))
                .toList();
    }

    private static Tour.Stop stop(SceneEntry entry) {
        return new Tour.Stop(entry.name(), entry.open(), false);
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
