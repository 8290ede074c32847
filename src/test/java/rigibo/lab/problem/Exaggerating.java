package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.child.Work;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Link;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

import java.util.List;

/** Our engine, but every velocity and place to the side or up is a little too large. */
record Exaggerating(double factor) implements Engine {

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
        return new Exaggerated(new RigiBoEngine().world(effects, setting), factor);
    }

    private record Exaggerated(World world, double factor) implements World {

        @Override
        public int add(BodyDefinition body) {
            return world.add(body);
        }

        @Override
        public void join(Link link) {
            world.join(link);
        }

        @Override
        public void remove(int body) {
            world.remove(body);
        }

        @Override
        public void step(double seconds) {
            world.step(seconds);
        }

        @Override
        public void push(int body, double forceX, double forceY) {
            world.push(body, forceX, forceY);
        }

        @Override
        public void drive(int body, double velocityX, double velocityY, double spin) {
            world.drive(body, factor * velocityX, factor * velocityY, spin);
        }

        @Override
        public double x(int body) {
            return factor * world.x(body);
        }

        @Override
        public double y(int body) {
            return factor * world.y(body);
        }

        @Override
        public double angle(int body) {
            return world.angle(body);
        }

        @Override
        public double velocityX(int body) {
            return factor * world.velocityX(body);
        }

        @Override
        public double velocityY(int body) {
            return factor * world.velocityY(body);
        }

        @Override
        public double spin(int body) {
            return world.spin(body);
        }

        @Override
        public void watchImpulses() {
            world.watchImpulses();
        }

        @Override
        public double normalImpulse(int a, int b) {
            return factor * world.normalImpulse(a, b);
        }

        @Override
        public Work lastStep() {
            return world.lastStep();
        }

        @Override
        public void close() {
            world.close();
        }
    }
}
