package rigibo.peers;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldFunction;
import rigibo.backend.effect.FieldPoint;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.engine.World;

import java.util.ArrayList;
import java.util.List;

/**
 * Forces that no peer has and that its users add themselves: before each step every dynamic body
 * gets the force of its present state, which the step takes as constant.
 */
public final class UserForces {

    /** Writes position and velocity of a body into a point. */
    @FunctionalInterface
    public interface State {
        void write(int body, FieldPoint point);
    }

    private record Pushed(int number, double mass, Shape shape) {}

    private final World world;
    private final State state;
    private final List<FieldFunction> fields = new ArrayList<>();
    private final AirDrag air;
    private final List<Pushed> bodies = new ArrayList<>();
    private final FieldPoint point = new FieldPoint();
    private double time;

    /** The forces of some effects on the bodies of a world that reads a body in four calls. */
    public UserForces(Effects effects, World world) {
        this(
                effects,
                world,
                (body, point) -> {
                    point.x = world.x(body);
                    point.y = world.y(body);
                    point.velocityX = world.velocityX(body);
                    point.velocityY = world.velocityY(body);
                });
    }

    /** The declared effects that are forces of this kind, for the bodies of a world. */
    public UserForces(Effects effects, World world, State state) {
        this.world = world;
        this.state = state;
        effects.find(Field.class).map(Field::function).ifPresent(fields::add);
        effects.find(CentralForce.class).map(UserForces::pull).ifPresent(fields::add);
        air = effects.find(AirDrag.class).orElse(null);
    }

    /** Adds a body, if it can be pushed. */
    public void add(int number, BodyDefinition body) {
        boolean isPushed = body.type() == BodyType.DYNAMIC && (!fields.isEmpty() || air != null);
        if (isPushed) {
            bodies.add(new Pushed(number, body.mass(), body.shape()));
        }
    }

    /** Pushes every body for a step of a length in s. */
    public void push(double seconds) {
        for (int i = 0; i < bodies.size(); i++) {
            push(bodies.get(i));
        }
        time += seconds;
    }

    private void push(Pushed body) {
        state.write(body.number, point);
        point.mass = body.mass;
        point.time = time;
        point.accelerationX = 0;
        point.accelerationY = 0;
        for (int i = 0; i < fields.size(); i++) {
            fields.get(i).act(point);
        }
        if (air != null) {
            brake(body);
        }
        world.push(body.number, body.mass * point.accelerationX, body.mass * point.accelerationY);
    }

    private static FieldFunction pull(CentralForce centre) {
        return point -> {
            double x = centre.x() - point.x;
            double y = centre.y() - point.y;
            double distance = Math.sqrt(x * x + y * y);
            if (distance > 0) {
                // s·rⁿ along (x, y)/r.
                double share = centre.strength() * Math.pow(distance, centre.power() - 1);
                point.accelerate(share * x, share * y);
            }
        };
    }

    /** F = −½·ρ·c·A·|v|·v, A the width across the motion. */
    private void brake(Pushed body) {
        double vx = point.velocityX;
        double vy = point.velocityY;
        double speed = Math.sqrt(vx * vx + vy * vy);
        if (speed > 0) {
            double width = Width.across(body.shape, world.angle(body.number), vx, vy);
            double strength = air.density() * air.coefficient() / 2 * width * speed;
            point.push(-strength * vx, -strength * vy);
        }
    }
}
