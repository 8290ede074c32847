package rigibo.frontend.scene;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/**
 * An action for which the player may choose a key, with its default key. Scenes always receive the
 * default key, whatever was pressed, see {@link KeyBindings#meant}.
 */
public enum Action {
    PAUSE(Key.P, Place.LEVEL, Place.REPLAY),
    RESTART(Key.R, Place.values()),
    UNDO(Key.BACKSPACE, Place.LEVEL),
    SLOWER(Key.S, Place.LEVEL, Place.REPLAY),
    FASTER(Key.N, Place.LEVEL, Place.REPLAY),
    EFFECTS(Key.E, Place.LEVEL, Place.DEMO),
    GHOST(Key.G, Place.LEVEL, Place.DEMO),
    HINT(Key.H, Place.LEVEL),
    SOLUTION(Key.V, Place.LEVEL),
    COPY(Key.C, Place.LEVEL, Place.REPLAY),
    HALT(Key.SPACE, Place.REPLAY, Place.DEMO),
    STEP(Key.PERIOD, Place.REPLAY, Place.DEMO),
    CONTROLS(Key.C, Place.DEMO),
    ENERGY(Key.N, Place.DEMO),
    PLATES(Key.T, Place.DEMO),
    DEBUG(Key.D, Place.DEMO),
    BLAST(Key.B, Place.DEMO),
    PREVIOUS(Key.LEFT_BRACKET, Place.DEMO),
    NEXT(Key.RIGHT_BRACKET, Place.DEMO),
    HOME(Key.HOME, Place.DEMO);

    private final Key first;
    private final Set<Place> places;

    /** Kinds of scenes; in one of them no key does two things. */
    public enum Place {
        LEVEL,
        REPLAY,
        /** A demo, an exhibit of the gallery, or the laboratory. */
        DEMO
    }

    Action(Key first, Place... places) {
        this.first = first;
        this.places = EnumSet.copyOf(Arrays.asList(places));
    }

    /** The key as long as the player has chosen no other. */
    public Key first() {
        return first;
    }

    /** Whether a kind of scenes has it. */
    public boolean isIn(Place place) {
        return places.contains(place);
    }

    /** Whether some scene has this action and another one. */
    boolean meets(Action other) {
        return this != other && !Collections.disjoint(places, other.places);
    }

    /** Its name in the bundle of words and in files. */
    public String title() {
        return name().toLowerCase(Locale.ROOT);
    }
}
