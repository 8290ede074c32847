package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Link;

import java.util.Optional;

/** The accuracy of a pool in links; that of the game is not told. */
public final class AccuracyLink {

    private static final String NAME = "accuracy";

    private AccuracyLink() {}

    /** Returns a link with a pool's accuracy. */
    public static Link in(Link link, Pool pool) {
        return Preset.of(pool.accuracy())
                .filter(preset -> !preset.accuracy().equals(Accuracy.GAME))
                .map(preset -> link.with(NAME, preset.linked()))
                .orElse(link);
    }

    /** Sets a pool to the accuracy that a link names; returns how many choices that were. */
    public static int follow(Link link, Pool pool) {
        Optional<Preset> named = Preset.ofLinked(link.choices().getOrDefault(NAME, ""));
        named.ifPresent(preset -> pool.accuracy(preset.accuracy()));
        return named.isPresent() ? 1 : 0;
    }
}
