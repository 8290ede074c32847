package rigibo.docs.site;

import java.nio.file.Path;
import java.util.List;

/**
 * Where a file of the checkout stands in the site: in the folder of the same name. Text becomes a
 * page, and so does a folder.
 */
final class Address {

    /** Endings of what a page shows as it is. */
    private static final List<String> PICTURES = List.of(".png", ".gif", ".svg");

    private static final String INDEX = "index.html";

    private Address() {}

    static boolean isPicture(Path file) {
        return PICTURES.stream().anyMatch(file.toString()::endsWith);
    }

    static Path ofFile(Path file) {
        String name = file.getFileName().toString();
        if (isPicture(file)) {
            return file;
        }
        if (name.equals("README.md")) {
            return file.resolveSibling(INDEX);
        }
        return file.resolveSibling(name.replaceFirst("\\.md$", "") + ".html");
    }

    static Path ofFolder(Path folder) {
        return folder.resolve(INDEX);
    }

    /** The way from one page to another, as a link states it. */
    static String link(Path from, Path to) {
        Path folder = from.getParent();
        Path way = folder == null ? to : folder.relativize(to);
        return way.toString().replace('\\', '/');
    }
}
