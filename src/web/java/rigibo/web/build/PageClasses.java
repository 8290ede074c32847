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
 * The places where TeaVM finds the classes of the page. The page is made from the game's classes
 * and the libraries of its desktop version; classes of {@code src/web} replace those of the same
 * name. This program itself runs the desktop's classes, but reads them in the page's order.
 */
final class PageClasses extends URLClassLoader {

    /** Libraries that the page uses unchanged. */
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

    /** Finds a resource in the page's places before those of this program. */
    @Override
    public URL getResource(String name) {
        URL own = findResource(name);
        return own == null ? super.getResource(name) : own;
    }
}
