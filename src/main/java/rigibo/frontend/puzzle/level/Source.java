package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Magnet;
import rigibo.backend.geometry.Angle;

import tools.jackson.databind.JsonNode;

import java.util.Optional;

/**
 * A stream or a pull that comes from a body that stays where it is.
 *
 * @param jet the stream of a fan, from the body's centre
 * @param pole the pull of a magnet, towards the body's centre
 */
public record Source(Optional<Fan.Jet> jet, Optional<Magnet.Pole> pole) {

    /** The category of bodies that magnets pull. */
    public static final int IRON = 1 << 1;

    /** Default direction of a stream, relative to its body: up for a level body. */
    private static final double UPWARDS = 90;

    /** Reads the members of a body at a place of the world (m) and an angle (rad). */
    static Source of(JsonNode body, double x, double y, double angle) {
        JsonNode fan = body.path("fan");
        JsonNode magnet = body.path("magnet");
        return new Source(
                fan.isObject() ? Optional.of(jet(fan, x, y, angle)) : Optional.empty(),
                magnet.isObject() ? Optional.of(pole(magnet, x, y)) : Optional.empty());
    }

    private static Fan.Jet jet(JsonNode fan, double x, double y, double angle) {
        return new Fan.Jet(
                x,
                y,
                angle + Angle.ofDegrees(fan.path("angle").asDouble(UPWARDS)),
                fan.path("width").asDouble(),
                fan.path("reach").asDouble(),
                fan.path("force").asDouble());
    }

    private static Magnet.Pole pole(JsonNode magnet, double x, double y) {
        double strength = magnet.path("strength").asDouble();
        return new Magnet.Pole(x, y, strength, magnet.path("reach").asDouble(), IRON);
    }

    /** Whether the body has a stream or a pull. */
    public boolean isThere() {
        return jet.isPresent() || pole.isPresent();
    }
}
