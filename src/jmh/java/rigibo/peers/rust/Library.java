package rigibo.peers.rust;

import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Path;
import java.util.Optional;

/** The library of Rust code, which is on the class path once it is built. */
final class Library {

    private static final URL BUILT =
            Library.class.getResource("/" + System.mapLibraryName("rigibo_peers"));

    private Library() {}

    /** Why its engines cannot run; empty if they can. */
    static Optional<String> missing() {
        return BUILT == null
                ? Optional.of(
                        "Box2D v3 and Rapier are left out: \"./rigibo peers\" builds them, with"
                                + " Rust")
                : Optional.empty();
    }

    /** Loads the library; {@link Calls} does so before its first call. */
    static void load() {
        try {
            System.load(Path.of(BUILT.toURI()).toString());
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException("no path: " + BUILT, impossible);
        }
    }

    /** The version of an engine in it, such as 3.2.0. */
    static String version(int engine) {
        int version = Calls.version(engine);
        return version / 10_000 + "." + version / 100 % 100 + "." + version % 100;
    }
}
