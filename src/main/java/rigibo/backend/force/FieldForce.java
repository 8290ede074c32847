package rigibo.backend.force;

import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldFunction;
import rigibo.backend.effect.FieldPoint;

/** Calls the caller's function, which receives numbers and no access to the pool. */
final class FieldForce implements ChangingForce {

    private final FieldFunction function;
    private final FieldPoint point = new FieldPoint();

    FieldForce(Field field) {
        function = field.function();
    }

    @Override
    public void add(Instant at) {
        point.x = at.x;
        point.y = at.y;
        point.velocityX = at.velocityX;
        point.velocityY = at.velocityY;
        point.mass = at.mass;
        point.time = at.time;
        point.accelerationX = 0;
        point.accelerationY = 0;
        function.act(point);
        at.accelerationX += point.accelerationX;
        at.accelerationY += point.accelerationY;
    }
}
