package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** A file of the game that is gone or broken is told in one line that names it. */
class BrokenAssetsTest {

    private static final String HOME = "rigibo.home";

    private final String whole = System.getProperty(HOME, ".");
    @TempDir Path broken;

    @BeforeEach
    void bringAHomeThatMayBeBroken() throws IOException {
        Path from = Path.of(whole, "assets");
        List<Path> all;
        try (Stream<Path> found = Files.walk(from)) {
            all = found.toList();
        }
        for (Path one : all) {
            Files.copy(one, broken.resolve("assets").resolve(from.relativize(one).toString()));
        }
        System.setProperty(HOME, broken.toString());
    }

    @AfterEach
    void goHome() {
        System.setProperty(HOME, whole);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "fonts/Quicksand-Bold.ttf",
                "shaders/plate.vert.glsl",
                "shaders/skin.frag.glsl",
                "shaders/workshop.frag.glsl"
            })
    void oneThatIsMissing(String asset) throws IOException {
        Files.delete(place(asset));
        assertToldAs(asset, "is missing");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "garbage"})
    void aFontThatIsNone(String content) throws IOException {
        Files.writeString(place("fonts/JetBrainsMono-Medium.ttf"), content);
        assertToldAs("fonts/JetBrainsMono-Medium.ttf", "is no font");
    }

    /** The text renderer would follow an invalid offset and end the process. */
    @Test
    void aFontThatEndsEarly() throws IOException {
        Path font = place("fonts/Quicksand-Bold.ttf");
        byte[] bytes = Files.readAllBytes(font);
        Files.write(font, Arrays.copyOf(bytes, bytes.length * 3 / 5));
        assertToldAs("fonts/Quicksand-Bold.ttf", "is no font, or a damaged one");
    }

    @Test
    void aFontWithOneByteChanged() throws IOException {
        Path font = place("fonts/Quicksand-Bold.ttf");
        byte[] bytes = Files.readAllBytes(font);
        bytes[40] ^= 1;
        Files.write(font, bytes);
        assertToldAs("fonts/Quicksand-Bold.ttf", "is no font, or a damaged one");
    }

    @Test
    void aShaderThatDoesNotCompile() throws IOException {
        Path shader = place("shaders/plate.frag.glsl");
        Files.writeString(shader, Files.readString(shader) + "garbage");
        assertToldAs("shaders/plate.frag.glsl", "is no shader: .+");
    }

    @Test
    void aShaderThatIsNoText() throws IOException {
        Files.write(place("shaders/skin.frag.glsl"), new byte[] {-1, -2, 0});
        assertToldAs("shaders/skin.frag.glsl", "is no text");
    }

    private Path place(String asset) {
        return broken.resolve("assets").resolve(asset);
    }

    private void assertToldAs(String asset, String pattern) {
        Display display = new Display(OneBox::new, false);
        assertThatThrownBy(() -> display.run(null))
                .isInstanceOf(DisplayException.class)
                .message()
                .contains(place(asset).toString())
                .containsPattern(pattern)
                .doesNotContain("\n");
    }

    /** Draws a box, so that every kind of asset is asked for, and leaves. */
    private record OneBox(Director director) implements Scene {

        @Override
        public String title() {
            return "One box";
        }

        @Override
        public void step() {}

        @Override
        public void draw(Canvas canvas) {
            canvas.camera(Camera.ofPuzzle());
            canvas.body(Polygon.box(1, 1), 2, 2, 0, Skin.WOOD, Canvas.Mood.PLAIN);
            director.quit();
        }
    }
}
