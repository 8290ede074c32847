package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Fault;

/**
 * E130: nothing can be clicked; E131: a body can be deleted that never moves and holds no joint.
 */
final class PieceRules {

    private PieceRules() {}

    static void check(LevelSketch sketch) {
        boolean hasUnread = sketch.bodies().size() < sketch.json().node("/bodies").size();
        hasUnread |= sketch.joints().size() < sketch.json().node("/joints").size();
        boolean hasClickable =
                sketch.bodies().stream().anyMatch(body -> body.part().verb().isPresent())
                        || sketch.joints().stream().anyMatch(at -> at.part().verb().isPresent());
        if (!hasClickable && !hasUnread && sketch.json().node("/bodies").isArray()) {
            String pointer = "/bodies";
            sketch.json().error(pointer, () -> Fault.of("E130", "E130 nothing can be clicked"));
        }
        for (Located<LevelBody> body : sketch.bodies()) {
            Handling.check(sketch.json(), body);
            boolean isStill = body.part().mobility() == LevelBody.Mobility.STATIC;
            if (body.part().deletable() && isStill && !holds(sketch, body.part().id())) {
                sketch.json()
                        .warning(
                                body.pointer(),
                                () ->
                                        Fault.of(
                                                "E131",
                                                "E131 body \"%s\" never moves but can be deleted",
                                                body.part().id()));
            }
        }
    }

    /** Whether a body holds a joint, which its deletion releases. */
    private static boolean holds(LevelSketch sketch, String id) {
        return sketch.joints().stream()
                .map(Located::part)
                .anyMatch(joint -> joint.a().equals(id) || joint.b().equals(id));
    }
}
