package rigibo.frontend.sound;

import org.lwjgl.system.MemoryUtil;
import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;
import org.teavm.jso.typedarrays.Float32Array;

import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.Map;

/**
 * The browser's Web Audio, with the number of voices asked for and one more for rolling. Browsers
 * allow sound only after the player has pressed a key or button.
 */
final class Device {

    /** The value of a sample that means 1. */
    private static final float FULL_SCALE = 32768;

    private final JSObject context = context();
    private final JSObject volume;
    private final Map<Sample, JSObject> buffers = new HashMap<>();
    private final JSObject[] voices;
    private final JSObject rolling;

    private Device(Samples samples, int count) {
        if (context == null) {
            throw new IllegalStateException("this browser has no Web Audio");
        }
        volume = output(context);
        samples.all().forEach(sample -> buffers.put(sample, buffer(sample)));
        voices = new JSObject[count];
        rolling = start(context, volume, buffers.get(samples.rolling()), 0, 1, true);
    }

    /** The browser's own device. */
    static Device open(Samples samples, int voices) {
        return new Device(samples, voices);
    }

    private JSObject buffer(Sample sample) {
        short[] values = sample.values();
        FloatBuffer floats = MemoryUtil.memAllocFloat(values.length);
        for (short value : values) {
            floats.put(value / FULL_SCALE);
        }
        return buffer(context, Float32Array.fromJavaBuffer(floats.flip()), Sample.RATE);
    }

    /**
     * Starts a sample on a voice, in place of its present one; does nothing until the browser
     * allows sound.
     */
    void play(int voice, Sample sample, double gain, double pitch) {
        if (voices[voice] != null) {
            stop(voices[voice]);
        }
        voices[voice] = start(context, volume, buffers.get(sample), gain, pitch, false);
    }

    /** Sets volume and speed of the rumble. */
    void roll(double gain, double pitch) {
        change(rolling, gain, pitch);
    }

    /** Sets the factor of all volumes, 0 to 1. */
    void volume(double wanted) {
        set(volume, wanted);
    }

    void close() {
        close(context);
    }

    @JSBody(
            script =
                    "if (!window.AudioContext) { return null; }"
                            + "var context = new AudioContext();"
                            + "var resume = function() { context.resume(); };"
                            + "addEventListener('pointerup', resume);"
                            + "addEventListener('keydown', resume);"
                            + "return context;")
    private static native JSObject context();

    @JSBody(
            params = "context",
            script =
                    "var gain = context.createGain(); gain.connect(context.destination);"
                            + "return gain;")
    private static native JSObject output(JSObject context);

    @JSBody(
            params = {"context", "floats", "rate"},
            script =
                    "var buffer = context.createBuffer(1, floats.length, rate);"
                            + "buffer.copyToChannel(floats, 0); return buffer;")
    private static native JSObject buffer(JSObject context, Float32Array floats, int rate);

    @JSBody(
            params = {"context", "output", "buffer", "gain", "pitch", "isEndless"},
            script =
                    "if (!isEndless && context.state !== 'running') { return null; }"
                            + "var source = context.createBufferSource();"
                            + "var own = context.createGain();"
                            + "source.buffer = buffer; source.loop = isEndless;"
                            + "source.playbackRate.value = pitch; own.gain.value = gain;"
                            + "source.connect(own); own.connect(output);"
                            + "source.start(); return {source: source, gain: own.gain};")
    private static native JSObject start(
            JSObject context,
            JSObject output,
            JSObject buffer,
            double gain,
            double pitch,
            boolean isEndless);

    @JSBody(params = "voice", script = "voice.source.stop();")
    private static native void stop(JSObject voice);

    @JSBody(
            params = {"voice", "gain", "pitch"},
            script = "voice.gain.value = gain; voice.source.playbackRate.value = pitch;")
    private static native void change(JSObject voice, double gain, double pitch);

    @JSBody(
            params = {"output", "gain"},
            script = "output.gain.value = gain;")
    private static native void set(JSObject output, double gain);

    @JSBody(params = "context", script = "context.close();")
    private static native void close(JSObject context);
}
