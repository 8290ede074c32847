package rigibo.frontend.sound;

import org.tinylog.Logger;

import rigibo.frontend.scene.Deed;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Sounds;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * The sounds of the game. Silent until the audio device has opened, which takes half a second
 * during which no turn waits; silent for good without a device.
 */
public final class Speaker implements Sounds {

    /** How much higher the last tick of a hold is than the first: an octave. */
    private static final double RISE_OF_TICKS = 1;

    /**
     * Most time that music goes on by in a turn, s: after a pause of the loop its notes do not come
     * all at once.
     */
    private static final double LONGEST_TURN = 0.25;

    /** How long a device that still opens is waited for at the end, s. */
    private static final int PATIENCE = 2;

    private CompletableFuture<Optional<Ensemble>> opening =
            CompletableFuture.completedFuture(Optional.empty());
    private double volume;
    private double musicVolume;
    private long lastTurn = System.nanoTime();

    /** Begins to open the system's audio device; says so in the log where that fails. */
    public void plugIn() {
        opening = new CompletableFuture<>();
        CompletableFuture<Optional<Ensemble>> opened = opening;
        Thread thread = new Thread(() -> opened.complete(open()), "sound");
        thread.setDaemon(true);
        thread.start();
    }

    private static Optional<Ensemble> open() {
        try {
            Samples samples = new Samples();
            Device device = Device.open(samples, Ensemble.VOICES);
            return Optional.of(new Ensemble(device, samples, new Score(System.nanoTime())));
        } catch (IllegalStateException | LinkageError noSound) {
            Logger.warn("The game is silent: {}.", noSound.getMessage());
            return Optional.empty();
        }
    }

    private Optional<Ensemble> ensemble() {
        return opening.getNow(Optional.empty());
    }

    /** As loud as the player has chosen, from now on. */
    public void settings(Settings settings) {
        volume = settings.isMuted() ? 0 : settings.volume();
        musicVolume = settings.music();
        ensemble().ifPresent(ensemble -> ensemble.volume(volume));
    }

    /** Goes on by a turn of the loop, after the scene's step: what that told is heard. */
    public void turn() {
        long now = System.nanoTime();
        double seconds = Math.min(LONGEST_TURN, (now - lastTurn) / 1e9);
        lastTurn = now;
        ensemble().ifPresent(ensemble -> turn(ensemble, seconds));
    }

    private void turn(Ensemble ensemble, double seconds) {
        ensemble.volume(volume);
        ensemble.turn();
        if (volume > 0 && musicVolume > 0) {
            ensemble.music(seconds, musicVolume);
        }
    }

    /**
     * Closes the device and silences it. If it is just being opened, waits a limited time for that,
     * since no thread should be inside a driver when the process ends.
     */
    public void close() {
        opening.completeOnTimeout(Optional.empty(), PATIENCE, TimeUnit.SECONDS)
                .join()
                .ifPresent(Ensemble::close);
        opening = CompletableFuture.completedFuture(Optional.empty());
    }

    @Override
    public void knock(Skin skin, double size, double impulse) {
        ensemble().ifPresent(ensemble -> ensemble.knock(skin, size, impulse));
    }

    @Override
    public void roll(double speed) {
        ensemble().ifPresent(ensemble -> ensemble.roll(speed));
    }

    @Override
    public void pop() {
        signal(Signal.POP, 1);
    }

    @Override
    public void did(Deed deed) {
        signal(Signal.of(deed), 1);
    }

    @Override
    public void refuse() {
        signal(Signal.REFUSE, 1);
    }

    @Override
    public void tick(double held) {
        signal(Signal.TICK, 1 + RISE_OF_TICKS * held);
    }

    @Override
    public void chord() {
        signal(Signal.CHORD, 1);
    }

    @Override
    public void fail() {
        signal(Signal.FAIL, 1);
    }

    @Override
    public void press() {
        signal(Signal.PRESS, 1);
    }

    @Override
    public boolean isHeard() {
        return volume > 0 && ensemble().isPresent();
    }

    private void signal(Signal signal, double pitch) {
        ensemble().ifPresent(ensemble -> ensemble.signal(signal, pitch));
    }
}
