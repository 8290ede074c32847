package rigibo.fuzz.program;

import rigibo.backend.RigidBody;

import java.util.List;
import java.util.function.Consumer;

/**
 * One call of a program.
 *
 * @param java the statement
 * @param kind what has to become of it
 * @param refusal what a refusal has to name; empty where any field may be at fault
 * @param bodies the numbers of the bodies that it names
 * @param act does what the statement says
 */
public record Operation(
        String java, Kind kind, String refusal, List<Integer> bodies, Consumer<Stage> act) {

    /** What has to become of an operation. */
    public enum Kind {
        /** Is done. */
        DONE,
        /** Is done, or refused where the state or a drawn number calls for it. */
        TRIED,
        /** Is refused. */
        REFUSED,
        /** Is answered, and changes nothing. */
        ASKED,
        /** A restored copy goes on beside the pool from here. */
        COPIED
    }

    static Operation done(String java, Consumer<Stage> act) {
        return new Operation(java, Kind.DONE, "", List.of(), act);
    }

    static Operation tried(String java, List<Integer> bodies, Consumer<Stage> act) {
        return new Operation(java, Kind.TRIED, "", bodies, act);
    }

    /** A verb of one body, as it is written and as it is done. */
    static Operation verb(int number, String call, Consumer<RigidBody> verb) {
        return tried(
                "body[" + number + "]." + call + ";",
                List.of(number),
                stage -> verb.accept(stage.body(number)));
    }

    /** Has to be refused, naming the field. */
    public static Operation refused(
            String java, String field, List<Integer> bodies, Consumer<Stage> act) {
        return new Operation(java, Kind.REFUSED, field, bodies, act);
    }

    static Operation asked(String java, List<Integer> bodies, Consumer<Stage> act) {
        return new Operation(java, Kind.ASKED, "", bodies, act);
    }

    /**
     * Whether all bodies it names have been added; where an addition was left out, some are not.
     */
    public boolean canBeDone(Stage stage) {
        return bodies.stream().allMatch(stage::knows);
    }

    /** Whether it names a body that is no longer in its pool, which every verb refuses. */
    public boolean namesTheRemoved(Stage stage) {
        return bodies.stream().anyMatch(number -> !stage.body(number).isAlive());
    }
}
