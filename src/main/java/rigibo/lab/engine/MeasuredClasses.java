package rigibo.lab.engine;

import rigibo.lab.child.ClassFiles;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Makes a key of the classes that measurements depend on. */
public final class MeasuredClasses {

    private MeasuredClasses() {}

    /**
     * A key that changes with any of the classes and with the version of Java.
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
