package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * A force of the caller's own on every dynamic body, at its centre of mass, by place, velocity,
 * mass and time: springs, magnets, whirls. As nobody can say that it will not change, bodies do not
 * fall asleep where a field is declared.
 *
 * <pre>{@code
 * // A spring to the origin, 40 N/m.
 * Field spring = new Field(at -> at.push(-40 * at.x, -40 * at.y));
 * Pool springs = new Pool(Effects.of(spring), Accuracy.FINE);
 * }</pre>
 *
 * @param function what acts; several forces go into one function
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
}
