package rigibo.frontend.puzzle.hud;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;

/** The par is worded as a medal's condition, never as a limit. */
class CountsTest {

    @Test
    void theBestMedalThatIsStillToBeHadStandsBelowTheClicks() {
        PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());
        assertThat(played.texts()).contains("0 clicks 0.0 s", "gold with 1 click");
        played.clickWall().turns(60).clickBox().turns(2);
        assertThat(played.texts()).contains("silver with 2 clicks");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void thePointerAsksWhatItMeans(String language) {
        PlayedLevel played = new PlayedLevel(Levels.all().get(0), language, Motion.FULL);
        String gold = language.equals("en") ? "Gold with 2 clicks," : "Gold mit 2 Klicks,";
        assertThat(played.texts()).noneMatch(line -> line.startsWith(gold));
        played.scene.pointerMoved(Scene.WIDTH - 80, 30);
        assertThat(played.texts()).anyMatch(line -> line.startsWith(gold));
        assertThat(Legibility.faults(played.scene)).isEmpty();
        played.scene.pointerMoved(Scene.WIDTH - 80, 300);
        assertThat(played.texts()).noneMatch(line -> line.startsWith(gold));
    }
}
