package rigibo.docs;

import rigibo.tutorial.TutorialPictures;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** Writes anew what pages show and nobody writes by hand: {@code ./rigibo docs}. */
public final class DocsWriter {

    static final String SURFACE = "docs/api.txt";

    private DocsWriter() {}

    /** Writes all of it into the checkout. */
    public static void main(String[] arguments) throws IOException, URISyntaxException {
        Path home = Path.of(System.getProperty("rigibo.home", ""));
        write(home.resolve(SURFACE), ApiSurface.text(home));
        write(home.resolve(RoomSizes.PAGE), RoomSizes.page(home));
        write(home.resolve("docs/pictures/step.svg"), StepPicture.svg());
        for (Map.Entry<String, String> picture : TutorialPictures.all().entrySet()) {
            write(home.resolve("docs/tutorial/pictures/" + picture.getKey()), picture.getValue());
        }
    }

    private static void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        System.out.println(file);
    }
}
