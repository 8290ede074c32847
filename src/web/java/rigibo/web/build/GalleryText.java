package rigibo.web.build;

import rigibo.frontend.gallery.Exhibit;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.ServiceLoader;
import java.util.stream.Collectors;

/** The gallery's page in a language: its words, and the titles of all exhibits in their order. */
final class GalleryText {

    private GalleryText() {}

    static void write(Path page, Locale language) throws IOException {
        ResourceBundle words = bundle("rigibo.web", language);
        String text;
        try (InputStream template = GalleryText.class.getResourceAsStream("/web/gallery.html")) {
            text = new String(template.readAllBytes(), StandardCharsets.UTF_8);
        }
        for (String key : words.keySet()) {
            text = text.replace("{" + key + "}", escaped(words.getString(key)));
        }
        Files.writeString(page, text.replace("{scenes}", scenes(language)));
    }

    private static String scenes(Locale language) {
        ResourceBundle titles = bundle("rigibo.gallery", language);
        return ServiceLoader.load(Exhibit.class).stream()
                .map(provider -> Exhibit.name(provider.type()))
                .map(name -> titles.containsKey(name) ? titles.getString(name) : name)
                .map(title -> "<option>" + escaped(title) + "</option>")
                .collect(Collectors.joining("\n"));
    }

    private static ResourceBundle bundle(String name, Locale language) {
        return ResourceBundle.getBundle(
                name,
                language,
                ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_DEFAULT));
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }
}
