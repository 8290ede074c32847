package rigibo.docs.site;

import rigibo.frontend.gallery.ExhibitWords;
import rigibo.frontend.gallery.Exhibits;
import rigibo.frontend.gallery.Found;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The gallery: all exhibits as cards, and a page for each with its picture and its source. */
final class GalleryPages {

    static final Path FOLDER = Path.of("gallery");

    private final Path home;
    private final Path folder;
    private final Layout layout;
    private final ExhibitWords words = new ExhibitWords(new Words("en"));

    /** From a checkout into a folder. */
    GalleryPages(Path home, Path folder, Layout layout) {
        this.home = home;
        this.folder = folder;
        this.layout = layout;
    }

    /** The page of an exhibit. */
    static Path page(String name) {
        return FOLDER.resolve(name + ".html");
    }

    /** Writes all of it; exhibits are shown as they are after so many seconds. */
    void write(double seconds) throws IOException {
        Files.createDirectories(folder.resolve(FOLDER));
        StringBuilder body = new StringBuilder("<h1>Gallery</h1>\n");
        body.append(
                """
                <p>Small programs that need nothing but the engine: examples, and samples of Box2D v3 \
                and dyn4j rebuilt from what they show. The game shows them moving: \
                <code>./rigibo play --scene gallery</code>.</p>
                """);
        for (Map.Entry<String, List<Found>> section : Exhibits.bySection().entrySet()) {
            String title = Html.escaped(words.section(section.getKey()));
            body.append("<h2 id=\"").append(section.getKey()).append("\">").append(title);
            body.append("</h2>\n<div class=\"cards\">\n");
            for (Found found : section.getValue()) {
                body.append(card(found));
                write(found, seconds);
            }
            body.append("</div>\n");
        }
        layout.write(Address.ofFolder(FOLDER), "Gallery", body.toString());
    }

    private String card(Found found) {
        String title = Html.escaped(words.title(found));
        String about = Html.escaped(words.about(found));
        String picture = Html.picture(found.name() + ".svg", "");
        String link = Html.link(found.name() + ".html", picture + "<b>" + title + "</b>");
        return "<div class=\"card\">" + link + "<span>" + about + "</span></div>\n";
    }

    private void write(Found found, double seconds) throws IOException {
        String picture = found.name() + ".svg";
        Files.writeString(
                folder.resolve(FOLDER).resolve(picture),
                ExhibitFigure.svg(found.make().get(), seconds));
        String title = words.title(found);
        String body =
                """
                <h1>%s</h1>
                <p>%s.</p>
                <p><img class="exhibit" src="%s" alt="%s"></p>
                <p>See it move: <code>./rigibo play --scene %s</code>. Its source, <code>%s</code>:</p>
                """
                        .formatted(
                                Html.escaped(title),
                                Html.escaped(words.about(found)),
                                picture,
                                Html.escaped(title),
                                found.name(),
                                found.source());
        String source = Files.readString(home.resolve(found.source()));
        layout.write(page(found.name()), title, body + Source.html(found.source(), source));
    }
}
