package rigibo.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Offscreen;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** Real OpenGL, in a framebuffer of its own. */
class FilmTest {

    @TempDir Path folder;

    @Test
    void aSolvedLevelIsAFilmOfAFewHundredKilobytes() throws IOException {
        Path file = folder.resolve("a.gif");
        try (Offscreen screen = new Offscreen(360, 400)) {
            int frames = new Film(Catalog.film("two-storeys"), screen).write(file, "en");
            // A hold takes 3 s and the curtain as long: at 20 frames a second, 120 and more.
            assertThat(frames).isGreaterThan(120);
            assertThat(screen.troubles()).isEmpty();
        }
        assertThat(Files.size(file)).isBetween(20_000L, 3_000_000L);
    }

    @Test
    void pictureHoldsTheSceneFromItsFirstFrameOn() {
        try (Offscreen screen = new Offscreen(360, 400)) {
            Scene scene = Catalog.film("two-storeys").apply(new RecordingDirector());
            int[] first = screen.picture(scene, 0);
            assertThat(Arrays.stream(first).distinct().count()).isGreaterThan(100);
            assertThat(screen.picture(scene, 0)).isEqualTo(first);
        }
    }

    @Test
    void whatDoesNotExistIsRefusedWithWhatDoes() {
        assertThatThrownBy(() -> Catalog.film("three-storeys"))
                .hasMessageContaining("There is no level 'three-storeys'")
                .hasMessageContaining("two-storeys");
        assertThatThrownBy(() -> Catalog.film("none.replay.json"))
                .hasMessageContaining("there is no such file");
    }
}
