package rigibo.web.build;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Finds programs on the path. */
final class OnPath {

    private OnPath() {}

    /** The first of these names that is on the path. */
    static Optional<Path> first(List<String> names) {
        String[] places = System.getenv("PATH").split(File.pathSeparator);
        return names.stream()
                .flatMap(name -> Arrays.stream(places).map(place -> Path.of(place, name)))
                .filter(Files::isExecutable)
                .findFirst();
    }
}
