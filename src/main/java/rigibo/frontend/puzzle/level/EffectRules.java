package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.Material;
import rigibo.frontend.document.Fault;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/**
 * E140: an effect is declared but not used, or used but not declared. A value that comes from a
 * substance counts as a use of a declared effect. But only a number that the file itself states
 * requires an effect, since a level of balls without rolling resistance is a valid choice.
 */
final class EffectRules {

    private static final String POINTER = "/world/effects";

    private final LevelSketch sketch;
    private final Effects declared;

    private EffectRules(LevelSketch sketch, Effects declared) {
        this.sketch = sketch;
        this.declared = declared;
    }

    static void check(LevelSketch sketch) {
        boolean isWhole = sketch.bodies().size() == sketch.json().node("/bodies").size();
        if (sketch.world().isPresent() && !sketch.balls().isEmpty() && isWhole) {
            new EffectRules(sketch, sketch.world().get().part().effects()).check();
        }
    }

    private void check() {
        gravity();
        water();
        stated("friction", Friction.class, Material::friction);
        stated("restitution", Restitution.class, Material::elasticity);
        stated("rollingResistance", RollingResistance.class, Material::rollingResistance);
        stated("surfaceSpeed", SurfaceSpeed.class, Material::surfaceSpeed);
        stated("drag", Drag.class, Material::drag);
        stated("spin", Rotation.class, material -> 1);
        if (declared.declares(Joints.class) && sketch.joints().isEmpty()) {
            unused("joints");
        }
        source("fan", Fan.class, body -> body.source().jet().isPresent());
        source("magnet", Magnet.class, body -> body.source().pole().isPresent());
        if (declared.declares(Thrust.class)) {
            unused("thrust");
        }
        if (!declared.declares(Contacts.class)) {
            undeclared("contacts", "the ball has to stay on the platform");
        }
    }

    private void source(String title, Class<? extends Effect> effect, Predicate<LevelBody> has) {
        Optional<Located<LevelBody>> user =
                sketch.bodies().stream().filter(body -> has.test(body.part())).findFirst();
        if (declared.declares(effect) && user.isEmpty()) {
            unused(title);
        }
        if (!declared.declares(effect) && user.isPresent()) {
            undeclared(title, user.get().pointer() + "/" + title + " is there");
        }
    }

    private void gravity() {
        JsonNode gravity = sketch.json().node("/world/gravity");
        boolean pulls = gravity.path(0).asDouble() != 0 || gravity.path(1).asDouble() != 0;
        if (declared.declares(Gravity.class) && !pulls) {
            unused("gravity");
        }
        if (!declared.declares(Gravity.class) && pulls) {
            undeclared("gravity", "/world/gravity is not zero");
        }
    }

    private void water() {
        boolean isThere = sketch.json().node("/world").has("water");
        boolean isDeclared = names("buoyancy");
        if (isDeclared && !isThere) {
            unused("buoyancy");
        }
        if (isThere && !isDeclared) {
            undeclared("buoyancy", "/world/water is there");
        }
    }

    /** Whether the file names an effect, which may lack its numbers and so not exist. */
    private boolean names(String title) {
        for (JsonNode named : sketch.json().node(POINTER)) {
            if (named.asString().equals(title)) {
                return true;
            }
        }
        return false;
    }

    private void stated(
            String member, Class<? extends Effect> effect, ToDoubleFunction<Material> amount) {
        String title = member.equals("spin") ? "rotation" : kebab(member);
        if (declared.declares(effect)) {
            if (materials().stream().allMatch(material -> amount.applyAsDouble(material) == 0)) {
                unused(title);
            }
            return;
        }
        for (String part : parts()) {
            if (sketch.json().node(part + "/" + member).asDouble(0) != 0) {
                undeclared(title, part + "/" + member + " is not zero");
                return;
            }
        }
    }

    private List<Material> materials() {
        List<Material> materials = new ArrayList<>();
        sketch.balls().forEach(ball -> materials.add(ball.part().substance().material()));
        sketch.platform().ifPresent(platform -> materials.add(Substance.PLANK.material()));
        sketch.bodies().forEach(body -> materials.add(body.part().material()));
        return materials;
    }

    private List<String> parts() {
        List<String> parts = new ArrayList<>();
        sketch.balls().forEach(ball -> parts.add(ball.pointer()));
        sketch.bodies().forEach(body -> parts.add(body.pointer()));
        return parts;
    }

    private static String kebab(String member) {
        return member.replaceAll("([A-Z])", "-$1").toLowerCase(Locale.ROOT);
    }

    private void unused(String title) {
        String words = "E140 the effect %s is declared, but nothing uses it";
        warn(Fault.of("E140.unused", words, title), title);
    }

    private void undeclared(String title, String use) {
        String words = "E140 the effect %s is not declared, but %s";
        warn(Fault.of("E140.missing", words, title, use), title);
    }

    private void warn(Fault fault, String title) {
        sketch.json().warning(POINTER, () -> fault.naming("@effect." + title));
    }
}
