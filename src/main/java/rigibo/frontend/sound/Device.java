package rigibo.frontend.sound;

import static org.lwjgl.openal.AL11.*;
import static org.lwjgl.openal.ALC11.*;

import org.lwjgl.openal.AL;
import org.lwjgl.openal.ALC;
import org.lwjgl.openal.ALCCapabilities;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;

/** OpenAL's device with its context, one source for each voice, and one for rolling. */
final class Device {

    private final long handle;
    private final long context;
    private final Map<Sample, Integer> buffers = new HashMap<>();
    private final int[] sources;
    private final int rolling;

    /**
     * A context on a device that was opened.
     *
     * @param handle OpenAL's; closed with this
     * @param attributes of the context, ended by 0
     * @throws IllegalStateException when the device takes no context or is out of sources
     */
    Device(long handle, int[] attributes, Samples samples, int voices) {
        this.handle = handle;
        ALCCapabilities capabilities = ALC.createCapabilities(handle);
        context = alcCreateContext(handle, attributes);
        if (context == 0 || !alcMakeContextCurrent(context)) {
            alcCloseDevice(handle);
            throw new IllegalStateException("the audio device takes no context");
        }
        AL.createCapabilities(capabilities);
        // Everything is where the listener is.
        alDistanceModel(AL_NONE);
        samples.all().forEach(sample -> buffers.put(sample, buffer(sample)));
        sources = new int[voices];
        alGenSources(sources);
        rolling = alGenSources();
        if (alGetError() != AL_NO_ERROR) {
            close();
            throw new IllegalStateException("the audio device has too few voices");
        }
        alSourcei(rolling, AL_BUFFER, buffers.get(samples.rolling()));
        alSourcei(rolling, AL_LOOPING, AL_TRUE);
        alSourcef(rolling, AL_GAIN, 0);
        alSourcePlay(rolling);
    }

    /**
     * The system's own device.
     *
     * @throws IllegalStateException when there is none
     */
    static Device open(Samples samples, int voices) {
        AlsaWords.silence();
        long handle = alcOpenDevice((ByteBuffer) null);
        if (handle == 0) {
            throw new IllegalStateException("there is no audio device");
        }
        return new Device(handle, new int[] {0}, samples, voices);
    }

    private static int buffer(Sample sample) {
        int buffer = alGenBuffers();
        alBufferData(buffer, AL_FORMAT_MONO16, sample.values(), Sample.RATE);
        return buffer;
    }

    /** Starts a sample on a voice, in place of the present one. */
    void play(int voice, Sample sample, double gain, double pitch) {
        int source = sources[voice];
        alSourceStop(source);
        alSourcei(source, AL_BUFFER, buffers.get(sample));
        alSourcef(source, AL_GAIN, (float) gain);
        alSourcef(source, AL_PITCH, (float) pitch);
        alSourcePlay(source);
    }

    /** How loud and how fast the rumble is from now on. */
    void roll(double gain, double pitch) {
        alSourcef(rolling, AL_GAIN, (float) gain);
        alSourcef(rolling, AL_PITCH, (float) pitch);
    }

    /** Sets the overall volume, 0 to 1. */
    void volume(double volume) {
        alListenerf(AL_GAIN, (float) volume);
    }

    /** Gives everything back. */
    void close() {
        alDeleteSources(sources);
        alDeleteSources(rolling);
        buffers.values().forEach(buffer -> alDeleteBuffers(buffer));
        alcMakeContextCurrent(0);
        alcDestroyContext(context);
        alcCloseDevice(handle);
        AL.setCurrentProcess(null);
    }
}
