package rigibo.frontend.menu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.widget.Widget;

import java.time.LocalDate;
import java.util.List;
import java.util.stream.Stream;

/** Menu, levels and settings, used as a player does, by what is drawn. */
class MenuScenesTest {

    private static final String NOTICE =
            "progress.json was damaged. Folder: "
                    + "/home/someone/with/a/very/long/name/of/a/home/directory/indeed/.local/share";

    private static final double ROUND_OFF = 1e-9;

    private final RecordingDirector director = new RecordingDirector();

    private static void press(Scene scene, Key... keys) {
        for (Key key : keys) {
            scene.keyPressed(key);
        }
    }

    private String shown() {
        return director.shown.get(director.shown.size() - 1).title();
    }

    /** Every world has one, beside its sentence; with little motion it stands still. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void thePictureOfAWorldMovesUnlessThatIsNotWanted(String language) {
        director.settings(director.settings().withLanguage(language));
        for (int world = 1; world <= 4; world++) {
            assertThat(moves(world)).as("world %s", world).isTrue();
        }
        director.settings(director.settings().withMotion(Settings.Motion.REDUCED));
        for (int world = 1; world <= 4; world++) {
            assertThat(moves(world)).as("world %s, little motion", world).isFalse();
        }
    }

    /** Whether what a world's page shows changes within a second or two. */
    private boolean moves(int world) {
        LevelsScene scene = new LevelsScene(director, Levels.entries(), List.of());
        for (int i = 1; i < world; i++) {
            press(scene, Key.RIGHT_BRACKET);
        }
        RecordingCanvas before = RecordingCanvas.of(scene);
        for (int i = 0; i < 130; i++) {
            scene.step();
        }
        RecordingCanvas after = RecordingCanvas.of(scene);
        return !before.lines().equals(after.lines());
    }

    @Test
    void levelsOnTheMoonAreShownThere() {
        LevelsScene scene = new LevelsScene(director, Levels.entries(), List.of());
        assertThat(RecordingCanvas.of(scene).sceneries()).isEmpty();
        press(scene, Key.RIGHT_BRACKET, Key.RIGHT_BRACKET, Key.RIGHT_BRACKET);
        assertThat(RecordingCanvas.of(scene).sceneries())
                .as("of Moon and of Solar Wind")
                .containsExactly(Scenery.MOON, Scenery.MOON);
    }

    @Test
    void theBestRunOfASolvedLevelCanBeWatched() {
        director.progress(Progress.none().solved("level0", Entries.HASH, 1));
        LevelsScene scene = new LevelsScene(director, Entries.levels(3), Entries.made());
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("Watch your best (V)");
        press(scene, Key.LEFT);
        click(scene, "Watch your best (V)");
        assertThat(shown()).isEqualTo("run of level0");
        assertLegible(scene);
    }

    @Test
    void whereNoRunWasKeptTheListSaysSo() {
        director.progress(Progress.none().solved("level1", Entries.HASH, 1));
        LevelsScene scene = new LevelsScene(director, Entries.levels(3), Entries.made());
        press(scene, Key.RIGHT, Key.V);
        assertThat(RecordingCanvas.of(scene).texts()).contains("No run of it was kept");
        assertThat(director.shown).isEmpty();
        assertLegible(scene);
    }

    @Test
    void escapeAsksBeforeItQuits() {
        MenuScene menu = Entries.menu(director, Entries.all(3));
        assertThat(menu.escaped()).as("asks").isTrue();
        assertThat(director.said).containsExactly("Esc or Enter again quits");
        press(menu, Key.UP);
        assertThat(menu.escaped()).as("asks anew").isTrue();
        assertThat(menu.escaped()).as("quits").isFalse();
        press(menu, Key.ENTER);
        assertThat(director.asked).containsExactly("quit");
    }

    @Test
    void codesArePastedByAButton() {
        LevelsScene scene = new LevelsScene(director, Entries.levels(3), Entries.made());
        click(scene, "Paste code");
        assertThat(director.asked).containsExactly("paste");
        assertLegible(scene);
    }

    @Test
    void levelsMadeByChanceAreAboveTheList() {
        LevelsScene scene = new LevelsScene(director, Entries.levels(15), Entries.made());
        click(scene, "Level of the day");
        assertThat(shown()).isEqualTo("daily");
        assertThat(RecordingCanvas.of(scene).texts())
                .contains("The same for everybody, a new one each day");
        press(scene, Key.TAB, Key.ENTER);
        assertThat(shown()).isEqualTo("endless");
        assertLegible(scene);
    }

