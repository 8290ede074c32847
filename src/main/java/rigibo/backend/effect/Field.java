package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * A force defined by a caller's function of position, velocity, mass and time, applied to every
 * dynamic body at its centre of mass: springs, magnets, whirls. The force may change at any time,
 * so no body falls asleep while a field is declared.
 *
 * <pre>{@code
 * // A spring to the origin, 40 N/m.
 * Field spring = new Field(at -> at.push(-40 * at.x, -40 * at.y));
 * Pool springs = new Pool(Effects.of(spring), Accuracy.FINE);
 * }</pre>
 *
 * @param function computes the force; combine several forces in one function
 */
public record Field(FieldFunction function) implements Effect {

    /**
     * Checks that there is a function.
     *
     * @throws IllegalArgumentException when it is null
     */
    public Field {
        Require.present("Field.function", function);
    }

    @Override
    public boolean holdsFunction() {
        return true;
    }

    @Override
    public Kind kind() {
        return Kind.FIELD;
    }
}
