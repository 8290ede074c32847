package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LayoutTest {

    private static final double ROUND_OFF = 1e-9;

    @Test
    void aWindowOfTheScenesOwnShapeShowsNothingElse() {
        assertThat(Layout.of(1440, 1600, 2)).isEqualTo(new Layout(0, 0, 720, 800, 2, 1));
    }

    /** As wide as the window at 800 logical px of height, with the scene in its middle. */
    @ParameterizedTest
    @CsvSource({"800, 600", "1280, 800", "1366, 768", "1920, 1080", "1000, 1000"})
    void aWideWindowShowsMoreOnBothSides(int width, int height) {
        Layout layout = Layout.of(width, height, 1);
        assertThat(layout.top()).isZero();
        assertThat(layout.height()).isEqualTo(800);
        assertThat(layout.width()).isCloseTo(800.0 * width / height, within(ROUND_OFF));
        assertThat(layout.right() - 720).isCloseTo(-layout.left(), within(ROUND_OFF));
        assertThat(layout.ratio()).isEqualTo(height / 800.0);
    }

    @Test
    void aHighWindowShowsMoreAboveAndBelow() {
        Layout layout = Layout.of(720, 1600, 1);
        assertThat(layout).isEqualTo(new Layout(0, -400, 720, 1600, 1, 1));
        assertThat(layout.bottom()).isEqualTo(1200);
    }

    /** 280 logical px are a column with its gaps: 5 : 4 has just as many beside the scene. */
    @ParameterizedTest
    @CsvSource({
        "720, 800, 0, 0",
        "999, 800, -139.5, 0",
        "1000, 800, -280, 1",
        "1024, 768, -346.667, 1",
        "1279, 800, -559, 1",
        "1280, 800, -280, 2",
        "1920, 1080, -351.111, 2",
    })
    void columnsStandWhereTheyHaveRoom(int width, int height, double left, int columns) {
        Layout layout = Layout.of(width, height, 1).withColumns();
        assertThat(layout.left()).isCloseTo(left, within(1e-3));
        assertThat(layout.columns()).isEqualTo(columns);
        if (columns > 0) {
            assertThat(layout.leftColumn()).isGreaterThanOrEqualTo(layout.left());
            assertThat(layout.leftColumn() + layout.columnWidth()).isLessThan(0);
        }
        if (columns > 1) {
            assertThat(layout.rightColumn()).isGreaterThan(720);
            assertThat(layout.rightColumn() + layout.columnWidth()).isLessThan(layout.right());
        }
    }

    /** Below its usual size a scene shrinks to 0.85 of it, and text of 16 px stays as it is. */
    @ParameterizedTest
    @CsvSource({"720, 800, 1, 16", "684, 760, 1, 16.842", "612, 680, 1, 18.824"})
    void smallTextDoesNotShrinkWithTheWindow(
            int width, int height, double contentScale, double drawn) {
        Layout layout = Layout.of(width, height, contentScale);
        assertThat(layout.textSize(16)).isCloseTo(drawn, within(1e-3));
        assertThat(layout.textSize(16) * layout.ratio()).isCloseTo(16, within(ROUND_OFF));
        assertThat(layout.textSize(40)).isEqualTo(40);
    }

    @Test
    void textIsAsLargeAsItsScreenAsksFor() {
        // Twice as many pixels an inch: the window of 680 units' height has 1360 of them.
        assertThat(Layout.of(1224, 1360, 2).textSize(16)).isEqualTo(16 / 0.85);
        assertThat(Layout.of(1440, 1600, 2).textSize(16)).isEqualTo(16);
    }

    /** There is no smaller window; where a window manager makes one all the same, all shrinks. */
    @Test
    void textGrowsNoFurtherInAWindowThatIsSmallerStill() {
        assertThat(Layout.of(360, 400, 1).textSize(16)).isEqualTo(16 / 0.85);
    }

    @ParameterizedTest
    @CsvSource({"612, 680", "720, 800", "1024, 768", "1366, 768", "1920, 1080", "720, 1600"})
    void thePointerIsWhereItWasSeen(int width, int height) {
        for (Layout layout :
                new Layout[] {
                    Layout.of(width, height, 1), Layout.of(width, height, 1).withColumns()
                }) {
            assertThat(layout.logicalX(0)).isCloseTo(layout.left(), within(ROUND_OFF));
            assertThat(layout.logicalX(width)).isCloseTo(layout.right(), within(ROUND_OFF));
            assertThat(layout.logicalY(0)).isCloseTo(layout.top(), within(ROUND_OFF));
            assertThat(layout.logicalY(height)).isCloseTo(layout.bottom(), within(ROUND_OFF));
            assertThat(layout.logicalX(layout.windowX(123))).isCloseTo(123, within(ROUND_OFF));
            assertThat(layout.logicalY(layout.windowY(456))).isCloseTo(456, within(ROUND_OFF));
        }
    }

    @Test
    void showsWhatReachesIntoTheWindow() {
        Layout layout = Layout.of(1280, 800, 1);
        assertThat(layout.shows(-279, 400, 0)).isTrue();
        assertThat(layout.shows(-285, 400, 10)).isTrue();
        assertThat(layout.shows(-295, 400, 10)).isFalse();
        assertThat(layout.shows(999, 400, 0)).isTrue();
        assertThat(layout.shows(1011, 400, 10)).isFalse();
        assertThat(layout.shows(300, 811, 10)).isFalse();
    }

    @Test
    void survivesAWindowOfNoSize() {
        Layout none = Layout.of(0, 0, 1);
        assertThat(none.width() * none.ratio()).isPositive();
        assertThat(none.height() * none.ratio()).isPositive();
    }

    /** Small text grows; a small window, which grows it already, has no room for all of that. */
    @Test
    void aPlayersTextIsLargerAsFarAsThereIsRoom() {
        assertThat(Layout.ALONE.withText(1.15, 1.3).textSize(16))
                .isCloseTo(18.4, within(ROUND_OFF));
        assertThat(Layout.ALONE.withText(1.3, 1.3).textSize(20)).isCloseTo(20.8, within(ROUND_OFF));
        assertThat(Layout.ALONE.withText(1.3, 1.3).textSize(40)).isEqualTo(40);
        Layout small = Layout.of(612, 680, 1).withText(1.3, 1.3);
        assertThat(small.textSize(16)).isCloseTo(20.8, within(ROUND_OFF));
    }

    @ParameterizedTest
    @CsvSource({"360, 640, 1", "1170, 2532, 3", "640, 360, 1", "2532, 1170, 3"})
    void inAHandTextAndFingersHaveRoom(int width, int height, double contentScale) {
        Layout layout = Layout.inHand(width, height, contentScale, Edges.NONE);
        double shown = layout.ratio() / contentScale;
        assertThat(layout.textSize(16) * shown).isCloseTo(14, within(ROUND_OFF));
        assertThat(layout.clickable(20) * shown).isCloseTo(44, within(ROUND_OFF));
        assertThat(layout.lettered(22)).isEqualTo(22 * layout.type());
        assertThat(layout.withText(1.3, 1.3)).isEqualTo(layout);
        assertThat(layout.isUpright()).isEqualTo(height > width);
    }

    @Test
    void notchesAreKeptFree() {
        Layout layout = Layout.inHand(1170, 2532, 3, new Edges(0, 141, 12, 102));
        assertThat(layout.windowX(layout.seenLeft())).isCloseTo(0, within(ROUND_OFF));
        assertThat(layout.windowY(layout.seenTop())).isCloseTo(141, within(ROUND_OFF));
        assertThat(layout.windowX(layout.seenRight())).isCloseTo(1158, within(ROUND_OFF));
        assertThat(layout.windowY(layout.seenBottom())).isCloseTo(2430, within(ROUND_OFF));
    }

    @ParameterizedTest
    @CsvSource({
        "612, 680, 1, false",
        "1280, 720, 1.25, false",
        "844, 390, 1, true",
        "980, 2000, 2, true"
    })
    void onlyWindowsAsSmallAsPhonesAreInAHand(
            int width, int height, double contentScale, boolean isInHand) {
        Pane pane = new Pane(width, height, contentScale, Edges.NONE, false);
        assertThat(pane.isInHand()).isEqualTo(isInHand);
    }

    /** Without keys there is no other way to pause, or to leave. */
    @Test
    void aTabletIsInAHandHoweverLargeItIs() {
        assertThat(new Pane(1280, 800, 1, Edges.NONE, true).isInHand()).isTrue();
    }
}