    private static void assertLegible(Scene scene) {
        assertThat(Legibility.faults(scene)).as(scene.title()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everythingCanBeRead(String language) {
        RecordingDirector told = new RecordingDirector(language);
        told.progress(
                Progress.none()
                        .solved("level0", Entries.HASH, 1)
                        .solved("level1", Entries.HASH, 3)
                        .solved("level2", Entries.HASH, 9)
                        .starred("level2", Entries.HASH)
                        .solved("level3", 0, 1));
        assertLegible(Entries.menu(told, Entries.all(15)));
        assertLegible(new LevelsScene(told, Entries.all(15), Entries.made()));
        told.progress(told.progress().solved("level15", Entries.HASH, 1).solved("level17", 0, 1));
        LevelsScene levels = new LevelsScene(told, Entries.all(40), Entries.made());
        for (int world = 1; world <= 4; world++) {
            assertLegible(levels);
            levels.keyPressed(Key.RIGHT_BRACKET);
        }
        assertLegible(new SettingsScene(told));
        told.tell(NOTICE);
        told.tell(NOTICE);
        assertLegible(Entries.menu(told, Entries.all(15)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everythingCanBeReadInAHand(String language) {
        RecordingDirector told = new RecordingDirector(language);
        told.progress(
                Progress.none()
                        .solved("level0", Entries.HASH, 1)
                        .solved("level1", Entries.HASH, 3)
                        .starred("level1", Entries.HASH)
                        .solved("level3", 0, 1));
        assertLegibleInHand(Entries.menu(told, Entries.all(15)));
        LevelsScene levels = new LevelsScene(told, Entries.all(40), Entries.made());
        for (int world = 1; world <= 4; world++) {
            assertLegibleInHand(levels);
            levels.keyPressed(Key.RIGHT_BRACKET);
        }
        assertLegibleInHand(new SettingsScene(told));
        assertLegibleInHand(new KeysScene(told));
        assertLegibleInHand(new StatisticsScene(told, Entries.all(40), LocalDate.EPOCH));
        told.tell(NOTICE);
        assertLegibleInHand(Entries.menu(told, Entries.all(15)));
    }

    private static void assertLegibleInHand(Scene scene) {
        assertThat(Legibility.faultsInHand(scene)).as(scene.title()).isEmpty();
    }

    @Test
    void whatIsTouchedIsAsLargeAsAFinger() {
        for (Layout layout : Legibility.HANDS) {
            double least = 44 / layout.ratio() - ROUND_OFF;
            MenuPlaces menu = MenuPlaces.of(layout);
            LevelsPlaces levels = LevelsPlaces.of(layout, true);
            assertThat(
                            Stream.of(
                                    menu.play(),
                                    menu.row(),
                                    menu.cards().first(),
                                    levels.buttons().first(),
                                    levels.made(),
                                    levels.tabs().first(),
                                    levels.cards().first(),
                                    levels.watch()))
                    .allMatch(plate -> plate.height() >= least && plate.width() >= least);
            assertThat(Widget.row(layout)).isGreaterThanOrEqualTo(least);
            Layout sheet = layout.sheet();
            KeysPlaces keys = KeysPlaces.of(sheet);
            assertThat(
                            Stream.of(
                                    keys.levels().first(),
                                    keys.demos().first(),
                                    keys.reset(),
                                    keys.back(),
                                    StatisticsPlaces.of(sheet).back()))
                    .allMatch(
                            plate ->
                                    Math.min(plate.height(), plate.width()) * sheet.ratio()
                                            > 43.99);
        }
    }

    @Test
    void whoeverHasSolvedEverythingIsThanked() {
        director.progress(Progress.none().solved("level0", Entries.HASH, 1));
        assertThat(RecordingCanvas.of(Entries.menu(director, Entries.all(2))).texts())
                .contains("Continue")
                .doesNotContain("Play again");
        director.progress(director.progress().solved("level1", Entries.HASH, 1));
        MenuScene scene = Entries.menu(director, Entries.all(2));
        assertThat(RecordingCanvas.of(scene).texts())
                .contains("Play again", "All 2 levels solved. Thank you for playing!");
        assertLegible(scene);
    }

    @Test
    void whoeverHasSolvedEverythingGoesOnWithEndlessLevels() {
        assertThat(RecordingCanvas.of(Entries.menu(director, Entries.all(1))).texts())
                .doesNotContain("Endless");
        director.progress(Progress.none().solved("level0", Entries.HASH, 1).endless(12));
        MenuScene menu = Entries.menu(director, Entries.all(1));
        assertThat(RecordingCanvas.of(menu).texts()).contains("Endless", "No. 12");
        press(menu, Key.ENTER);
        assertThat(shown()).isEqualTo("endless");
        press(Entries.menu(director, Entries.all(1)), Key.RIGHT, Key.ENTER);
        assertThat(shown()).isEqualTo("level0");
        click(Entries.menu(director, Entries.all(1)), "Endless");
        assertThat(shown()).isEqualTo("endless");
        assertLegibleInHand(menu);
    }

    @Test
    void playGoesOnWithTheNextLevelByEnterAlone() {
        press(Entries.menu(director, Entries.all(6)), Key.ENTER);
        assertThat(shown()).isEqualTo("level0");
        director.progress(Progress.none().solved("level0", Entries.HASH, 2));
        MenuScene menu = Entries.menu(director, Entries.all(6));
        click(menu, "Continue");
        assertThat(shown()).isEqualTo("level1");
    }

    @Test
    void everyTileOfTheMenuIsReachedByArrowsAndByTab() {
        press(Entries.menu(director, Entries.all(6)), Key.DOWN, Key.DOWN, Key.DOWN, Key.ENTER);
        assertThat(shown()).isIn("wheel", "crate", "friction", "flood");
        press(Entries.menu(director, Entries.all(6)), Key.TAB, Key.TAB, Key.ENTER);
        assertThat(shown()).isEqualTo("RigiBo – Statistics");
        press(Entries.menu(director, Entries.all(6)), Key.TAB, Key.TAB, Key.TAB, Key.ENTER);
        assertThat(shown()).isEqualTo("RigiBo – Settings");
        press(Entries.menu(director, Entries.all(6)), Key.TAB, Key.ENTER);
        assertThat(director.asked).containsExactly("levels");
        press(
                Entries.menu(director, Entries.all(6)),
                Key.TAB,
                Key.TAB,
                Key.TAB,
                Key.TAB,
                Key.ENTER);
        assertThat(director.asked).containsExactly("levels", "quit");
    }

    @Test
    void aClickOpensADemo() {
        click(Entries.menu(director, Entries.all(6)), "Flood");
        assertThat(shown()).isEqualTo("flood");
    }

    @Test
    void withoutLevelsTheRestOfTheMenuWorks() {
        click(Entries.menu(director, Entries.all(0)), "Crate");
        assertThat(shown()).isEqualTo("crate");
        press(new LevelsScene(director, Entries.all(0), List.of()), Key.DOWN, Key.ENTER);
        assertThat(director.asked).containsExactly("menu");
    }

    @Test
    void aNoticeStandsBeforeEverythingUntilItIsRead() {
        director.tell(NOTICE);
        MenuScene menu = Entries.menu(director, Entries.all(6));
        assertThat(RecordingCanvas.of(menu).texts()).contains("Understood (Enter)");
        press(menu, Key.DOWN, Key.ENTER);
        assertThat(director.shown).isEmpty();
        assertThat(director.notices()).isEmpty();
        assertThat(RecordingCanvas.of(menu).texts()).doesNotContain("Understood (Enter)");
        press(menu, Key.ENTER);
        assertThat(shown()).isEqualTo("level0");
    }

    @Test
    void escReadsANoticeBeforeItLeaves() {
        director.tell(NOTICE);
        MenuScene menu = Entries.menu(director, Entries.all(6));
        assertThat(menu.escaped()).isTrue();
        assertThat(director.notices()).isEmpty();
        assertThat(director.said).as("asked whether to quit").isEmpty();
    }

    @Test
    void arrowsGoThroughTheGridOfLevels() {
        director.progress(allSolved(15));
        LevelsScene levels = new LevelsScene(director, Entries.levels(15), Entries.made());
        press(levels, Key.RIGHT, Key.DOWN, Key.ENTER);
        assertThat(shown()).isEqualTo("level5");
        press(levels, Key.LEFT, Key.UP, Key.UP, Key.UP, Key.UP, Key.ENTER);
        assertThat(director.asked).containsExactly("menu");
    }

    private static Progress allSolved(int count) {
        Progress progress = Progress.none();
        for (int i = 0; i < count; i++) {
            progress = progress.solved("level" + i, Entries.HASH, Entries.PAR);
        }
        return progress;
    }

    @Test
    void aLockedLevelSaysWhatOpensItAndStaysClosed() {
        LevelsScene levels = new LevelsScene(director, Entries.levels(15), Entries.made());
        press(levels, Key.DOWN, Key.ENTER);
        assertThat(director.shown).isEmpty();
        assertThat(RecordingCanvas.of(levels).texts())
                .contains("Opens when 2 levels of this world are solved");
    }

    @Test
    void worldsAreTurnedByTabsKeysAndTheWheel() {
        director.progress(allSolved(12));
        LevelsScene levels = new LevelsScene(director, Entries.levels(40), Entries.made());
        press(levels, Key.RIGHT, Key.ENTER);
        assertThat(shown()).isEqualTo("level13");
        click(levels, "Boxes");
        press(levels, Key.DOWN, Key.ENTER);
        assertThat(shown()).isEqualTo("level0");
        press(levels, Key.RIGHT_BRACKET, Key.RIGHT_BRACKET, Key.DOWN, Key.ENTER);
        assertThat(shown()).isEqualTo("level22");
        levels.scrolled(-1, 0, 0);
        press(levels, Key.DOWN, Key.ENTER);
        assertThat(director.shown).as("nothing opens in a closed world").hasSize(3);
        assertThat(RecordingCanvas.of(levels).texts())
                .contains("Opens with 18 levels solved, 12 so far");
        assertLegible(levels);
    }

    @Test
    void aLanguageHoldsAtOnce() {
        SettingsScene scene = new SettingsScene(director);
        press(scene, Key.DOWN, Key.RIGHT);
        assertThat(director.settings().language()).isEqualTo("de");
        assertThat(RecordingCanvas.of(scene).texts())
                .contains("Lautstärke")
                .doesNotContain("Volume");
        press(scene, Key.RIGHT);
        assertThat(director.settings().language()).as("the same row is chosen").isEqualTo("en");
    }

    @Test
    void everySettingIsChangedByKeysAlone() {
        SettingsScene scene = new SettingsScene(director);
        press(scene, Key.DOWN, Key.DOWN, Key.LEFT);
        press(scene, Key.DOWN, Key.LEFT);
        press(scene, Key.DOWN, Key.ENTER);
        press(scene, Key.DOWN, Key.ENTER);
        press(scene, Key.DOWN, Key.RIGHT);
        press(scene, Key.DOWN, Key.RIGHT);
        press(scene, Key.DOWN, Key.ENTER);
        Settings settings = director.settings();
        assertThat(settings.volume()).isCloseTo(0.65, within(1e-12));
        assertThat(settings.music()).isCloseTo(0.45, within(1e-12));
        assertThat(settings.isMuted()).isTrue();
        assertThat(settings.motion()).isEqualTo(Settings.Motion.REDUCED);
        assertThat(settings.detail()).isEqualTo(Settings.Detail.FULL);
        assertThat(settings.text()).isEqualTo(Settings.TextSize.LARGE);
        assertThat(settings.isFullScreen()).isTrue();
        press(scene, Key.DOWN, Key.ENTER);
        assertThat(shown()).isEqualTo("RigiBo – Keys");
        press(scene, Key.DOWN, Key.ENTER);
        assertThat(director.asked).containsExactly("menu");
    }

    @Test
    void theVolumeIsDragged() {
        SettingsScene scene = new SettingsScene(director);
        double[] at = RecordingCanvas.of(scene).middleOf("Volume");
        scene.pointerPressed(PointerButton.LEFT, at[0], at[1]);
        scene.pointerMoved(Scene.WIDTH, at[1]);
        assertThat(director.settings().volume()).isEqualTo(1);
        scene.pointerMoved(0, at[1]);
        assertThat(director.settings().volume()).isZero();
        scene.pointerReleased(PointerButton.LEFT, 0, at[1]);
        scene.pointerMoved(Scene.WIDTH, at[1]);
        assertThat(director.settings().volume()).isZero();
    }
}
