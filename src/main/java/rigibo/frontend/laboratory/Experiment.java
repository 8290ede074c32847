package rigibo.frontend.laboratory;

import rigibo.backend.effect.Effects;

import java.util.function.Consumer;

/**
 * A scene of the laboratory.
 *
 * @param name by which its title and its question are found among the words
 * @param effects what is simulated
 * @param build puts its bodies into a room
 */
record Experiment(String name, Effects effects, Consumer<Room> build) {

    /** Of what is on its button. */
    String titleKey() {
        return "laboratory." + name;
    }

    /** Of what to look for, a short sentence. */
    String questionKey() {
        return titleKey() + ".question";
    }
}
