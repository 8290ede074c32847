package rigibo.fuzz.program;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A program: calls of the engine's public face.
 *
 * @param effects what the pool simulates at first
 * @param accuracy how exactly at first
 * @param operations one after the other
 */
public record Program(
        Stated<Effects> effects, Stated<Accuracy> accuracy, List<Operation> operations) {

    /** A copy with other operations. */
    public Program with(List<Operation> others) {
        return new Program(effects, accuracy, List.copyOf(others));
    }

    /** A stage with an empty pool for the operations. */
    public Stage stage(Witness witness) {
        return new Stage(new Pool(effects.value(), accuracy.value()), witness);
    }

    /** The program as Java that can be pasted into a test. */
    public String java() {
        return "RigidBody[] body = new RigidBody["
                + Programs.MOST_BODIES
                + "];\n"
                + "Pool pool = new Pool(\n        "
                + effects.java()
                + ",\n        "
                + accuracy.java()
                + ");\n"
                + operations.stream().map(Operation::java).collect(Collectors.joining("\n"));
    }
}
