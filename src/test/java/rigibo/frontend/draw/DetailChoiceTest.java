package rigibo.frontend.draw;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Settings;

class DetailChoiceTest {

    private static final long QUICK = 6_000_000;
    private static final long LATE = 14_000_000;

    private final DetailChoice choice = new DetailChoice();

    private Detail after(String renderer, long nanos) {
        choice.renderer(renderer);
        for (int frame = 0; frame < 300; frame++) {
            choice.drawn(nanos);
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
    void aFewLateFramesAreNoReason() {
        choice.renderer("llvmpipe");
        for (int frame = 0; frame < 300; frame++) {
            choice.drawn(frame % 3 == 0 ? LATE : QUICK);
        }
        assertThat(choice.detail(Settings.Detail.AUTOMATIC)).isEqualTo(Detail.FULL);
    }
}
