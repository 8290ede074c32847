package rigibo.docs.site;

import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.Link;
import org.commonmark.node.Node;

import rigibo.frontend.gallery.Exhibits;
import rigibo.frontend.gallery.Found;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The whole site but for the Javadoc and the game, which other commands make. */
final class Site {

    private static final String GAME = "game/index.html";
    private static final Path FIRST = Path.of("README.md");
    private static final Path SAMPLES = Path.of("docs/samples.md");

    private final Path home;
    private final Path folder;
    private final Layout layout;

    /** From a checkout into a folder, which may hold the Javadoc and the game already. */
    Site(Path home, Path folder) {
        this.home = home;
        this.folder = folder;
        layout = new Layout(folder);
        way("Game", GAME);
        layout.way("Tutorial", Path.of("docs/tutorial/index.html"));
        layout.way("Gallery", Address.ofFolder(GalleryPages.FOLDER));
        layout.way("Accuracy", Address.ofFile(AccuracyPage.FILE));
        layout.way("Performance", Path.of("docs/performance.html"));
        layout.way("Hard cases", Path.of("docs/hard-cases.html"));
        layout.way("All pages", Path.of("docs/index.html"));
        way("Javadoc", "javadoc/index.html");
    }

    /** Names what may be missing. */
    private void way(String name, String page) {
        if (Files.exists(folder.resolve(page))) {
            layout.way(name, Path.of(page));
        }
    }

    /** Writes it; the gallery shows exhibits as they are after so many seconds. */
    void write(double gallerySeconds) throws IOException {
        new GalleryPages(home, folder, layout).write(gallerySeconds);
        AccuracyPage accuracy = new AccuracyPage(Files.readString(home.resolve(AccuracyPage.FILE)));
        accuracy.writePlots(folder);
        Pages pages = new Pages(home, folder, layout);
        pages.change(AccuracyPage.FILE, accuracy::arrange);
        pages.change(FIRST, this::greet);
        pages.change(SAMPLES, Site::linkExhibits);
        pages.write(files());
        writeLooks();
    }

    private List<Path> files() throws IOException {
        List<Path> files = new ArrayList<>();
        for (String name : List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs")) {
            files.add(Path.of(name));
        }
        try (Stream<Path> docs = Files.walk(home.resolve("docs"))) {
            docs.filter(file -> file.toString().endsWith(".md"))
                    .map(home::relativize)
                    .forEach(files::add);
        }
        return files;
    }

    /** Below the moving picture: where to go first. */
    private void greet(Node document) {
        String play = Files.exists(folder.resolve(GAME)) ? GAME : "docs/playing.html";
        HtmlBlock ways = new HtmlBlock();
        ways.setLiteral(
                """
                <p class="ways"><a href="%s">Play</a> \
                <a href="docs/tutorial/index.html">Use the engine</a> \
                <a href="docs/accuracy.html">Judge it</a></p>
                """
                        .formatted(play));
        Markdown.heading(document, 1).getNext().insertAfter(ways);
    }

    /** Leads from names of exhibits to their pages. */
    private static void linkExhibits(Node document) {
        Set<String> names = Exhibits.all().stream().map(Found::name).collect(Collectors.toSet());
        document.accept(
                new AbstractVisitor() {
                    @Override
                    public void visit(Code code) {
                        if (names.contains(code.getLiteral())) {
                            Path page = GalleryPages.page(code.getLiteral());
                            Link link = new Link(Address.link(SAMPLES, page), null);
                            code.insertBefore(link);
                            link.appendChild(code);
                        }
                    }
                });
    }

    private void writeLooks() throws IOException {
        try (InputStream style = Site.class.getResourceAsStream("site.css")) {
            Files.copy(style, folder.resolve("site.css"), StandardCopyOption.REPLACE_EXISTING);
        }
        copy("src/web/resources/web/icon.svg", "icon.svg");
        copy("assets/fonts/Quicksand-Bold.ttf", "fonts/words.ttf");
        copy("assets/fonts/Quicksand-LICENCE.txt", "fonts/words-licence.txt");
        copy("assets/fonts/JetBrainsMono-Medium.ttf", "fonts/numbers.ttf");
        copy("assets/fonts/JetBrainsMono-LICENCE.txt", "fonts/numbers-licence.txt");
    }

    private void copy(String from, String to) throws IOException {
        Path file = folder.resolve(to);
        Files.createDirectories(file.getParent());
        Files.copy(home.resolve(from), file, StandardCopyOption.REPLACE_EXISTING);
    }
}
