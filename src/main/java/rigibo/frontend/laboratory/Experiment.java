package rigibo.frontend.laboratory;

import rigibo.backend.effect.Effects;

import java.util.function.Consumer;

/**
 * A scene of the laboratory.
 *
 * @param title on its button
 * @param question what to look for, a short sentence
 * @param effects what is simulated
 * @param build puts its bodies into a room
 */
record Experiment(String title, String question, Effects effects, Consumer<Room> build) {}
