package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.Optional;

/**
 * One body of a level, besides ball and platform.
 *
 * @param id unique in its level
 * @param shape its outline about the centre of mass
 * @param x of the centre of mass, m
 * @param y of the centre of mass, m, up
 * @param angle rad, counter-clockwise
 * @param substance its look
 * @param material its behaviour: the substance's numbers, or those that the file states instead
 * @param motion at the start
 * @param mobility whether it moves
 * @param handling action of a click on it
 * @param path of a driven body
 * @param source the stream or pull that comes from it
 */
public record LevelBody(
        String id,
        Shape shape,
        double x,
        double y,
        double angle,
        Substance substance,
        Material material,
        Motion motion,
        Mobility mobility,
        Handling handling,
        Optional<LevelPath> path,
        Source source) {

    /** The cause of a body's motion. */
    public enum Mobility {
        /** Forces and contacts. */
        DYNAMIC,
        /** Nothing: it does not move. */
        STATIC,
        /** Its path, whatever it meets. */
        DRIVEN
    }

    /** Whether a click deletes it. */
    public boolean deletable() {
        return does(Verb.DELETE);
    }

    /** The action of a click on it; empty if there is none. */
    public Optional<Verb> verb() {
        return handling.verb();
    }

    /** Whether a click acts on it by a verb. */
    boolean does(Verb what) {
        return handling.does(what);
    }

    public boolean isDynamic() {
        return mobility == Mobility.DYNAMIC;
    }

    /** The engine's definition. */
    public BodyDefinition definition() {
        BodyDefinition placed =
                switch (mobility) {
                    case DYNAMIC ->
                            BodyDefinition.dynamic(shape)
                                    .velocity(motion.x(), motion.y())
                                    .spin(motion.spin());
                    case STATIC -> BodyDefinition.fixed(shape);
                    case DRIVEN -> BodyDefinition.kinematic(shape);
                };
        Material atStart = handling.beginsOff() ? material.surfaceSpeed(0) : material;
        return placed.at(x, y).angle(angle).material(atStart).name(id);
    }

    LevelBody shifted(double metres) {
        return new LevelBody(
                id,
                shape,
                x + metres,
                y,
                angle,
                substance,
                material,
                motion,
                mobility,
                handling,
                path,
                source);
    }
}
