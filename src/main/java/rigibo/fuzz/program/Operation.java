package rigibo.fuzz.program;

import rigibo.backend.RigidBody;

import java.util.List;
import java.util.function.Consumer;

/**
 * One call of a program.
 *
 * @param java the statement
 * @param kind the outcome that it must have
 * @param refusal the field that a refusal must name; empty if several may be wrong
 * @param bodies the numbers of the bodies that it names
 * @param act does what the statement says
 */
public record Operation(
        String java, Kind kind, String refusal, List<Integer> bodies, Consumer<Stage> act) {

    /** The expected outcome of an operation. */
    public enum Kind {
        /** It is done. */
        DONE,
        /** It is done, or refused because of the state or a drawn number. */
        TRIED,
        /** It is refused. */
        REFUSED,
        /** It is answered and changes nothing. */
        ASKED,
        /** From here on a restored copy runs beside the pool. */
        COPIED
    }

    static Operation done(String java, Consumer<Stage> act) {
        return new Operation(java, Kind.DONE, "", List.of(), act);
    }

    static Operation tried(String java, List<Integer> bodies, Consumer<Stage> act) {
        return new Operation(java, Kind.TRIED, "", bodies, act);
    }

    /** An operation that calls a verb of one body. */
    static Operation verb(int number, String call, Consumer<RigidBody> verb) {
        return tried(
                "body[" + number + "]." + call + ";",
                List.of(number),
                stage -> verb.accept(stage.body(number)));
    }

    /** An operation that must be refused with the name of a field. */
    public static Operation refused(
            String java, String field, List<Integer> bodies, Consumer<Stage> act) {
        return new Operation(java, Kind.REFUSED, field, bodies, act);
    }

    static Operation asked(String java, List<Integer> bodies, Consumer<Stage> act) {
        return new Operation(java, Kind.ASKED, "", bodies, act);
    }

    /** Whether all bodies that it names were added; shrinking may have left out an addition. */
    public boolean canBeDone(Stage stage) {
        return bodies.stream().allMatch(stage::knows);
    }

    /** Whether it names a removed body, which every verb refuses. */
    public boolean namesTheRemoved(Stage stage) {
        return bodies.stream().anyMatch(number -> !stage.body(number).isAlive());
    }
}
