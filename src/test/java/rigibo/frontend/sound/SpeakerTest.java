package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Skin;

/** The loop is never disturbed by its sounds. */
class SpeakerTest {

    private static void tellEverything(Speaker speaker) {
        speaker.knock(Skin.BALL, 0.7, 100);
        speaker.roll(2);
        speaker.pop();
        speaker.refuse();
        speaker.tick(0.5);
        speaker.chord();
        speaker.fail();
        speaker.press();
        speaker.turn();
        speaker.settings(Settings.initial("en").withMuted(true));
        speaker.turn();
    }

    @Test
    void takesEverythingUnplugged() {
        Speaker speaker = new Speaker();
        assertThatCode(() -> tellEverything(speaker)).doesNotThrowAnyException();
        assertThat(speaker.isHeard()).isFalse();
        assertThatCode(speaker::close).doesNotThrowAnyException();
    }

    /** Whether or not this machine has a device, and before it is known. */
    @Test
    void takesEverythingWhileItsDeviceOpensAndAfterItIsClosed() {
        Speaker speaker = new Speaker();
        speaker.plugIn();
        assertThatCode(() -> tellEverything(speaker)).doesNotThrowAnyException();
        speaker.close();
        assertThatCode(() -> tellEverything(speaker)).doesNotThrowAnyException();
    }
}
