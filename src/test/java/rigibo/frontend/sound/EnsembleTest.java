package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.lwjgl.openal.ALC11.ALC_FREQUENCY;
import static org.lwjgl.openal.SOFTLoopback.ALC_FLOAT_SOFT;
import static org.lwjgl.openal.SOFTLoopback.ALC_FORMAT_CHANNELS_SOFT;
import static org.lwjgl.openal.SOFTLoopback.ALC_FORMAT_TYPE_SOFT;
import static org.lwjgl.openal.SOFTLoopback.ALC_STEREO_SOFT;
import static org.lwjgl.openal.SOFTLoopback.alcLoopbackOpenDeviceSOFT;
import static org.lwjgl.openal.SOFTLoopback.alcRenderSamplesSOFT;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.lwjgl.BufferUtils;

import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Skin;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/** The mix that OpenAL itself makes, on its device that plays into memory. */
class EnsembleTest {

    private static final int FRAMES_PER_TURN = Sample.RATE / 60;

    /** Quieter than a step of 16 bits: nothing. */
    private static final float SILENT = 1f / 65_536;

    private final Samples samples = new Samples();
    private final long handle = alcLoopbackOpenDeviceSOFT((ByteBuffer) null);
    private final Ensemble ensemble =
            new Ensemble(
                    new Device(handle, format(), samples, Ensemble.VOICES), samples, new Score(1));
    private final FloatBuffer frames = BufferUtils.createFloatBuffer(2 * FRAMES_PER_TURN);

    private static int[] format() {
        return new int[] {
            ALC_FORMAT_CHANNELS_SOFT,
            ALC_STEREO_SOFT,
            ALC_FORMAT_TYPE_SOFT,
            ALC_FLOAT_SOFT,
            ALC_FREQUENCY,
            Sample.RATE,
            0
        };
    }

    @AfterEach
    void close() {
        ensemble.close();
    }

    /** The greatest value of a turn, 1 for full scale. */
    private float turn() {
        ensemble.turn();
        alcRenderSamplesSOFT(handle, frames, FRAMES_PER_TURN);
        float most = 0;
        for (int i = 0; i < frames.capacity(); i++) {
            most = Math.max(most, Math.abs(frames.get(i)));
        }
        return most;
    }

    /**
     * Root of the mean square of some turns: loudness, of which the ear hears more than of peaks.
     */
    private double loudness(int count, Runnable before) {
        double squares = 0;
        for (int i = 0; i < count; i++) {
            before.run();
            turn();
            for (int k = 0; k < frames.capacity(); k++) {
                squares += frames.get(k) * frames.get(k);
            }
        }
        return Math.sqrt(squares / count / frames.capacity());
    }

    private float turns(int count) {
        float most = 0;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, turn());
        }
        return most;
    }

    @Test
    void isSilentUntilSomethingIsTold() {
        assertThat(turns(30)).isLessThan(SILENT);
    }

    @Test
    void everySkinAndEverySignalIsHeardAndEnds() {
        for (Skin skin : Skin.values()) {
            ensemble.knock(skin, 0.8, 500);
            assertThat(turns(6)).as("%s", skin).isGreaterThan(0.02f);
            // The longest sample is cut to 1.5 s.
            turns(110);
            assertThat(turns(6)).as("%s", skin).isLessThan(SILENT);
        }
        for (Signal signal : Signal.values()) {
            ensemble.signal(signal, 1);
            assertThat(turns(6)).as("%s", signal).isGreaterThan(0.02f);
            turns(110);
            assertThat(turns(6)).as("%s", signal).isLessThan(SILENT);
        }
    }

    @Test
    void whatRollsIsHeardWhileItIsTold() {
        for (int i = 0; i < 30; i++) {
            ensemble.roll(3);
            turn();
        }
        ensemble.roll(3);
        assertThat(turn()).isGreaterThan(0.01f);
        turns(60);
        assertThat(turn()).isLessThan(SILENT);
    }

    @Test
    void aHarderBlowIsLouder() {
        ensemble.knock(Skin.WOOD, 1, 10);
        float soft = turns(60);
        ensemble.knock(Skin.WOOD, 1, 1000);
        assertThat(turns(60)).isGreaterThan(2 * soft);
    }

    @Test
    void nothingClipsHoweverMuchKnocksRollsAndSignalsAtOnce() {
        Signal[] signals = Signal.values();
        float most = 0;
        for (int turn = 0; turn < 300; turn++) {
            for (int i = 0; i < 20; i++) {
                Skin skin = Skin.values()[(turn + i) % Skin.values().length];
                ensemble.knock(skin, 0.2 + 0.1 * i, 5000);
            }
            ensemble.roll(20);
            ensemble.signal(signals[turn % signals.length], 1);
            ensemble.music(1.0 / 60, 1);
            most = Math.max(most, turn());
        }
        assertThat(most).isBetween(0.2f, 1f);
    }

    @Test
    void musicIsHeardUnderAllElseAndStandsStillUnlessItIsAskedFor() {
        float most = 0;
        for (int turn = 0; turn < 900; turn++) {
            ensemble.music(1.0 / 60, 1);
            most = Math.max(most, turn());
        }
        assertThat(most).isBetween(0.02f, (float) Music.MOST);
        // Three seconds of the longest sample, played as slow as the lowest tone asks.
        turns(300);
        assertThat(turns(60)).isLessThan(SILENT);
    }

    /** Half a minute of it, beside the first tenth of a second of each signal. */
    @Test
    void everySignalIsLouderThanTheMusicOfANewPlayer() {
        double chosen = Settings.initial("en").music();
        double music = loudness(1800, () -> ensemble.music(1.0 / 60, chosen));
        turns(300);
        for (Signal signal : Signal.values()) {
            ensemble.signal(signal, 1);
            assertThat(loudness(6, () -> {})).as("%s", signal).isGreaterThan(1.5 * music);
            turns(110);
        }
    }

    @Test
    void muteActsFromTheNextTurnOnAlsoOnWhatSounds() {
        ensemble.signal(Signal.CHORD, 1);
        assertThat(turns(6)).isGreaterThan(0.02f);
        ensemble.volume(0);
        // Within the turn OpenAL goes down without a click.
        turn();
        assertThat(turns(6)).isLessThan(SILENT);
    }

    @Test
    void halfTheVolumeIsHalfAsMuch() {
        ensemble.signal(Signal.TICK, 1);
        float full = turns(60);
        ensemble.volume(0.5);
        turn();
        ensemble.signal(Signal.TICK, 1);
        assertThat(turns(60)).isBetween(0.49f * full, 0.51f * full);
    }
}
