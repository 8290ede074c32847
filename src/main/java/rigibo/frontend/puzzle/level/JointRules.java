package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Joints;
import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Suggestion;

import tools.jackson.databind.JsonNode;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Rules for joints: E102 an end names no body; E118 both ends are on one body, or on two that
 * forces do not move; E119 the effect {@code joints} is missing; E122 a rope is shorter than the
 * distance of its ends; E123 limits do not include the start; E124 the click does not fit the
 * joint; E125 it has no id to be clicked by.
 */
final class JointRules {

    /** Error that a rounded coordinate may cause in the length of a rope, m. */
    private static final double ROUNDED = 1e-3;

    private final LevelSketch sketch;

    /** The bodies that joints can name, and whether forces move them. */
    private final Map<String, Boolean> ends = new LinkedHashMap<>();

    private JointRules(LevelSketch sketch) {
        this.sketch = sketch;
        for (int i = 0; i < sketch.json().node("/bodies").size(); i++) {
            JsonNode body = sketch.json().node("/bodies/" + i);
            boolean moves = !body.has("path") && body.path("dynamic").asBoolean(true);
            ends.put(body.path("id").asString(""), moves);
        }
        ends.putIfAbsent(LevelJoint.PLATFORM, false);
        for (int i = 0; i <= sketch.json().node("/moreBalls").size(); i++) {
            ends.putIfAbsent(LevelJoint.ball(i), true);
        }
    }

    static void check(LevelSketch sketch) {
        new JointRules(sketch).check();
    }

    private void check() {
        boolean isDeclared =
                sketch.world().map(at -> at.part().effects().declares(Joints.class)).orElse(true);
        if (!isDeclared && !sketch.joints().isEmpty()) {
            String words = "E119 joints need the effect \"joints\" among /world/effects";
            tell(sketch.joints().get(0).pointer(), Fault.of("E119", words));
        }
        sketch.joints().forEach(this::check);
    }

    private void check(Located<LevelJoint> at) {
        LevelJoint joint = at.part();
        boolean areKnown = isKnown(at.pointer() + "/a", joint.a());
        areKnown &= isKnown(at.pointer() + "/b", joint.b());
        if (areKnown && joint.a().equals(joint.b())) {
            String words = "E118 joins \"%s\" with itself";
            tell(
                    at.pointer(),
                    Fault.of("E118.itself", words, joint.a()).naming(LevelJoint.shown(joint.a())));
        } else if (areKnown && !ends.get(joint.a()) && !ends.get(joint.b())) {
            tell(at.pointer(), Fault.of("E118", "E118 joins two bodies that forces do not move"));
        }
        if (joint.type() == LevelJoint.Type.ROPE && joint.length() < joint.span() - ROUNDED) {
            String words = "E122 a rope of %.3f m between ends that are %.3f m apart";
            Fault fault = Fault.of("E122", words, joint.length(), joint.span());
            tell(at.pointer() + "/length", fault);
        }
        limits(at);
        click(at);
    }

    /**
     * E124 and E125: a rope can be cut and a hinge pulled; solutions and replays name a joint by
     * its id.
     */
    private void click(Located<LevelJoint> at) {
        Optional<Verb> verb = at.part().verb();
        boolean isSwitch = at.part().handling().does(Verb.SWITCH);
        Handling.switching(sketch.json(), at.pointer(), isSwitch);
        if (isSwitch && !at.part().settings().motor().drives()) {
            String words = "E124 a click cannot switch a joint without a motor";
            tell(at.pointer(), Fault.of("E124.motor", words));
        }
        if (verb.isEmpty()) {
            return;
        }
        LevelJoint.Type type = at.part().type();
        if (!verb.get().actsOn(type)) {
            String words = "E124 a click cannot %s a %s";
            String kind = type.name().toLowerCase(Locale.ROOT);
            Fault fault = Fault.of("E124", words, verb.get().title(), kind);
            tell(at.pointer() + "/click", fault);
        }
        if (at.part().id().isEmpty()) {
            tell(at.pointer(), Fault.of("E125", "E125 what can be clicked needs an \"id\""));
        }
    }

    private boolean isKnown(String pointer, String end) {
        boolean isKnown = ends.containsKey(end);
        if (!isKnown) {
            String meant = Suggestion.among(ends.keySet(), end);
            tell(pointer, Fault.of("E102", "E102 nothing is called \"%s\"%s", end, meant));
        }
        return isKnown;
    }

    /** Hinges, slides and wheels begin at 0, distances at their first length. */
    private void limits(Located<LevelJoint> at) {
        JsonNode limits = sketch.json().node(at.pointer() + "/limits");
        if (!limits.isArray()) {
            return;
        }
        double lower = limits.path(0).asDouble();
        double upper = limits.path(1).asDouble();
        double start = at.part().type().hasTwoPoints() ? at.part().span() : 0;
        if (!(lower <= start && start <= upper)) {
            String words = "E123 begins at %s, outside of its limits %s to %s";
            tell(at.pointer() + "/limits", Fault.of("E123", words, start, lower, upper));
        }
    }

    private void tell(String pointer, Fault fault) {
        sketch.json().error(pointer, () -> fault);
    }

    /**
     * Pairs of joined ends, which never collide; each in both orders, with a blank between them.
     */
    static Set<String> pairs(List<Located<LevelJoint>> joints) {
        Set<String> pairs = new HashSet<>();
        for (Located<LevelJoint> at : joints) {
            pairs.add(at.part().a() + " " + at.part().b());
            pairs.add(at.part().b() + " " + at.part().a());
        }
        return pairs;
    }
}
