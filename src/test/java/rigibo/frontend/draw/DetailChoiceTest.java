package rigibo.frontend.draw;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Settings;

class DetailChoiceTest {

    private static final long QUICK = 6_000_000;
    private static final long LATE = 14_000_000;

    private final DetailChoice choice = new DetailChoice();

    /** The detail after a window was tried out, whose first pictures take long anyway. */
    private Detail after(String renderer, long nanos) {
        choice.renderer(renderer);
        for (int i = 0; choice.isOpen(Settings.Detail.AUTOMATIC); i++) {
            choice.tried(i < 2 ? 10 * LATE : nanos);
        }
        return choice.detail(Settings.Detail.AUTOMATIC);
    }

    @Test
    void drawsEverythingInSoftwareThatIsQuickEnough() {
        assertThat(after("llvmpipe (LLVM 15.0.6, 256 bits)", QUICK)).isEqualTo(Detail.FULL);
    }

    @Test
    void drawsLessInSoftwareWhoseFramesComeLate() {
        assertThat(after("llvmpipe (LLVM 15.0.6, 256 bits)", LATE)).isEqualTo(Detail.LITE);
    }

    @Test
    void staysWithLessWhenLessIsQuick() {
        after("softpipe", LATE);
        assertThat(after("softpipe", QUICK)).isEqualTo(Detail.LITE);
    }

    @Test
    void leavesAGraphicsCardAlone() {
        assertThat(after("Mesa Intel(R) UHD Graphics 620", LATE)).isEqualTo(Detail.FULL);
    }

    @Test
    void thePlayersChoiceHoldsHoweverFastTheMachineIs() {
        after("llvmpipe", LATE);
        assertThat(choice.detail(Settings.Detail.FULL)).isEqualTo(Detail.FULL);
        assertThat(choice.detail(Settings.Detail.LITE)).isEqualTo(Detail.LITE);
    }

    @Test
    void oneLatePictureOfThreeIsNoReason() {
        choice.renderer("llvmpipe");
        for (int i = 0; choice.isOpen(Settings.Detail.AUTOMATIC); i++) {
            choice.tried(i == 3 ? LATE : QUICK);
        }
        assertThat(choice.detail(Settings.Detail.AUTOMATIC)).isEqualTo(Detail.FULL);
    }

    /** A window that takes long to start is worse than one that draws less. */
    @Test
    void triesFivePicturesForEachWindowAtMost() {
        for (int window = 0; window < 3; window++) {
            choice.renderer("llvmpipe");
            int pictures = 0;
            for (; choice.isOpen(Settings.Detail.AUTOMATIC); pictures++) {
                choice.tried(QUICK);
            }
            assertThat(pictures).isEqualTo(5);
        }
    }

    @Test
    void triesNothingWhereThereIsNothingToChoose() {
        choice.renderer("llvmpipe");
        assertThat(choice.isOpen(Settings.Detail.FULL)).isFalse();
        assertThat(choice.isOpen(Settings.Detail.LITE)).isFalse();
        after("llvmpipe", LATE);
        choice.renderer("llvmpipe");
        assertThat(choice.isOpen(Settings.Detail.AUTOMATIC)).isFalse();
        choice.renderer("Mesa Intel(R) UHD Graphics 620");
        assertThat(choice.isOpen(Settings.Detail.AUTOMATIC)).isFalse();
    }
}
