package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Material;

/**
 * The hash that ties a replay to its level: FNV-1a, 64 bit (Fowler, Noll, Vo), over the bits of
 * every number in the order of the level's records. It does not use their text, since Java's text
 * of a double changed between versions.
 */
final class LevelHash {

    private static final long OFFSET_BASIS = 0xcbf29ce484222325L;
    private static final long PRIME = 0x100000001b3L;

    private long hash = OFFSET_BASIS;

    private LevelHash() {}

    static long of(Level level) {
        LevelHash hashing = new LevelHash();
        hashing.world(level.world());
        hashing.limits(level.limits());
        level.balls().forEach(hashing::ball);
        hashing.platform(level.platform());
        level.bodies().forEach(hashing::body);
        level.joints().forEach(hashing::joint);
        return hashing.hash;
    }

    private void world(World world) {
        numbers(world.width(), world.height());
        for (Effect effect : world.effects().all()) {
            text(effect.title());
        }
        world.effects().find(Gravity.class).ifPresent(g -> numbers(g.x(), g.y()));
        world.effects()
                .find(Buoyancy.class)
                .ifPresent(water -> numbers(water.level(), water.density(), water.drag()));
    }

    private void limits(Limits limits) {
        numbers(limits.cooldown(), limits.hold(), limits.contactGrace());
        numbers(limits.maxClicks().orElse(0), limits.timeLimit().orElse(0));
    }

    private void ball(Ball ball) {
        numbers(ball.x(), ball.y(), ball.radius());
        material(ball.substance().material());
        motion(ball.motion());
    }

    private void platform(Platform platform) {
        numbers(platform.x(), platform.y(), platform.width(), platform.height(), platform.angle());
    }

    private void body(LevelBody body) {
        text(body.id());
        shape(body.shape());
        numbers(body.x(), body.y(), body.angle());
        material(body.material());
        if (body.material().isOneWay()) {
            numbers(body.material().oneWayX(), body.material().oneWayY());
        }
        motion(body.motion());
        text(body.mobility().name());
        numbers(body.deletable() ? 1 : 0);
        if (!body.deletable()) {
            handling(body.handling());
        }
        // Other substances show in their numbers alone; a fire door also melts.
        if (body.substance() == Substance.EMBER) {
            text(body.substance().title());
        }
        body.path().ifPresent(this::path);
        body.source()
                .jet()
                .ifPresent(jet -> numbers(jet.angle(), jet.width(), jet.reach(), jet.force()));
        body.source().pole().ifPresent(pole -> numbers(pole.strength(), pole.reach()));
    }

    private void joint(LevelJoint joint) {
        text(joint.type().name());
        text(joint.a());
        text(joint.b());
        numbers(joint.x(), joint.y(), joint.toX(), joint.toY(), joint.axis(), joint.length());
        JointSettings settings = joint.settings();
        numbers(settings.limits().lower(), settings.limits().upper());
        numbers(settings.motor().speed(), settings.motor().most());
        numbers(settings.spring().hertz(), settings.spring().dampingRatio());
        numbers(settings.breakForce());
        // The hash of a joint that no click acts on is as before joints could be clicked.
        joint.verb().ifPresent(verb -> text(joint.id().orElseThrow()));
        handling(joint.handling());
    }

    private void handling(Handling handling) {
        handling.verb().ifPresent(verb -> text(verb.title()));
        if (handling.beginsOff()) {
            text("off");
        }
        handling.charge()
                .ifPresent(blast -> numbers(blast.radius(), blast.falloff(), blast.impulse()));
    }

    private void path(LevelPath path) {
        numbers(path.speed(), path.pause());
        text(path.end().name());
        path.stops().forEach(stop -> numbers(stop.x(), stop.y()));
    }

    private void shape(Shape shape) {
        switch (shape.kind()) {
            case CIRCLE -> numbers(((Circle) shape).radius());
            case CAPSULE -> capsule((Capsule) shape);
            case POLYGON -> corners((Polygon) shape);
            case COMPOUND -> parts((Compound) shape);
            case CHAIN -> corners((Chain) shape);
        }
    }

    private void corners(Chain chain) {
        numbers(chain.corners(), chain.isLoop() ? 1 : 0);
        for (int i = 0; i < chain.corners(); i++) {
            numbers(chain.cornerX(i), chain.cornerY(i));
        }
    }

    private void parts(Compound compound) {
        numbers(compound.parts(), compound.centroidX(), compound.centroidY());
        for (int i = 0; i < compound.parts(); i++) {
            Part part = compound.part(i);
            numbers(part.x(), part.y(), part.angle(), part.relativeDensity());
            shape(part.shape());
        }
    }

    private void capsule(Capsule capsule) {
        numbers(capsule.halfLength(), capsule.radius());
    }

    private void corners(Polygon polygon) {
        for (int i = 0; i < polygon.corners(); i++) {
            numbers(polygon.cornerX(i), polygon.cornerY(i));
        }
        if (polygon.radius() > 0) {
            numbers(polygon.radius());
        }
    }

    private void material(Material material) {
        numbers(material.density(), material.friction(), material.elasticity());
        numbers(material.rollingResistance(), material.surfaceSpeed(), material.drag());
    }

    private void motion(Motion motion) {
        numbers(motion.x(), motion.y(), motion.spin());
    }

    private void numbers(double... values) {
        for (double value : values) {
            bits(Double.doubleToLongBits(value));
        }
    }

    private void text(String words) {
        words.chars().forEach(this::bits);
        bits(words.length());
    }

    private void bits(long word) {
        for (int shift = 0; shift < Long.SIZE; shift += Byte.SIZE) {
            hash = (hash ^ (word >>> shift & 0xff)) * PRIME;
        }
    }
}
