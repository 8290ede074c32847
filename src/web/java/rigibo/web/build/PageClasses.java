package rigibo.web.build;

import java.io.File;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Where TeaVM finds the classes of the page. What makes the page is the game itself, with the
 * libraries that it has on the desktop; in the page, classes of {@code src/web} stand in front of
 * those of the same name. Classes are run as they are here, and read in the page's order.
 */
final class PageClasses extends URLClassLoader {

    /** Libraries that the page has as they are. */
    private static final List<String> LIBRARIES = List.of("teavm-", "threetenbp-", "jzlib-");

    private PageClasses(URL[] places) {
        super(places, PageClasses.class.getClassLoader());
    }

    static PageClasses find() {
        return new PageClasses(places().stream().map(PageClasses::url).toArray(URL[]::new));
    }

    /** Directories and jars, those of {@code src/web} first. */
    static List<File> places() {
        List<File> all =
                Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                        .map(File::new)
                        .filter(PageClasses::isForPage)
                        .toList();
        return Stream.concat(
                        all.stream().filter(PageClasses::isOfPage),
                        all.stream().filter(place -> !isOfPage(place)))
                .toList();
    }

    private static boolean isForPage(File place) {
        return place.isDirectory() || LIBRARIES.stream().anyMatch(place.getName()::startsWith);
    }

    private static boolean isOfPage(File place) {
        return place.toPath().getFileName().equals(Path.of("web"));
    }

    private static URL url(File place) {
        try {
            return place.toURI().toURL();
        } catch (MalformedURLException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** What is found in the page's places, before what is found in those of this program. */
    @Override
    public URL getResource(String name) {
        URL own = findResource(name);
        return own == null ? super.getResource(name) : own;
    }
}
