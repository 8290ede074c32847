package rigibo.frontend.sound;

import rigibo.frontend.scene.Skin;

import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.Map;

/** All sounds of the game, made once. */
final class Samples {

    private final Map<Skin, Sample> knocks = new EnumMap<>(Skin.class);
    private final Map<Signal, Sample> signals = new EnumMap<>(Signal.class);
    private final Map<Instrument, Sample> instruments = new EnumMap<>(Instrument.class);
    private final Sample rolling = Rolling.sample();

    Samples() {
        for (Skin skin : Skin.values()) {
            knocks.put(skin, Timbre.of(skin).sample());
        }
        for (Signal signal : Signal.values()) {
            signals.put(signal, signal.sample());
        }
        for (Instrument instrument : Instrument.values()) {
            instruments.put(instrument, instrument.sample());
        }
    }

    Sample knock(Skin skin) {
        return knocks.get(skin);
    }

    Sample signal(Signal signal) {
        return signals.get(signal);
    }

    Sample instrument(Instrument instrument) {
        return instruments.get(instrument);
    }

    Sample rolling() {
        return rolling;
    }

    /** Each of them. */
    Collection<Sample> all() {
        Collection<Sample> all = new LinkedHashSet<>(knocks.values());
        all.addAll(signals.values());
        all.addAll(instruments.values());
        all.add(rolling);
        return all;
    }
}
