package rigibo.frontend.menu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;

import java.time.LocalDate;

/**
 * What the menu, the levels and the settings tell a player who does not see them, and which
 * controls they name.
 */
class NarrationTest {

    private static final double ROUND_OFF = 1e-9;

    private final RecordingDirector director = new RecordingDirector();

    private static RecordingNarrator told(Scene scene) {
        RecordingCanvas.of(scene);
        return RecordingNarrator.of(scene);
    }

    @Test
    void theMenusButtonsHaveNamesAndCanBePressed() {
        MenuScene menu = Entries.menu(director, Entries.all(3));
        RecordingNarrator told = told(menu);
        assertThat(told.names()).contains("Levels", "Statistics", "Settings");
        RecordingNarrator.press(menu, told.control("Settings"));
        assertThat(director.shown.get(0)).isInstanceOf(SettingsScene.class);
        assertThat(told(menu).control("Settings").isChosen()).isTrue();
    }

    @Test
    void aNoticeIsSaidAndTheOnlyThingToPress() {
        director.tell("A file was damaged.");
        MenuScene menu = Entries.menu(director, Entries.all(3));
        RecordingNarrator told = told(menu);
        assertThat(told.said()).containsExactly("A file was damaged.");
        assertThat(told.controls()).hasSize(1);
        RecordingNarrator.press(menu, told.controls().get(0));
        assertThat(told(menu).names()).contains("Levels");
    }

    @Test
    void levelsTellTheirMedalsAndWhatOpensThem() {
        director.progress(
                Progress.none()
                        .solved("level0", Entries.HASH, Entries.PAR)
                        .starred("level0", Entries.HASH));
        LevelsScene levels = new LevelsScene(director, Entries.levels(15), Entries.made());
        assertThat(told(levels).names())
                .contains("1 A level of a very long title, 0, gold, star")
                .contains("2 A level of a very long title, 1");
        for (int i = 0; i < 8; i++) {
            levels.keyPressed(Key.TAB);
        }
        assertThat(told(levels).said())
                .containsExactly("Opens when 7 levels of this world are solved");
    }

    @Test
    void statisticsSayEveryNumber() {
        director.progress(Progress.none().solved("level0", Entries.HASH, Entries.PAR));
        LocalDate today = LocalDate.of(2026, 11, 28);
        Scene statistics = new StatisticsScene(director, Entries.levels(15), today);
        assertThat(told(statistics).said()).contains("1 of 15 solved", "gold: 1", "silver: 0");
        assertThat(told(statistics).names()).containsExactly("Menu");
    }

    @Test
    void settingsTellWhatIsOnAndHowMuch() {
        SettingsScene settings = new SettingsScene(director);
        RecordingNarrator told = told(settings);
        Control volume = told.control("Volume: 70 %");
        assertThat(volume.kind()).isEqualTo(Control.Kind.SLIDER);
        assertThat(volume.share()).isCloseTo(0.7, within(ROUND_OFF));
        Control calm = calm(told);
        assertThat(calm.kind()).isEqualTo(Control.Kind.OFF);
        RecordingNarrator.press(settings, calm);
        assertThat(director.settings().motion()).isEqualTo(Settings.Motion.REDUCED);
        assertThat(calm(told(settings)).kind()).isEqualTo(Control.Kind.ON);
        RecordingNarrator.press(settings, told.control("Language: English"));
        assertThat(director.settings().language()).isEqualTo("de");
    }

    private Control calm(RecordingNarrator told) {
        return told.control(director.words().of("settings.calm"));
    }
}
