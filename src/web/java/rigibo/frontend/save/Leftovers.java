package rigibo.frontend.save;

import java.nio.file.Path;
import java.util.stream.Stream;

/** Stands in for files left half-written, of which a page has none. */
final class Leftovers {

    private Leftovers() {}

    static void sweep(Stream<Path> folders) {}
}
