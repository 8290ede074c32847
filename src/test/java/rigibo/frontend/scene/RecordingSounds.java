package rigibo.frontend.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Keeps what was to be heard. */
public final class RecordingSounds implements Sounds {

    /** A knock as it was told; m, N·s. */
    public record Knock(Skin skin, double size, double impulse) {}

    /** The knocks, in their order. */
    public final List<Knock> knocks = new ArrayList<>();

    /** The names of the other sounds, in their order, without what rolls. */
    public final List<String> signals = new ArrayList<>();

    /** How much of the hold was done at each tick. */
    public final List<Double> ticks = new ArrayList<>();

    /** The speeds of what rolls, m/s. */
    public final List<Double> rolling = new ArrayList<>();

    @Override
    public void knock(Skin skin, double size, double impulse) {
        knocks.add(new Knock(skin, size, impulse));
    }

    @Override
    public void roll(double speed) {
        rolling.add(speed);
    }

    @Override
    public void pop() {
        signals.add("pop");
    }

    @Override
    public void did(Deed deed) {
        signals.add(deed.name().toLowerCase(Locale.ROOT));
    }

    @Override
    public void refuse() {
        signals.add("refuse");
    }

    @Override
    public void tick(double held) {
        ticks.add(held);
    }

    @Override
    public void chord() {
        signals.add("chord");
    }

    @Override
    public void fail() {
        signals.add("fail");
    }

    @Override
    public void press() {
        signals.add("press");
    }

    @Override
    public boolean isHeard() {
        return true;
    }
}
