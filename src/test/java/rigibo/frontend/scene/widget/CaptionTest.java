package rigibo.frontend.scene.widget;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Titles on cards are whole. */
class CaptionTest {

    private static final Layout LARGE_LETTERS = Layout.of(720, 800, 1).withText(1.3, 1.3);

    /** A card in the list of levels. */
    private static final Tile CARD =
            Tile.at(new Plate(0, 0, 162, 168), "card", (canvas, tile, isChosen) -> {}, () -> {});

    private record Captions(List<String> titles, List<Caption> made) implements Scene {

        @Override
        public String title() {
            return "captions";
        }

        @Override
        public void step() {}

        @Override
        public void draw(Canvas canvas) {
            titles.forEach(title -> made.add(Caption.of(canvas, title, CARD)));
        }
    }

    /** A word that is wider than its line would be broken anywhere. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void noWordOfALevelsTitleIsBroken(String language) {
        Locale locale = Locale.forLanguageTag(language);
        List<String> titles = Levels.all().stream().map(level -> level.title().in(locale)).toList();
        Captions captions = new Captions(titles, new ArrayList<>());
        RecordingCanvas.of(captions, LARGE_LETTERS);
        for (int i = 0; i < titles.size(); i++) {
            assertThat(String.join(" ", captions.made().get(i).lines())).isEqualTo(titles.get(i));
        }
    }
}
