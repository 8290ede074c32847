package rigibo.frontend.scene;

import java.util.Optional;
import java.util.function.Function;

/**
 * A scene that can be chosen.
 *
 * @param name for the command line, in kebab-case; a level's id
 * @param title for people, in their language
 * @param words a short sentence about the scene
 * @param challenge what can be won, for a level
 * @param open makes a new instance of the scene
 */
public record SceneEntry(
        String name,
        Function<Words, String> title,
        Function<Words, String> words,
        Optional<Challenge> challenge,
        Function<Director, Scene> open) {

    /**
     * What can be won in a level, and its picture.
     *
     * @param hash of the level, as progress names it
     * @param world number of the level's world, from 1, or {@link #OWN}
     * @param par clicks of a gold medal
     * @param picture the level at its start
     * @param watch opens the player's best run; empty where none was kept
     * @param star what earns the secret star, told once it is found; empty where there is none
     */
    public record Challenge(
            long hash,
            int world,
            int par,
            Picture picture,
            Function<Director, Optional<Scene>> watch,
            Optional<Function<Words, String>> star) {

        /** The world of levels that a player made. */
        public static final int OWN = 0;

        /** The best medal by what a player has done in the level; none before it is solved so. */
        public Optional<Medal> medal(LevelProgress done) {
            return done.fewestClicks().isPresent()
                    ? Optional.of(Medal.of(done.fewestClicks().getAsInt(), par))
                    : Optional.empty();
        }
    }

    /** A picture of the scene before it is opened. */
    public interface Picture {

        /** Its scenery. */
        default Scenery scenery() {
            return Scenery.WORKSHOP;
        }

        /** Draws it into a rectangle of the screen, px. */
        void draw(Canvas canvas, double x, double y, double width, double height);

        /**
         * Draws it into a card, px, before its own scenery if that is not the card's.
         *
         * @param margin about the picture, 3 px or more
         */
        default void drawOn(
                Canvas canvas, double x, double y, double width, double height, double margin) {
            if (scenery() != Scenery.WORKSHOP) {
                // The corners of cards are round, those of sceneries are not.
                double inset = 3;
                double wide = width - 2 * inset;
                canvas.scenery(scenery(), x + inset, y + inset, wide, height - 2 * inset);
            }
            draw(canvas, x + margin, y + margin, width - 2 * margin, height - 2 * margin);
        }
    }

    /**
     * A scene without a prize, with its texts at {@code scene.name} and {@code scene.name.words}.
     */
    public static SceneEntry of(String name, Function<Director, Scene> open) {
        return new SceneEntry(
                name,
                words -> words.of("scene." + name),
                words -> words.of("scene." + name + ".words"),
                Optional.empty(),
                open);
    }

    /** Whether it is a level. */
    public boolean isLevel() {
        return challenge.isPresent();
    }
}
