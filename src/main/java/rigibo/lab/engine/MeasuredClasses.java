package rigibo.lab.engine;

import rigibo.lab.child.ClassFiles;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The classes that measurements depend on. */
public final class MeasuredClasses {

    private MeasuredClasses() {}

    /**
     * A key of what was measured with them, which changes with any of them and with Java.
     *
     * @param engines that were measured
     * @param members a class of each other room that decides what is measured
     */
    public static String key(List<Engine> engines, Class<?>... members) {
        return Stream.concat(Stream.of(members), engines.stream().map(Engine::getClass))
                        .map(member -> ClassFiles.of(member).hash())
                        .collect(Collectors.joining("-"))
                + "-"
                + Runtime.version();
    }
}
