package rigibo.lab.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.ServiceLoader;

/** The available engines: ours, and those on the class path. */
public final class Engines {

    private Engines() {}

    /** Our engine first, then the others that can run, by name. */
    public static List<Engine> all() {
        List<Engine> others = found();
        others.removeIf(engine -> engine.missing().isPresent());
        others.sort((a, b) -> a.name().compareTo(b.name()));
        List<Engine> all = new ArrayList<>();
        all.add(new RigiBoEngine());
        all.addAll(others);
        return List.copyOf(all);
    }

    /** The reasons why other engines cannot run here, a sentence each. */
    public static List<String> missing() {
        return found().stream().flatMap(engine -> engine.missing().stream()).distinct().toList();
    }

    private static List<Engine> found() {
        List<Engine> found = new ArrayList<>();
        ServiceLoader.load(Engine.class).forEach(found::add);
        return found;
    }

    /**
     * The engine with a name.
     *
     * @throws NoSuchElementException naming it if it is not available
     */
    public static Engine named(String name) {
        return all().stream()
                .filter(engine -> engine.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new NoSuchElementException("no engine '" + name + "' at hand"));
    }

    /** The game's preset for our engine, the default setting for another one. */
    public static Setting usual(Engine engine) {
        Setting first = engine.settings().get(0);
        return first.line() == Line.PEERS ? first : setting(engine, "GAME");
    }

    /**
     * The setting with a name.
     *
     * @throws NoSuchElementException naming it where the engine has none such
     */
    public static Setting setting(Engine engine, String name) {
        return engine.settings().stream()
                .filter(setting -> setting.name().equals(name))
                .findFirst()
                .orElseThrow(
                        () ->
                                new NoSuchElementException(
                                        engine.name() + " has no setting '" + name + "'"));
    }
}
