package rigibo.frontend.sound;

import org.lwjgl.system.JNI;
import org.lwjgl.system.Library;
import org.lwjgl.system.Platform;
import org.lwjgl.system.SharedLibrary;

/**
 * Replaces the eight lines of internals that ALSA writes to the terminal of a Linux machine without
 * a sound card by one sentence.
 */
final class AlsaWords {

    private AlsaWords() {}

    /**
     * Replaces the function by which ALSA prints errors by a function of ALSA that does nothing.
     * Its result is ignored, and so are the arguments that it has no parameters for.
     */
    static void silence() {
        if (Platform.get() == Platform.LINUX) {
            silence("libasound.so.2");
        }
    }

    private static void silence(String name) {
        try {
            SharedLibrary alsa =
                    Library.loadNative(AlsaWords.class, "rigibo.frontend.sound", name, false);
            long handler = alsa.getFunctionAddress("snd_lib_error_set_handler");
            long nothing = alsa.getFunctionAddress("snd_asoundlib_version");
            if (handler != 0 && nothing != 0) {
                JNI.invokePV(nothing, handler);
            }
        } catch (UnsatisfiedLinkError withoutAlsa) {
            // There is nothing to be silenced then.
        }
    }
}
