package rigibo.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;

/** The sizes of rooms in the architecture's page are theirs; {@code ./rigibo docs} writes them. */
class RoomSizesTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    /** Share by which a room may have grown or shrunk since its size was written, and lines. */
    private static final double CHANGE = 0.1;

    private static final long FEW_LINES = 150;

    @Test
    void aRoomHasTheSizeThatIsTold() throws IOException {
        assertThat(RoomSizes.told(HOME))
                .isNotEmpty()
                .allSatisfy(
                        size -> {
                            long slack = Math.max(FEW_LINES, (long) (CHANGE * size.lines()));
                            assertThat(size.count(HOME))
                                    .as("lines of %s, which ./rigibo docs counts", size.room())
                                    .isCloseTo(size.lines(), within(slack));
                        });
    }

    @Test
    void countedAnewThePageIsTheSameButForNumbers() throws IOException {
        String page = RoomSizes.page(HOME);
        assertThat(page).contains("| `backend` | ").contains("## One step");
        assertThat(RoomSizes.told(HOME)).allSatisfy(it -> assertThat(page).contains(it.delivers()));
    }
}
