package rigibo.frontend.catalog;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.util.stream.Stream;

class CatalogTest {

    /** The command line opens a scene by its name, and a tour keeps its picture under it. */
    @Test
    void noTwoScenesShareAName() {
        assertThat(Stream.concat(Catalog.entries().stream(), Catalog.exhibits().stream()))
                .extracting(SceneEntry::name)
                .hasSizeGreaterThan(100)
                .doesNotHaveDuplicates();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void theMenuHasRoomForItsWordsHoweverLarge(String language) {
        Scene menu = Catalog.menu(new RecordingDirector(language));
        Layout large = Layout.ALONE.withText(1.3, menu.mostType());
        assertThat(RecordingCanvas.of(menu, large).texts()).noneMatch(words -> words.endsWith("…"));
    }
}
