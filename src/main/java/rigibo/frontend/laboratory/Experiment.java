package rigibo.frontend.laboratory;

import rigibo.backend.effect.Effects;

import java.util.function.Consumer;

/**
 * A scene of the laboratory.
 *
 * @param name key of its title and question among the words
 * @param effects the effects that it declares
 * @param build adds its bodies to a room
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
