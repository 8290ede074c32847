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

    /** Key of the text on its button. */
    String titleKey() {
        return "laboratory." + name;
    }

    /** Key of a short sentence that tells what to look for. */
    String questionKey() {
        return titleKey() + ".question";
    }
}
