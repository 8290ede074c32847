package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Set;

/** Our engine, but every velocity and place to the side or up is a little too large. */
record Exaggerating(double factor) implements Engine {

    private static final Set<String> TOO_LARGE =
            Set.of("x", "y", "velocityX", "velocityY", "normalImpulse");

    @Override
    public String name() {
        return "exaggerating";
    }

    @Override
    public List<Setting> settings() {
        return new RigiBoEngine().settings();
    }

    @Override
    public World world(Effects effects, Setting setting) {
        World world = new RigiBoEngine().world(effects, setting);
        return (World)
                Proxy.newProxyInstance(
                        World.class.getClassLoader(),
                        new Class<?>[] {World.class},
                        (proxy, method, arguments) -> answer(world, method, arguments));
    }

    private Object answer(World world, Method method, Object[] arguments)
            throws ReflectiveOperationException {
        if (method.getName().equals("drive")) {
            arguments[1] = factor * (double) arguments[1];
            arguments[2] = factor * (double) arguments[2];
        }
        Object answer = method.invoke(world, arguments);
        return TOO_LARGE.contains(method.getName()) ? (Object) (factor * (double) answer) : answer;
    }
}
